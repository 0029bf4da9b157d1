#pragma once

#include <filesystem>
#include <netcdf>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/results/quantity.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {

/// A new netCDF-4 file, in memory or on the disk. Its variables take numbers that are not finite for absent; what is
/// absent or never put is the fill value of the variable. It throws what netCDF does.
class NewNetcdf {
 public:
  using Dims = std::vector<netCDF::NcDim>;

  /// In memory.
  NewNetcdf();
  /// On the disk, for what is too large for the memory. A disk that fills up meanwhile is the end of the program: see
  /// that there is room.
  explicit NewNetcdf(const std::filesystem::path& path);
  NewNetcdf(const NewNetcdf&) = delete;
  NewNetcdf& operator=(const NewNetcdf&) = delete;

  netCDF::NcDim add_dim(const std::string& name, std::size_t size) { return root_.addDim(name, size); }
  netCDF::NcDim add_unlimited_dim(const std::string& name) { return root_.addDim(name); }

  /// An attribute of the file; none where the text is empty, which is more than some readers expect.
  void add_text(const std::string& name, std::string_view text);

  /// A variable whose values come later. @param known  none will be absent
  netCDF::NcVar add(const VariableMeaning& meaning, const Dims& dims, bool known = false);

  /// Puts a block of a variable.
  static void put(const netCDF::NcVar& variable, const std::vector<std::size_t>& start,
                  const std::vector<std::size_t>& count, std::vector<double> values);

  /// Lays a variable out in compressed chunks of this shape, of which one is in memory at a time.
  void compress(const netCDF::NcVar& variable, std::vector<std::size_t> chunk);

  /// Closes one in memory. @return its bytes
  std::string close();

  /// Closes one on the disk.
  void close_file();

 private:
  // A file that could not be completed is left open: closing it after the memory has failed it crashes in HDF5.
  int id_{};
  std::optional<FileDescriptor> file_;
  netCDF::NcGroup root_;
};

}  // namespace bumpfoil
