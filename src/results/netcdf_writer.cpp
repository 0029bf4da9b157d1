#include "results/netcdf_writer.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <hdf5.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <numeric>

namespace bumpfoil {
namespace {

using netCDF::NcType;
using netCDF::NcVar;
using Flag = signed char;

NcType type_of(const Form& form) {
  if (form.kind == Form::real) return netCDF::ncDouble;
  return form.kind == Form::whole ? NcType(netCDF::ncInt) : NcType(netCDF::ncByte);
}

/// Fill value of absent numbers: the netCDF default, written explicitly. All are exact in binary64.
double fill_of(const NcType& type) {
  if (type == netCDF::ncDouble) return NC_FILL_DOUBLE;
  return type == netCDF::ncInt ? NC_FILL_INT : NC_FILL_BYTE;
}

/// An object of HDF5, closed at the end of its scope.
class Hdf5Object {
 public:
  Hdf5Object(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Hdf5Object() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Object(const Hdf5Object&) = delete;
  Hdf5Object& operator=(const Hdf5Object&) = delete;

  [[nodiscard]] hid_t id() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// An empty HDF5 file whose root group keeps the order in which variables and attributes are added, and no times. Files
/// from nc_create_mem do not, and reject attributes beyond 64 kB.
std::string empty_hdf5() {
  const auto require = [](bool done) {
    if (!done) throw std::bad_alloc();
  };
  const Hdf5Object creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  constexpr unsigned in_order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
  require(H5Pset_link_creation_order(creation.id(), in_order) >= 0);
  require(H5Pset_attr_creation_order(creation.id(), in_order) >= 0);
  require(H5Pset_obj_track_times(creation.id(), false) >= 0);
  const Hdf5Object in_memory(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(in_memory.id(), 1024, false) >= 0);
  // The superblock of later versions has a checksum, which is wrong in images of open files.
  require(H5Pset_libver_bounds(in_memory.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18) >= 0);
  // HDF5 first tries to open and read a file of this name: there is none.
  const Hdf5Object file(H5Fcreate("/dev/null/result.nc", H5F_ACC_TRUNC, creation.id(), in_memory.id()), H5Fclose);
  require(H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0);
  const auto size = H5Fget_file_image(file.id(), nullptr, 0);
  require(size > 0);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file.id(), bytes.data(), bytes.size()) == size);
  return bytes;
}

}  // namespace

NewNetcdf::NewNetcdf() {
  const std::string empty = empty_hdf5();
  NC_memio image{empty.size(), std::malloc(empty.size()), 0};
  if (image.memory == nullptr) throw std::bad_alloc();
  std::copy(empty.begin(), empty.end(), static_cast<char*>(image.memory));
  // netCDF takes ownership of the image. Any name will do.
  netCDF::ncCheck(nc_open_memio("result.nc", NC_NETCDF4 | NC_WRITE, &image, &id_), __FILE__, __LINE__);
  root_ = netCDF::NcGroup(id_);
}

NewNetcdf::NewNetcdf(const std::filesystem::path& path)
    : file_(FileDescriptor(path, path, O_RDWR | O_CREAT | O_TRUNC)) {
  write_all(*file_, empty_hdf5(), path);
  // netCDF interprets paths (URLs, backslashes, leading blanks): this one is always plain.
  const std::string name = fmt::format("/proc/self/fd/{}", file_->get());
  netCDF::ncCheck(nc_open(name.c_str(), NC_NETCDF4 | NC_WRITE, &id_), __FILE__, __LINE__);
  root_ = netCDF::NcGroup(id_);
}

void NewNetcdf::add_text(const std::string& name, std::string_view text) {
  if (!text.empty()) root_.putAtt(name, std::string(text));
}

NcVar NewNetcdf::add(const VariableMeaning& meaning, const Dims& dims, bool known) {
  const NcVar variable = root_.addVar(meaning.name, type_of(meaning.form), dims);
  variable.putAtt("long_name", meaning.long_name);
  if (!meaning.unit.empty()) variable.putAtt("units", meaning.unit);
  if (!meaning.form.words.empty()) {
    std::vector<Flag> values(meaning.form.words.size());
    std::iota(values.begin(), values.end(), Flag{0});
    variable.putAtt("flag_values", netCDF::ncByte, values.size(), values.data());
    variable.putAtt("flag_meanings", fmt::format("{}", fmt::join(meaning.form.words, " ")));
  }
  if (known) return variable;
  const double fill = fill_of(variable.getType());
  switch (meaning.form.kind) {
    case Form::real:
      variable.setFill(true, fill);
      break;
    case Form::whole:
      variable.setFill(true, static_cast<int>(fill));
      break;
    case Form::truth:
    case Form::flag:
      variable.setFill(true, static_cast<Flag>(fill));
      break;
  }
  return variable;
}

void NewNetcdf::put(const NcVar& variable, const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
                    std::vector<double> values) {
  const double fill = fill_of(variable.getType());
  std::replace_if(
      values.begin(), values.end(), [](double value) { return !std::isfinite(value); }, fill);
  variable.putVar(start, count, values.data());
}

void NewNetcdf::compress(const NcVar& variable, std::vector<std::size_t> chunk) {
  variable.setChunking(NcVar::nc_CHUNKED, chunk);
  variable.setCompression(true, true, 1);
  // By default netCDF keeps 16 MB of every variable.
  const std::size_t bytes =
      std::accumulate(chunk.begin(), chunk.end(), variable.getType().getSize(), std::multiplies<>());
  constexpr std::size_t slots = 11;      // of the chunk hash table: a prime
  constexpr float written_first = 1.0F;  // evicts completely written chunks first
  netCDF::ncCheck(nc_set_var_chunk_cache(id_, variable.getId(), bytes, slots, written_first), __FILE__, __LINE__);
}

std::string NewNetcdf::close() {
  NC_memio image{};
  netCDF::ncCheck(nc_close_memio(id_, &image), __FILE__, __LINE__);
  const std::unique_ptr<void, decltype(&std::free)> owned(image.memory, &std::free);
  return {static_cast<const char*>(image.memory), image.size};
}

void NewNetcdf::close_file() {
  netCDF::ncCheck(nc_close(id_), __FILE__, __LINE__);
}

}  // namespace bumpfoil
