#pragma once

#include <cstddef>
#include <filesystem>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The case of a stored sample, to be run again in full. The prescribed loading may differ from that of the ensemble;
/// the bearing itself may not. Where `command` is that of the ensemble and the case names no solver, the sample has
/// that of the ensemble.
/// @param file   an ensemble.nc, summary.json beside it   @param input  the case that the ensemble was drawn for
/// @param command  what is to be run of the sample
/// @throws Error (file) if it cannot be read, or has not the checksum that summary.json lists; Error (input) if it has
/// no such sample, or is of another bearing
Case read_sampled_case(const std::filesystem::path& file, std::size_t number, const Case& input,
                       std::string_view command);

}  // namespace bumpfoil
