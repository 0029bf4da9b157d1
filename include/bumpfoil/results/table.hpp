#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/quantity.hpp"

/// Rows of a result: what a CSV file, a list of summary.json and a table on the terminal show.
namespace bumpfoil {

struct TableColumn {
  VariableMeaning meaning;
  std::vector<double> values{};      ///< one per row; not a number where absent
  std::vector<std::string> texts{};  ///< instead of these
};

struct Table {
  std::vector<TableColumn> columns;

  [[nodiscard]] std::size_t rows() const;
  void add(VariableMeaning meaning, std::vector<double> values);
  void add(VariableMeaning meaning, std::vector<std::string> texts);
  /// Erases the column of this key, if there is one.
  void erase(std::string_view key);
};

/// Meaning of a column that is shown to people and is in no file.
VariableMeaning shown_column(const std::string& label, const ShownUnit& shown = {});

/// Which part of a dataset makes a table.
struct TableView {
  std::vector<std::string> over{};     ///< dimensions; none: a single row
  std::vector<std::string> columns{};  ///< names of coordinates and variables over some of these dimensions
  /// Entries along the dimensions, one list per row; `no_entry` where a row has none. By default all combinations, with
  /// the last dimension fastest.
  std::optional<std::vector<std::vector<std::size_t>>> rows{};
};
inline constexpr std::size_t no_entry = static_cast<std::size_t>(-1);

/// Rows of the first entries of a dimension.
std::vector<std::vector<std::size_t>> first_rows(std::size_t count);

/// Reads a table off a dataset. A coordinate with names of its entries gives these.
Table table_of(const Dataset& dataset, const TableView& view);

/// The entries in memory of the first growing dimension: its coordinate, and the variables over it that are columns of
/// CSV files. @param first  number of the first entry
Table grown_table(const Dataset& dataset, std::size_t first);

/// A table that is a file of a result set.
struct TableFile {
  std::string name;  ///< "equilibrium.csv"
  Table table;
};

}  // namespace bumpfoil
