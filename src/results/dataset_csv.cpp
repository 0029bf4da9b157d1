#include "results/dataset_csv.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "results/csv_value.hpp"

namespace bumpfoil {
namespace {

/// The coordinate comes first.
std::vector<const Variable*> csv_columns(const Dataset& dataset) {
  const auto dim = std::find_if(dataset.dims.begin(), dataset.dims.end(), [](const auto& one) { return one.grows; });
  BUMPFOIL_ASSERT(dim != dataset.dims.end());
  const std::vector<std::string> over{dim->name};
  std::vector<const Variable*> columns;
  for (const Variable& one : dataset.coordinates) {
    if (one.meaning.name == dim->name) columns.push_back(&one);
  }
  for (const Variable& one : dataset.variables) {
    if (one.dims == over && (one.meaning.tags & tag::csv) != 0) columns.push_back(&one);
  }
  return columns;
}

}  // namespace

std::string csv_header(const Dataset& dataset) {
  std::string out;
  for (const Variable* column : csv_columns(dataset)) {
    if (!out.empty()) out += ',';
    out += column->meaning.key();
  }
  return out;
}

std::size_t append_csv_rows(std::string& out, const Dataset& dataset, std::size_t first) {
  const std::vector<const Variable*> columns = csv_columns(dataset);
  std::size_t rows = 0;
  std::vector<std::vector<double>> values(columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k]->rows) continue;
    values[k] = columns[k]->values();
    rows = std::max(rows, values[k].size());
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k]->rows) values[k] = columns[k]->rows(first, rows);
    values[k].resize(rows, absent);
  }
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (k > 0) out += ',';
      append_csv(out, values[k][row], columns[k]->meaning.form);
    }
    out += '\n';
  }
  return rows;
}

}  // namespace bumpfoil
