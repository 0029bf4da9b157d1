#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/running_program.hpp"

namespace bumpfoil {

/// A small ensemble.
class MonteCarloProgram : public Program {
 protected:
  [[nodiscard]] std::vector<std::string> montecarlo(const std::string& folder, int samples) const {
    return {"montecarlo", case_path_,
            "-o",         (folder_.path() / folder).string(),
            "--samples",  std::to_string(samples),
            "--set",      "cycle.steps=4",
            "--set",      "cycle.directions=[\"+X\", \"-X\"]",
            "--set",      "montecarlo.bump_height.std=10 um",
            "--set",      "montecarlo.bump_foil_thickness.std=1 um"};
  }
  [[nodiscard]] json summary_of(const std::string& folder) const {
    return json::parse(folder_.read(folder + "/summary.json"));
  }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(folder_.path() / name); }
};

}  // namespace bumpfoil
