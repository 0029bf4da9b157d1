#include "results/netcdf_writer.hpp"

#include <fcntl.h>
#include <fmt/ranges.h>
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

/// An empty HDF5 1.8 file whose root group keeps the order in which variables and attributes are added. Files from
/// nc_create_mem do not, and reject attributes beyond 64 kB.
std::string empty_hdf5() {
  constexpr std::size_t size = 239;
  using namespace std::string_literals;
  // Superblock: version 2, addresses and lengths of 8 bytes, end of the file, address of the root group, checksum.
  std::string bytes = "\x89HDF\r\n\x1a\n\x02\x08\x08\0"s + std::string(8, '\0') + std::string(8, '\xff') +
                      "\xef\0\0\0\0\0\0\0"s + "\x30\0\0\0\0\0\0\0"s + "\x94\x33\x45\x0f"s;
  // Object header of the root group: links by order, group info, and zero padding; checksum.
  bytes += "OHDR\x02\x0c\xb4\x02\x22\0\0\0\0\0\x03\0\0\0\0\0\0\0\0"s + std::string(24, '\xff') +
           "\x0a\x02\0\x01\0\0\0\0\0\x7e"s;
  bytes.resize(size - 4, '\0');
  return bytes + "\x63\x28\xac\x1c"s;
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
