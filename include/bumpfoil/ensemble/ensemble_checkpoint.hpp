#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// The file in the folder of an ensemble that keeps its samples as they come.
inline constexpr const char* checkpoint_name = "ensemble.checkpoint";

/// The samples of an unfinished run are neither replaced nor continued unless requested.
/// @param advice  how to ask for either
/// @throws Error (file) if there is such a file
void require_no_checkpoint(const std::filesystem::path& checkpoint, const std::string& advice);

/// The log of a new run, or of one that continues from `checkpoint`.
/// @param width  numbers of a sample
/// @throws Error (input) if it is of another ensemble
/// @throws Error (file) if it cannot be read or written
RowLog open_ensemble_log(const std::filesystem::path& checkpoint, bool resumes, const Case& input, std::size_t width);

}  // namespace bumpfoil
