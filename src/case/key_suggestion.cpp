#include "case/key_suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bumpfoil/core/nearest_name.hpp"
#include "case/key_list.hpp"

namespace bumpfoil {
namespace {

/// More suggestions would not help.
constexpr std::size_t most_suggested = 5;
/// Shorter names are within one or two edits of too many others.
constexpr std::size_t shortest_slip = 5;

/// "bump", "foil" and "height" of "bump_foil.height".
std::vector<std::string> words_of(std::string_view path) {
  std::vector<std::string> words(1);
  for (const char c : without_counts(path)) {
    if (c == '.' || c == '_' || c == '-') {
      words.emplace_back();
    } else {
      words.back() += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return words;
}

/// The part after the last dot.
std::string name_in(const std::string& path) {
  return path.substr(path.rfind('.') + 1);
}

/// Whether the path contains these words in order, and both end with the same word.
bool ends_with_words(const std::string& path, const std::vector<std::string>& words) {
  const std::vector<std::string> all = words_of(path);
  if (all.back() != words.back()) return false;
  auto next = all.rbegin();
  for (auto word = words.rbegin(); word != words.rend(); ++word, ++next) {
    next = std::find(next, all.rend(), *word);
    if (next == all.rend()) return false;
  }
  return true;
}

std::ptrdiff_t depth_of(const std::string& path) {
  return std::count(path.begin(), path.end(), '.');
}

std::ptrdiff_t count_words(const std::string& path) {
  return std::ssize(words_of(path));
}

/// Of the matching paths, those with the smallest measure.
template <typename Matches, typename Measure>
std::vector<std::string> least(const std::vector<std::string>& paths, const Matches& matches, const Measure& measure) {
  std::vector<std::string> found;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(found), matches);
  const auto first = std::min_element(found.begin(), found.end(),
                                      [&](const auto& a, const auto& b) { return measure(a) < measure(b); });
  if (first == found.end()) return found;
  std::erase_if(found, [&, smallest = measure(*first)](const std::string& path) { return measure(path) > smallest; });
  return found;
}

}  // namespace

std::vector<std::string> key_paths() {
  std::vector<std::string> paths;
  for (const ListedKey& listed : list_keys({})) {
    if (!listed.is_table()) paths.push_back(listed.path);
  }
  return paths;
}

std::string first_key_of(const std::string& table) {
  for (const std::string& path : key_paths()) {
    if (path.starts_with(table + '.')) return path;
  }
  return table;
}

std::vector<std::string> keys_with_words(std::string_view name, const std::vector<std::string>& paths) {
  const std::vector<std::string> words = words_of(name);
  // An exact name precedes one with more words.
  std::vector<std::string> found = least(
      paths, [&](const std::string& path) { return words_of(name_in(path)) == words; }, depth_of);
  if (!found.empty()) return found;
  return least(
      paths, [&](const std::string& path) { return ends_with_words(path, words); }, count_words);
}

std::vector<std::string> keys_near(const std::string& name, const std::vector<std::string>& paths) {
  if (name.size() < shortest_slip) return {};
  std::vector<std::string> names;
  std::transform(paths.begin(), paths.end(), std::back_inserter(names), name_in);
  const auto nearest = nearest_name(name, names);
  if (!nearest) return {};
  return least(
      paths, [&](const std::string& path) { return name_in(path) == *nearest; }, depth_of);
}

std::string did_you_mean(const std::vector<std::string>& keys) {
  std::string text = "did you mean ";
  for (std::size_t i = 0; i < std::min(keys.size(), most_suggested); ++i) {
    const bool last = i + 1 == keys.size();
    text += fmt::format("{}\"{}\"", i == 0 ? "" : last ? " or " : ", ", keys[i]);
  }
  return text + (keys.size() > most_suggested ? ", ...?" : "?");
}

}  // namespace bumpfoil
