#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Names of the files in the folder of a run that store its steps during the run, and the last state.
std::vector<std::string> transient_checkpoint_names();

/// A run on disk: its table, and its start or point of resumption.
struct KeptRun {
  std::shared_ptr<StepTable> table;
  TransientRun run;
};

/// Starts storing a run in a folder, or resumes the one stored there.
/// @param resumes  resume if possible
/// @throws Error (input) if a different run is stored
/// @throws Error (file) if it cannot be read or written
KeptRun keep_run(const std::filesystem::path& folder, bool resumes, const Case& input, std::size_t width);

}  // namespace bumpfoil
