#include "results/netcdf_image.hpp"

#include <fmt/format.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

constexpr const char* fill_attribute = "_FillValue";
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

/// Maximum compression ratio of deflate, which compresses result files (https://zlib.net/zlib_tech.html): data larger
/// than this times the file were never in it.
constexpr std::size_t largest_deflation = 1032;

/// Size of a number in bytes; 0 for other types.
std::size_t size_of_type(int type) {
  switch (type) {
    case NC_BYTE:
      return sizeof(signed char);
    case NC_INT:
      return sizeof(int);
    case NC_FLOAT:
      return sizeof(float);
    case NC_DOUBLE:
      return sizeof(double);
    default:
      return 0;
  }
}

/// Whether `bytes_each` times all factors is at most `limit`.
bool fits(std::size_t bytes_each, const std::vector<std::size_t>& factors, std::size_t limit) {
  if (std::find(factors.begin(), factors.end(), 0U) != factors.end()) return true;
  for (const std::size_t factor : factors) {
    if (factor > limit / bytes_each) return false;
    bytes_each *= factor;
  }
  return bytes_each <= limit;
}

}  // namespace

bool StoredVariable::has_dims(const std::vector<std::string_view>& names) const {
  return std::equal(dims.begin(), dims.end(), names.begin(), names.end());
}

NetcdfImage::NetcdfImage(std::string bytes, std::string name) : bytes_(std::move(bytes)), name_(std::move(name)) {
  // netCDF would also try other formats, which results never have.
  if (!bytes_.starts_with(hdf5_signature)) refuse("", "is not a result: not a netCDF-4 file");
  check(nc_open_mem("result.nc", NC_NOWRITE, bytes_.size(), bytes_.data(), &id_));
  try {
    read_dimensions();
    read_texts();
    read_variables();
  } catch (...) {
    nc_close(id_);
    throw;
  }
}

NetcdfImage::~NetcdfImage() {
  nc_close(id_);
}

void NetcdfImage::refuse(std::string_view variable, std::string what) const {
  throw Error(ErrorKind::file, {{name_, 0, std::string(variable), "", std::move(what), ""}});
}

void NetcdfImage::check(int status, std::string_view variable) const {
  if (status != NC_NOERR) refuse(variable, fmt::format("cannot be read: {}", nc_strerror(status)));
}

void NetcdfImage::read_dimensions() {
  int count = 0;
  check(nc_inq_ndims(id_, &count));
  std::vector<int> ids(static_cast<std::size_t>(count));
  check(nc_inq_dimids(id_, &count, ids.data(), 0));
  for (const int dimension : ids) {
    std::array<char, NC_MAX_NAME + 1> name{};
    std::size_t size = 0;
    check(nc_inq_dim(id_, dimension, name.data(), &size));
    // Each has an uncompressed coordinate variable with at least four bytes per value.
    if (!fits(sizeof(int), {size}, bytes_.size())) {
      refuse(name.data(),
             fmt::format("is declared with {} values, more than a file of {} bytes can hold", size, bytes_.size()));
    }
    dimension_names_[dimension] = name.data();
    dimensions_[name.data()] = size;
  }
}

void NetcdfImage::read_texts() {
  int count = 0;
  check(nc_inq_natts(id_, &count));
  for (int i = 0; i < count; ++i) {
    std::array<char, NC_MAX_NAME + 1> name{};
    check(nc_inq_attname(id_, NC_GLOBAL, i, name.data()));
    std::optional<std::string> text = read_text(NC_GLOBAL, name.data());
    if (text) texts_[name.data()] = std::move(*text);
  }
}

std::optional<std::string> NetcdfImage::read_text(int variable, const char* name) const {
  int type = 0;
  std::size_t size = 0;
  const int status = nc_inq_att(id_, variable, name, &type, &size);
  if (status == NC_ENOTATT) return std::nullopt;
  check(status, name);
  if (type != NC_CHAR) return std::nullopt;
  if (size > bytes_.size()) refuse(name, "is declared longer than the whole file");
  std::string text(size, '\0');
  check(nc_get_att_text(id_, variable, name, text.data()), name);
  return text;
}

void NetcdfImage::read_variables() {
  int count = 0;
  check(nc_inq_nvars(id_, &count));
  std::vector<int> ids(static_cast<std::size_t>(count));
  check(nc_inq_varids(id_, &count, ids.data()));
  for (const int id : ids) {
    StoredVariable variable = read_variable(id);
    std::string name = variable.name;
    variables_.emplace(std::move(name), std::move(variable));
  }
}

StoredVariable NetcdfImage::read_variable(int id) const {
  StoredVariable variable;
  variable.id = id;
  std::array<char, NC_MAX_NAME + 1> name{};
  int rank = 0;
  check(nc_inq_varname(id_, id, name.data()));
  variable.name = name.data();
  check(nc_inq_vartype(id_, id, &variable.type), variable.name);
  if (size_of_type(variable.type) == 0) refuse(variable.name, "does not contain numbers of a type used in results");
  check(nc_inq_varndims(id_, id, &rank), variable.name);
  std::vector<int> dims(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(id_, id, dims.data()), variable.name);
  for (const int dimension : dims) {
    const auto found = dimension_names_.find(dimension);
    if (found == dimension_names_.end()) refuse(variable.name, "has a dimension that the file does not declare");
    variable.dims.push_back(found->second);
    variable.extents.push_back(dimensions_.at(found->second));
  }
  check_chunks(variable);
  variable.fill = read_fill(variable);
  variable.units = read_text(id, "units").value_or("");
  variable.long_name = read_text(id, "long_name").value_or("");
  variable.flag_meanings = read_text(id, "flag_meanings").value_or("");
  return variable;
}

void NetcdfImage::check_chunks(const StoredVariable& variable) const {
  int storage = 0;
  std::vector<std::size_t> chunk(variable.extents.size());
  check(nc_inq_var_chunking(id_, variable.id, &storage, chunk.data()), variable.name);
  // Reading one number of a chunk unpacks all of it.
  if (storage == NC_CHUNKED && !fits(size_of_type(variable.type), chunk, largest_deflation * bytes_.size())) {
    refuse(variable.name, fmt::format("is declared in chunks of {} numbers, more than a file of {} bytes can hold",
                                      fmt::join(chunk, " x "), bytes_.size()));
  }
}

std::optional<double> NetcdfImage::read_fill(const StoredVariable& variable) const {
  int type = 0;
  std::size_t size = 0;
  const int status = nc_inq_att(id_, variable.id, fill_attribute, &type, &size);
  if (status == NC_ENOTATT) return std::nullopt;
  check(status, variable.name);
  if (type != variable.type || size != 1) {
    refuse(variable.name, fmt::format("has {} values of {} in {}, expected one of its own type", size,
                                      type == variable.type ? "its type" : "another type", fill_attribute));
  }
  double fill = 0.0;
  // 32-bit integers are exact in binary64.
  check(nc_get_att_double(id_, variable.id, fill_attribute, &fill), variable.name);
  return fill;
}

const StoredVariable& NetcdfImage::variable(const std::string& name, const std::vector<std::string_view>& dims) const {
  const auto found = variables_.find(name);
  if (found == variables_.end()) refuse(name, "is missing");
  if (!found->second.has_dims(dims)) {
    refuse(name, fmt::format("has the dimensions ({}), expected ({})", fmt::join(found->second.dims, ", "),
                             fmt::join(dims, ", ")));
  }
  return found->second;
}

std::size_t NetcdfImage::size_of(const std::string& dimension) const {
  const auto found = dimensions_.find(dimension);
  if (found == dimensions_.end()) refuse(dimension, "is missing: it is a dimension of every result");
  return found->second;
}

std::vector<double> NetcdfImage::numbers(const StoredVariable& variable, const std::vector<std::size_t>& start,
                                         const std::vector<std::size_t>& count) const {
  // Flags are also expanded to numbers here; no file consists of flags alone.
  if (!fits(sizeof(double), count, largest_deflation * bytes_.size())) {
    refuse(variable.name, fmt::format("is declared with {} numbers in a loop, more than a file of {} bytes can hold",
                                      fmt::join(count, " x "), bytes_.size()));
  }
  std::vector<double> numbers(
      std::accumulate(count.begin(), count.end(), std::size_t{1}, std::multiplies<std::size_t>()));
  const int status = nc_get_vara_double(id_, variable.id, start.data(), count.data(), numbers.data());
  check(status, variable.name);
  for (double& number : numbers) {
    if (number == variable.fill || !std::isfinite(number)) number = std::numeric_limits<double>::quiet_NaN();
  }
  return numbers;
}

std::vector<double> NetcdfImage::numbers(const StoredVariable& variable) const {
  return numbers(variable, std::vector<std::size_t>(variable.extents.size()), variable.extents);
}

}  // namespace bumpfoil
