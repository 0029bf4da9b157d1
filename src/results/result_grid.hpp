#pragma once

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

class NewNetcdf;

struct GridDim {
  std::string name;
  std::size_t size{};
};

/// Numbers over some dimensions of a grid.
struct GridVariable {
  VariableMeaning meaning;
  std::vector<std::string> dims{};
  std::vector<double> values{};  ///< the last dimension runs fastest; not a number where absent; none: all absent
  std::string coordinates{};     ///< variables that say where its values lie, beside the dimensions
  std::string heading{};         ///< in tables of sweeps; empty where it is in the files only
  ShownUnit shown{"", 1.0};      ///< there
  bool compressed{};             ///< in its own netCDF file
};

/// What a result is, described once: its own netCDF file holds it over its dimensions, that of a sweep over the swept
/// keys as well.
struct ResultGrid {
  std::vector<GridDim> dims;
  std::vector<GridVariable> coordinates;  ///< of the dimensions: without absent values, and the same at all points
  std::vector<GridVariable> variables;
};

/// Adds dimensions and variables to a file.
void write_grid(NewNetcdf& file, const ResultGrid& grid);

/// Numbers from `first` on.
inline std::vector<double> numbers_from(double first, std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

}  // namespace bumpfoil
