#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "case/csv_dialect.hpp"

namespace bumpfoil {

/// Splits the lines of a CSV file, and collects their errors.
class CsvRows {
 public:
  explicit CsvRows(std::string path) : path_(std::move(path)) {}

  /// The column names, in the first line that is not a comment, which also determines the separator.
  std::vector<std::string> read_header(std::string_view text);

  [[nodiscard]] bool has_header() const { return columns_ > 0; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] const CsvDialect& dialect() const { return dialect_; }

  /// The cells of a line, one per column; none and an error if their number is wrong.
  std::vector<std::string> read(std::size_t line, std::string_view text);

  void error(std::size_t line, std::string_view text, std::string what, std::string advice);

  /// Adds an error of the whole file.
  void error(std::string what, std::string advice);

  [[nodiscard]] bool has_errors() const { return !errors_.empty(); }

  /// @throws Error (input) if there are errors
  void throw_if_wrong();

 private:
  /// Lines whose number of cells differs from the header, reported once at the first.
  struct OddLines {
    std::size_t error{};  ///< index of this error
    std::size_t count{};
  };

  std::string path_;
  CsvDialect dialect_;
  std::size_t columns_{};
  std::vector<InputError> errors_;
  OddLines longer_;
  OddLines shorter_;
};

}  // namespace bumpfoil
