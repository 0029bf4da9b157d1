#pragma once

#include <netcdf.h>

#include <algorithm>
#include <netcdf>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Flags are numbers from 0 on.
using Flag = signed char;

/// How a number is stored, and what stands for one that is absent: the default of netCDF, said aloud.
template <typename Number>
struct Storage;
template <>
struct Storage<double> {
  static const netCDF::NcType& type() { return netCDF::ncDouble; }
  static constexpr double absent = NC_FILL_DOUBLE;
};
template <>
struct Storage<int> {
  static const netCDF::NcType& type() { return netCDF::ncInt; }
  static constexpr int absent = NC_FILL_INT;
};
template <>
struct Storage<Flag> {
  static const netCDF::NcType& type() { return netCDF::ncByte; }
  static constexpr Flag absent = NC_FILL_BYTE;
};

/// What readers are told about a variable.
struct Meaning {
  std::string name;
  std::string_view unit;  ///< empty for flags
  std::string long_name;
};

/// Adds a variable that is not yet written.
/// @param flag_meanings  of a variable of flags, in the order of their numbers; empty for others
template <typename Number>
netCDF::NcVar define_variable(const netCDF::NcGroup& file, const Meaning& meaning,
                              const std::vector<netCDF::NcDim>& dims, std::string_view flag_meanings) {
  const netCDF::NcVar variable = file.addVar(meaning.name, Storage<Number>::type(), dims);
  variable.putAtt("long_name", meaning.long_name);
  if (!meaning.unit.empty()) variable.putAtt("units", std::string(meaning.unit));
  if (!flag_meanings.empty()) {
    std::vector<Flag> values(1 + static_cast<std::size_t>(std::count(flag_meanings.begin(), flag_meanings.end(), ' ')));
    std::iota(values.begin(), values.end(), Flag{0});
    variable.putAtt("flag_values", netCDF::ncByte, values.size(), values.data());
    variable.putAtt("flag_meanings", std::string(flag_meanings));
  }
  return variable;
}

/// A new netCDF-4 file in memory. Where the memory does not suffice it throws netCDF's exceptions.
class NewNetcdf {
 public:
  NewNetcdf();
  NewNetcdf(const NewNetcdf&) = delete;
  NewNetcdf& operator=(const NewNetcdf&) = delete;

  [[nodiscard]] netCDF::NcGroup root() const { return netCDF::NcGroup(id_); }

  /// Closes it. @return its bytes
  std::string close();

 private:
  // A file that could not be completed is left open: closing it after the memory has failed it crashes in HDF5.
  int id_{};
};

}  // namespace bumpfoil
