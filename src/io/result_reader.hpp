#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace bumpfoil {

/// Whether reports show the results of the command of this name.
bool is_shown(std::string_view command);

/// Whether these are cycles, increment by increment.
bool has_cycles(std::string_view command);

/// Whether these are numbers of many samples, of which distributions are shown; of all other commands they are numbers
/// over some dimensions.
bool has_distributions(std::string_view command);

/// Whether these are states of a running bearing, of which single bumps and feet are drawn.
bool has_states(std::string_view command);

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
