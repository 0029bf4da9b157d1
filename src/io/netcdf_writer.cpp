#include "io/netcdf_writer.hpp"

#include <netcdf_mem.h>

#include <cstdlib>
#include <memory>
#include <new>

namespace bumpfoil {
namespace {

/// An empty file of HDF5 1.8 whose root group keeps variables and attributes in the order in which they are added. The
/// files that nc_create_mem makes do not, and take no attributes beyond 64 kB.
std::string empty_hdf5() {
  constexpr std::size_t size = 239;
  using namespace std::string_literals;
  // Superblock: version 2, addresses and lengths of 8 bytes, end of the file, address of the root group, checksum.
  std::string bytes = "\x89HDF\r\n\x1a\n\x02\x08\x08\0"s + std::string(8, '\0') + std::string(8, '\xff') +
                      "\xef\0\0\0\0\0\0\0"s + "\x30\0\0\0\0\0\0\0"s + "\x94\x33\x45\x0f"s;
  // Object header of the root group: links by order, group info, and room that is filled by zeros; checksum.
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
  // The image is its own from here on. The name only has to be one.
  netCDF::ncCheck(nc_open_memio("result.nc", NC_NETCDF4 | NC_WRITE, &image, &id_), __FILE__, __LINE__);
}

std::string NewNetcdf::close() {
  NC_memio image{};
  netCDF::ncCheck(nc_close_memio(id_, &image), __FILE__, __LINE__);
  const std::unique_ptr<void, decltype(&std::free)> owned(image.memory, &std::free);
  return {static_cast<const char*>(image.memory), image.size};
}

}  // namespace bumpfoil
