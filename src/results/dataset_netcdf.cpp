#include "results/dataset_netcdf.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace bumpfoil {
namespace {

/// Numbers in a chunk of a compressed variable, a megabyte, unless its last dimension alone is longer. Variables
/// written in rows use half of it, as their last chunks all stay in memory.
constexpr std::size_t most_in_chunk = 131'072;
constexpr std::size_t most_in_chunk_of_rows = most_in_chunk / 2;

/// Entries of the first dimension in memory at a time, for a variable written in rows; also entries of a chunk along a
/// dimension of unknown size.
constexpr std::size_t entries_at_once = 10'000;

/// A chunk holds whole rows of the last dimensions, as many as fit. @param by_rows  written in rows
std::vector<std::size_t> chunk_of(const std::vector<std::size_t>& extents, bool by_rows) {
  std::vector<std::size_t> chunk(extents.size(), 1);
  std::size_t room = by_rows ? most_in_chunk_of_rows : most_in_chunk;
  for (std::size_t i = extents.size(); i-- > 0 && room > 0;) {
    const bool whole = i + 1 == extents.size() && !(by_rows && i == 0);
    chunk[i] = whole ? extents[i] : std::min(extents[i], room);
    if (chunk[i] < extents[i]) break;
    room /= std::max<std::size_t>(chunk[i], 1);
  }
  return chunk;
}

std::vector<std::size_t> extents_of(const Dataset& dataset, const Variable& variable) {
  return each(variable.dims, [&](const std::string& name) { return dataset.size_of(name); });
}

void put_all(const netCDF::NcVar& added, const Variable& variable, std::vector<std::size_t> extents) {
  std::vector<std::size_t> start(extents.size());
  if (!variable.rows) {
    std::vector<double> values = variable.values();
    if (!values.empty()) NewNetcdf::put(added, start, extents, std::move(values));
    return;
  }
  const std::size_t end = extents.front();
  for (std::size_t& first = start.front(); first < end; first += entries_at_once) {
    extents.front() = std::min(entries_at_once, end - first);
    NewNetcdf::put(added, start, extents, variable.rows(first, extents.front()));
  }
}

/// Whether it grows to an unknown size.
bool is_open(const Dataset& dataset, const Variable& variable) {
  return dataset.grows(variable) && dataset.size_of(variable.dims.front()) == 0;
}

}  // namespace

void DatasetNetcdf::add(const Dataset& dataset) {
  for (const auto& [name, text] : dataset.attributes) file_.add_text(name, text);
  for (const DataDimension& dim : dataset.dims) {
    if (dims_.contains(dim.name) || (dim.grows && dim.size == 0)) continue;
    dims_.emplace(dim.name, dim.grows ? file_.add_unlimited_dim(dim.name) : file_.add_dim(dim.name, dim.size));
  }
  for (const std::vector<Variable>* variables : {&dataset.coordinates, &dataset.variables}) {
    for (const Variable& variable : *variables) {
      if (!variables_.contains(variable.meaning.name) && !is_open(dataset, variable)) add(dataset, variable);
    }
  }
}

void DatasetNetcdf::add(const Dataset& dataset, const Variable& variable) {
  NewNetcdf::Dims dims;
  for (const std::string& name : variable.dims) {
    if (!dims_.contains(name)) dims_.emplace(name, file_.add_unlimited_dim(name));
    dims.push_back(dims_.at(name));
  }
  const netCDF::NcVar added = file_.add(variable.meaning, dims, variable.known);
  variables_.emplace(variable.meaning.name, added);
  for (const auto& [name, text] : variable.attributes) {
    if (!text.empty()) added.putAtt(name, text);
  }
  std::vector<std::size_t> extents = extents_of(dataset, variable);
  if (variable.compressed) {
    std::vector<std::size_t> shape = extents;
    if (is_open(dataset, variable)) shape.front() = entries_at_once;
    file_.compress(added, chunk_of(shape, dataset.grows(variable) || variable.rows));
  }
  if (!dataset.grows(variable)) put_all(added, variable, std::move(extents));
}

void DatasetNetcdf::append(const Dataset& dataset) {
  std::map<std::string, std::size_t> appended;
  for (const std::vector<Variable>* variables : {&dataset.coordinates, &dataset.variables}) {
    for (const Variable& variable : *variables) {
      if (!dataset.grows(variable)) continue;
      std::vector<double> values = variable.values();
      if (values.empty()) continue;
      if (!variables_.contains(variable.meaning.name)) add(dataset, variable);
      const std::string& along = variable.dims.front();
      std::vector<std::size_t> start(variable.dims.size());
      start.front() = written_[along];
      std::vector<std::size_t> extents = extents_of(dataset, variable);
      const std::size_t each_entry =
          std::accumulate(extents.begin() + 1, extents.end(), std::size_t{1}, std::multiplies<>());
      if (each_entry == 0) continue;
      extents.front() = values.size() / each_entry;
      appended[along] = std::max(appended[along], extents.front());
      NewNetcdf::put(variables_.at(variable.meaning.name), start, extents, std::move(values));
    }
  }
  for (const auto& [name, entries] : appended) written_[name] += entries;
}

}  // namespace bumpfoil
