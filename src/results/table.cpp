#include "bumpfoil/results/table.hpp"

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

const Variable& variable_named(const Dataset& dataset, const std::string& name) {
  for (const std::vector<Variable>* variables : {&dataset.coordinates, &dataset.variables}) {
    const auto found = std::find_if(variables->begin(), variables->end(),
                                    [&](const Variable& one) { return one.meaning.name == name; });
    if (found != variables->end()) return *found;
  }
  BUMPFOIL_ASSERT(false);
  return dataset.variables.front();
}

/// All combinations of entries.
std::vector<std::vector<std::size_t>> all_rows(const Dataset& dataset, const std::vector<std::string>& over) {
  std::vector<std::vector<std::size_t>> rows{{}};
  for (const std::string& dimension : over) {
    const std::size_t size = dataset.size_of(dimension);
    std::vector<std::vector<std::size_t>> longer;
    longer.reserve(rows.size() * size);
    for (const std::vector<std::size_t>& row : rows) {
      for (std::size_t entry = 0; entry < size; ++entry) {
        longer.push_back(row);
        longer.back().push_back(entry);
      }
    }
    rows = std::move(longer);
  }
  return rows;
}

/// Index of the value of a variable in each row; `no_entry` where it has none.
std::vector<std::size_t> places_in(const Dataset& dataset, const Variable& variable, const TableView& view,
                                   const std::vector<std::vector<std::size_t>>& rows) {
  std::vector<std::pair<std::size_t, std::size_t>> steps;  // place among the dimensions of rows, and size
  for (const std::string& dimension : variable.dims) {
    const auto at = std::find(view.over.begin(), view.over.end(), dimension);
    BUMPFOIL_ASSERT(at != view.over.end());
    steps.emplace_back(static_cast<std::size_t>(at - view.over.begin()), dataset.size_of(dimension));
  }
  return each(rows, [&steps](const std::vector<std::size_t>& row) {
    std::size_t place = 0;
    for (const auto& [along, size] : steps) {
      if (row[along] == no_entry) return no_entry;
      place = place * size + row[along];
    }
    return place;
  });
}

}  // namespace

std::size_t Table::rows() const {
  if (columns.empty()) return 0;
  return std::max(columns.front().values.size(), columns.front().texts.size());
}

void Table::add(VariableMeaning meaning, std::vector<double> values) {
  columns.push_back({.meaning = std::move(meaning), .values = std::move(values)});
}

void Table::add(VariableMeaning meaning, std::vector<std::string> texts) {
  columns.push_back({.meaning = std::move(meaning), .values = {}, .texts = std::move(texts)});
}

void Table::erase(std::string_view key) {
  std::erase_if(columns, [key](const TableColumn& column) { return column.meaning.key() == key; });
}

VariableMeaning shown_column(const std::string& label, const ShownUnit& shown) {
  return {label, "", "", {}, label, shown};
}

std::vector<std::vector<std::size_t>> first_rows(std::size_t count) {
  std::vector<std::vector<std::size_t>> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i] = {i};
  return rows;
}

Table table_of(const Dataset& dataset, const TableView& view) {
  const std::vector<std::vector<std::size_t>> rows = view.rows ? *view.rows : all_rows(dataset, view.over);
  Table table;
  for (const std::string& name : view.columns) {
    const Variable& variable = variable_named(dataset, name);
    const std::vector<std::size_t> places = places_in(dataset, variable, view, rows);
    if (!variable.names.empty()) {
      table.add(variable.meaning, each(places, [&variable](std::size_t place) {
                  return place == no_entry ? std::string() : variable.names[place];
                }));
      continue;
    }
    const std::vector<double> values = variable.values();
    table.add(variable.meaning,
              each(places, [&values](std::size_t place) { return place < values.size() ? values[place] : absent; }));
  }
  return table;
}

Table grown_table(const Dataset& dataset, std::size_t first) {
  const auto dim = std::find_if(dataset.dims.begin(), dataset.dims.end(), [](const auto& one) { return one.grows; });
  BUMPFOIL_ASSERT(dim != dataset.dims.end());
  std::vector<const Variable*> variables;
  for (const Variable& one : dataset.coordinates) {
    if (one.meaning.name == dim->name) variables.push_back(&one);
  }
  for (const Variable& one : dataset.variables) {
    if (one.dims == std::vector<std::string>{dim->name} && (one.meaning.tags & tag::csv) != 0) {
      variables.push_back(&one);
    }
  }
  Table table;
  std::size_t rows = 0;
  for (const Variable* variable : variables) {
    table.add(variable->meaning, variable->rows ? std::vector<double>() : variable->values());
    rows = std::max(rows, table.columns.back().values.size());
  }
  for (std::size_t k = 0; k < variables.size(); ++k) {
    std::vector<double>& values = table.columns[k].values;
    if (variables[k]->rows) values = variables[k]->rows(first, rows);
    values.resize(rows, absent);
  }
  return table;
}

}  // namespace bumpfoil
