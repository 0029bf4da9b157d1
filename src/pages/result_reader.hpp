#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace bumpfoil {

/// What a report shows of result.nc, sweep.nc or ensemble.nc: `kind`, `attributes` and what there is of cycles, of
/// distributions or of other numbers, see report_json. Whatever the file declares is compared with its size and with
/// the rest of it before it is used.
///
/// @param bytes        of the file; with a checksum, they are to be verified before: see NetcdfImage
/// @param name         of the file in messages
/// @param most_values  numbers beyond which increments, or the largest variables, are left out
/// @throws Error (file) naming file and variable if it is no result or damaged
nlohmann::ordered_json read_result(std::string bytes, const std::string& name, std::size_t most_values);

}  // namespace bumpfoil
