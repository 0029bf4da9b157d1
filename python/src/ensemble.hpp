#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/ensemble_yield.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/row_log.hpp"

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

/// The ensemble of a case on its way to a folder.
class FolderEnsemble {
 public:
  /// Claims the folder. @throws Error
  FolderEnsemble(const Case& input, const EnsembleRequest& request, Provenance provenance);

  /// Runs the samples that are not there yet. @param progress  as that of EnsembleRun, with the part that is done
  void run(const std::function<bool(double)>& progress);

  /// Writes what there is, which may be part of it. netCDF is not thread-safe: to be called by one thread at a time.
  /// @return how it ended, and a line for each failure
  std::pair<RunStatus, std::vector<std::string>> publish();

 private:
  Case input_;
  EnsembleRequest request_;
  Provenance provenance_;
  bool resumes_;
  ResultFolder folder_;
  EnsembleLayout layout_;
  std::vector<EnsembleLimit> limits_;
  RowLog log_;
  bool finished_{};
};

}  // namespace bumpfoil
