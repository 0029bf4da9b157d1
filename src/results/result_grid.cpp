#include "results/result_grid.hpp"

#include <map>

#include "results/netcdf_writer.hpp"

namespace bumpfoil {

void write_grid(NewNetcdf& file, const ResultGrid& grid) {
  std::map<std::string, netCDF::NcDim> dims;
  for (const GridDim& dim : grid.dims) dims.emplace(dim.name, file.add_dim(dim.name, dim.size));
  const auto dims_of = [&dims](const GridVariable& variable) {
    NewNetcdf::Dims all;
    all.reserve(variable.dims.size());
    for (const std::string& name : variable.dims) all.push_back(dims.at(name));
    return all;
  };
  for (const GridVariable& coordinate : grid.coordinates) {
    file.put_all(coordinate.meaning, dims_of(coordinate), coordinate.values);
  }
  for (const GridVariable& variable : grid.variables) {
    const NewNetcdf::Dims all = dims_of(variable);
    const netCDF::NcVar added = file.add(variable.meaning, all);
    if (!variable.coordinates.empty()) added.putAtt("coordinates", variable.coordinates);
    if (variable.compressed) added.setCompression(true, true, 1);
    std::vector<std::size_t> extents;
    extents.reserve(all.size());
    for (const netCDF::NcDim& dim : all) extents.push_back(dim.getSize());
    if (!variable.values.empty()) {
      NewNetcdf::put(added, std::vector<std::size_t>(all.size()), extents, variable.values);
    }
  }
}

}  // namespace bumpfoil
