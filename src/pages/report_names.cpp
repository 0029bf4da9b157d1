#include "pages/report_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

fs::path last_parts(const fs::path& path, std::ptrdiff_t count) {
  const fs::path parts = path.relative_path();
  fs::path last;
  for (auto part = std::prev(parts.end(), std::min(count, std::distance(parts.begin(), parts.end())));
       part != parts.end(); ++part) {
    last /= *part;
  }
  return last;
}

/// Removes a trailing slash.
fs::path normal(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  std::vector<fs::path> paths;
  std::transform(folders.begin(), folders.end(), std::back_inserter(paths), normal);
  const std::set<fs::path> different(paths.begin(), paths.end());
  const auto tell_apart = [&different](std::ptrdiff_t parts) {
    std::set<fs::path> seen;
    for (const fs::path& path : different) seen.insert(last_parts(path, parts));
    return seen.size() == different.size();
  };
  std::ptrdiff_t parts = 1;
  while (!tell_apart(parts)) ++parts;
  std::map<fs::path, int> numbers;
  std::vector<std::string> names;
  for (const fs::path& path : paths) {
    const std::string name = last_parts(path, parts).string();
    const bool alone = std::count(paths.begin(), paths.end(), path) == 1;
    names.push_back(alone ? name : fmt::format("{} ({})", name, ++numbers[path]));
  }
  return names;
}

std::string without_machine_paths(std::string_view command) {
  std::string out;
  char quote = '\0';
  char before = ' ';
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char letter = command[i];
    const bool begins = before == ' ' || before == '=' || before == '\'' || before == '"';
    if (letter == '/' && begins) {
      const std::string ends{'"', quote == '\0' ? ' ' : quote};
      const std::size_t end = std::min(command.find_first_of(ends, i), command.size());
      i = std::min(command.rfind('/', end - 1), end - 1);
      before = letter;
      continue;
    }
    if (quote == '\0' && (letter == '\'' || letter == '"')) {
      quote = letter;
    } else if (letter == quote) {
      quote = '\0';
    }
    out += letter;
    before = letter;
  }
  return out;
}

}  // namespace bumpfoil
