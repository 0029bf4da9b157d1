#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace bumpfoil {

/// Contents of a report from result.nc, sweep.nc or ensemble.nc: `kind`, `attributes` and its cycles, distributions or
/// other numbers, see report_json. All declarations of the file are checked against its size and each other before use.
/// | @param bytes        of the file; verify its checksum first if there is one: see NetcdfImage
/// @param name         of the file in messages
/// @param most_values  count of numbers above which increments, or the largest variables, are omitted
/// @throws Error (file) naming file and variable if it is not a result, or damaged
nlohmann::ordered_json read_result(std::string bytes, const std::string& name, std::size_t most_values);

}  // namespace bumpfoil
