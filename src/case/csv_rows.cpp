#include "case/csv_rows.hpp"

#include <fmt/format.h>

#include <utility>

namespace bumpfoil {

std::vector<std::string> CsvRows::read_header(std::string_view text) {
  dialect_ = dialect_of(text);
  std::vector<std::string> names = dialect_.cells(text);
  columns_ = names.size();
  return names;
}

std::vector<std::string> CsvRows::read(std::size_t line, std::string_view text) {
  std::vector<std::string> cells = dialect_.cells(text, columns_);
  if (cells.size() == columns_) return cells;
  const bool longer = cells.size() > columns_;
  OddLines& odd = longer ? longer_ : shorter_;
  if (odd.count++ > 0) return {};
  odd.error = errors_.size();
  error(line, text,
        fmt::format("has {} column{}, separated by {}, and the header {}", cells.size(), cells.size() == 1 ? "" : "s",
                    dialect_.name, columns_),
        longer && dialect_.separator == ','
            ? "decimal commas in a comma-separated file? write numbers in quotes, or semicolons between columns"
            : "write a value for every column");
  return {};
}

void CsvRows::error(std::size_t line, std::string_view text, std::string what, std::string advice) {
  errors_.push_back({path_, line, "line", std::string(text), std::move(what), std::move(advice)});
}

void CsvRows::error(std::string what, std::string advice) {
  errors_.push_back({path_, 0, "", "", std::move(what), std::move(advice)});
}

void CsvRows::throw_if_wrong() {
  if (errors_.empty()) return;
  for (const OddLines& odd : {longer_, shorter_}) {
    if (odd.count < 2) continue;
    errors_[odd.error].what += fmt::format(" (as {} more line{})", odd.count - 1, odd.count == 2 ? "" : "s");
  }
  throw Error(ErrorKind::input, std::move(errors_));
}

}  // namespace bumpfoil
