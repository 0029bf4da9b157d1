#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Names of the files in the folder of a run that keep its steps as they come, and the state of the last one.
std::vector<std::string> transient_checkpoint_names();

/// A run on the disk: its table, and how it begins or goes on.
struct KeptRun {
  std::shared_ptr<StepTable> table;
  TransientRun run;
};

/// Begins to keep a run in a folder, or goes on with what is kept there.
/// @param resumes  goes on, where there is anything
/// @throws Error (input) if what is kept is of another run
/// @throws Error (file) if it cannot be read or written
KeptRun keep_run(const std::filesystem::path& folder, bool resumes, const Case& input, std::size_t width);

}  // namespace bumpfoil
