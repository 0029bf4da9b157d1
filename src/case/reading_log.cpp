#include "case/reading_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <tuple>

#include "case/toml_document.hpp"

namespace bumpfoil {
namespace {

/// Further errors are counted, not listed.
constexpr std::size_t most_errors = 50;

/// The parent of a key: "bump_foil.truss" for "bump_foil.truss.k1", "x" for "x[3]"; empty for a key of the root.
std::string holder_of(const std::string& key) {
  const std::size_t end = key.back() == ']' ? key.rfind('[') : key.rfind('.');
  return end == std::string::npos ? std::string() : key.substr(0, end);
}

/// The value as written, truncated for messages; empty for lists and tables.
std::string written(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (node.is_array() || node.is_table()) return {};
  std::ostringstream out;
  node.visit([&out](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) out << value;
  });
  return out.str();
}

}  // namespace

void ReadingLog::met(const std::string& key, const toml::node& node) {
  const toml::source_region& source = node.source();
  const bool implied = source.begin.line == 0;  // a table created by an override
  const bool overridden = implied || is_override(node);
  Origin origin{overridden ? std::string(command_line) : file_, overridden ? 0 : source.begin.line, written(node)};
  origin.implied = implied;
  origins_.insert_or_assign(key, std::move(origin));
}

const Origin* ReadingLog::place_of(const std::string& key) const {
  for (std::string holder = key; !holder.empty(); holder = holder_of(holder)) {
    if (const auto origin = origins_.find(holder); origin != origins_.end()) return &origin->second;
  }
  return nullptr;
}

void ReadingLog::error(const std::string& key, std::string what, std::string advice) {
  if (!wrong_.insert(key).second) return;  // already reported when read for another key
  const Origin* place = place_of(key);
  const auto exact = origins_.find(key);
  add({place != nullptr ? place->file : file_, place != nullptr ? place->line : 0, key,
       exact != origins_.end() ? exact->second.written : std::string(), std::move(what), std::move(advice)});
}

void ReadingLog::later_error(const InputError& error) {
  InputError placed = error;
  if (const auto other = taken_from_.find(error.key); other != taken_from_.end()) {
    placed.key = other->second;
    if (checked_.contains(placed.key)) return;
  }
  for (std::string holder = placed.key; !holder.empty(); holder = holder_of(holder)) {
    if (wrong_.contains(holder)) return;
  }
  checked_.insert(placed.key);
  const Origin* place = place_of(placed.key);
  if (place != nullptr && place->implied) place = nullptr;  // missing in the file, regardless of overrides
  placed.file = place != nullptr ? place->file : file_;
  placed.line = place != nullptr ? place->line : 0;
  const auto exact = origins_.find(placed.key);
  if (exact != origins_.end() && !exact->second.written.empty()) placed.value = exact->second.written;
  if (exact != origins_.end() && !exact->second.unit_hint.empty()) {
    placed.advice += "; " + fmt::format(fmt::runtime(exact->second.unit_hint), placed.value);
  }
  add(std::move(placed));
}

bool ReadingLog::is_sound_but_for(const std::string& table) const {
  return std::all_of(errors_.begin(), errors_.end(),
                     [&](const InputError& error) { return error.key.starts_with(table + '.'); });
}

bool ReadingLog::blames(const std::string& key) const {
  return std::any_of(errors_.begin(), errors_.end(),
                     [&](const InputError& error) { return error.key.starts_with(key); });
}

bool ReadingLog::full() const {
  return errors_.size() >= most_errors;
}

void ReadingLog::add(InputError error, ErrorKind kind) {
  input_error_ = input_error_ || kind == ErrorKind::input;
  if (full()) {
    ++unlisted_;
  } else {
    errors_.push_back(std::move(error));
  }
}

void ReadingLog::throw_if_wrong() {
  if (errors_.empty()) return;
  const auto place = [this](const InputError& error) {
    return std::tuple(error.file != file_, error.file, error.line);
  };
  std::stable_sort(errors_.begin(), errors_.end(),
                   [&place](const InputError& a, const InputError& b) { return place(a) < place(b); });
  if (unlisted_ > 0) {
    errors_.push_back({file_, 0, "", "", fmt::format("and {} more errors", unlisted_), "fix the first ones"});
  }
  throw Error(input_error_ ? ErrorKind::input : ErrorKind::file, std::move(errors_));
}

}  // namespace bumpfoil
