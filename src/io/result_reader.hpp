#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace bumpfoil {

/// Why a file is no result that a report can show.
class NotAResult : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a report shows of result.nc: `kind`, `attributes`, `geometry`, `nodes`, `last_increment`, `loops`, see
/// report_json.
/// @param most_values  numbers per increment and node beyond which increments are left out
/// @throws netCDF::exceptions::NcException if it cannot be read; NotAResult if it is something else
nlohmann::ordered_json read_result(const std::filesystem::path& path, std::size_t most_values);

}  // namespace bumpfoil
