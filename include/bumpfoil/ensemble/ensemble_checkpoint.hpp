#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// The file in the folder of an ensemble that keeps its samples as they come.
inline constexpr const char* checkpoint_name = "ensemble.checkpoint";

/// What a run that was not finished left is neither replaced nor gone on with unasked.
/// @param advice  how to ask for either
/// @throws Error (file) if there is such a file
void require_no_checkpoint(const std::filesystem::path& checkpoint, const std::string& advice);

/// The log of a run that begins, or that goes on with what `checkpoint` holds.
/// @param width  numbers of a sample
/// @throws Error (input) if it is of another ensemble
/// @throws Error (file) if it cannot be read or written
RowLog open_ensemble_log(const std::filesystem::path& checkpoint, bool resumes, const Case& input, std::size_t width);

}  // namespace bumpfoil
