#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace bumpfoil {

/// What a report shows of result.nc: `kind`, `attributes`, `geometry`, `nodes`, `last_increment`, `cycles`, see
/// report_json. Whatever the file declares is compared with its size and with the rest of it before it is used.
///
/// @param bytes        of the file; with a checksum, they are to be verified before: see NetcdfImage
/// @param name         of the file in messages
/// @param most_values  numbers per increment and node beyond which increments are left out
/// @throws Error (file) naming file and variable if it is no result or damaged
nlohmann::ordered_json read_result(std::string bytes, const std::string& name, std::size_t most_values);

}  // namespace bumpfoil
