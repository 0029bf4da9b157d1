#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/io/result_netcdf.hpp"
#include "bumpfoil/io/summary.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// How an ensemble is run, as the options of `bumpfoil montecarlo` say it.
struct EnsembleRequest {
  std::filesystem::path folder;
  std::optional<unsigned> threads;
  std::optional<double> target_error;
  std::vector<std::string> limits;
  bool resumes{};  ///< goes on where a run was interrupted, if there is one
  bool force{};
};

/// How it went.
struct EnsembleOutcome {
  RunStatus status{};
  std::vector<std::string> failures;  ///< a line each
};

/// Runs the ensemble of a case and writes it to its folder; one that is stopped, too.
/// @param unlocked  does what it is given while other threads may go on
/// @throws Error
EnsembleOutcome run_ensemble_to(const Case& input, const EnsembleRequest& request, const Provenance& provenance,
                                const std::function<void(const std::function<void()>&)>& unlocked,
                                const std::function<bool(double)>& progress);

}  // namespace bumpfoil
