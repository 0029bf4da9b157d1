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

/// A new netCDF-4 file, in memory or on disk. Its variables treat numbers that are not finite as absent; absent or
/// unwritten values are the fill value of the variable. It throws netCDF exceptions.
class NewNetcdf {
 public:
  using Dims = std::vector<netCDF::NcDim>;

  /// In memory.
  NewNetcdf();
  /// On disk, for data larger than memory. A full disk terminates the program: ensure that there is room.
  explicit NewNetcdf(const std::filesystem::path& path);
  NewNetcdf(const NewNetcdf&) = delete;
  NewNetcdf& operator=(const NewNetcdf&) = delete;

  netCDF::NcDim add_dim(const std::string& name, std::size_t size) { return root_.addDim(name, size); }
  netCDF::NcDim add_unlimited_dim(const std::string& name) { return root_.addDim(name); }

  /// A file attribute; none if the text is empty, which some readers do not expect.
  void add_text(const std::string& name, std::string_view text);

  /// A variable without values yet. @param known  none will be absent
  netCDF::NcVar add(const VariableMeaning& meaning, const Dims& dims, bool known = false);

  /// Writes a block of a variable.
  static void put(const netCDF::NcVar& variable, const std::vector<std::size_t>& start,
                  const std::vector<std::size_t>& count, std::vector<double> values);

  /// Stores a variable in compressed chunks of this shape, with one in memory at a time.
  void compress(const netCDF::NcVar& variable, std::vector<std::size_t> chunk);

  /// Closes a file in memory. @return its bytes
  std::string close();

  /// Closes a file on disk.
  void close_file();

 private:
  // An incomplete file is left open: closing it after an allocation failure crashes HDF5.
  int id_{};
  std::optional<FileDescriptor> file_;
  netCDF::NcGroup root_;
};

}  // namespace bumpfoil
