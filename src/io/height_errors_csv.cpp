#include "io/height_errors_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>

#include "bumpfoil/model/validation.hpp"
#include "io/csv_lines.hpp"
#include "io/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view first_column = "bump";
constexpr std::string_view second_column = "height_error_m";

bool is_header(std::string_view text) {
  const auto columns = two_columns(text);
  return columns && columns->first == first_column && columns->second == second_column;
}

/// Takes the lines one by one.
class HeightErrorsReader {
 public:
  HeightErrorsReader(const std::string& path, int bumps)
      : path_(path), errors_(static_cast<std::size_t>(bumps)), lines_(errors_.size(), 0) {}

  void read_line(std::size_t line, std::string_view text) {
    const auto columns = two_columns(text);
    if (!columns) {
      return fault(line, text, "does not have two columns", "write bump and height error, such as 3,-4.2e-6");
    }
    const auto bump = parse<int>(columns->first);
    const auto error = parse<double>(columns->second);
    if (!bump || *bump < 1 || *bump > static_cast<int>(errors_.size())) {
      return fault(line, text, "does not begin with the number of a bump",
                   fmt::format("count bumps from 1 to {}", errors_.size()));
    }
    if (!error || !std::isfinite(*error)) {
      return fault(line, text, "has no finite number for the height error", "give it in m, without a unit");
    }
    const auto index = static_cast<std::size_t>(*bump - 1);
    if (lines_[index] > 0) {
      return fault(line, text, fmt::format("repeats bump {}, given in line {}", *bump, lines_[index]),
                   "give every bump once");
    }
    lines_[index] = line;
    errors_[index] = *error;
  }

  void fault(std::size_t line, std::string_view text, std::string what, std::string advice) {
    faults_.push_back({path_, line, "line", std::string(text), std::move(what), std::move(advice)});
  }

  /// @throws Error (input) if there was a fault or a bump is missing.
  std::vector<double> finish() {
    const bool all_read = faults_.empty();  // a line that could not be read may be the one that is missing
    for (std::size_t i = 0; all_read && i < lines_.size(); ++i) {
      if (lines_[i] == 0) {
        faults_.push_back({path_, 0, "", "", fmt::format("lacks bump {}", i + 1),
                           fmt::format("give one line for each of {} bumps", lines_.size())});
      }
    }
    if (!faults_.empty()) throw Error(ErrorKind::input, std::move(faults_));
    return std::move(errors_);
  }

 private:
  std::string path_;
  std::vector<double> errors_;
  std::vector<std::size_t> lines_;  ///< where each bump was given; 0 if it was not
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<double> read_height_errors(const std::string& path, int bumps) {
  const std::string text = read_text_file(path);
  if (is_blank(text)) {
    throw Error(ErrorKind::input,
                {{path, 0, "", "", "is empty",
                  fmt::format("write {},{} and one line for each of {} bumps", first_column, second_column, bumps)}});
  }
  HeightErrorsReader reader(path, bumps);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) {
    if (line > 1) {
      if (!content.empty()) reader.read_line(line, content);
    } else if (!is_header(content)) {
      reader.fault(line, content, "is no header of height errors",
                   fmt::format("write {},{}", first_column, second_column));
    }
  });
  return reader.finish();
}

}  // namespace bumpfoil
