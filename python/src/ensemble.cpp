#include "ensemble.hpp"

#include "bumpfoil/ensemble/ensemble_checkpoint.hpp"
#include "bumpfoil/ensemble/ensemble_files.hpp"
#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/ensemble/ensemble_table.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {
namespace {

std::filesystem::path checkpoint_of(const EnsembleRequest& request) {
  return request.folder / checkpoint_name;
}

RowLog open_log(const EnsembleRequest& request, bool resumes, const Case& input, std::size_t width) {
  const std::filesystem::path checkpoint = checkpoint_of(request);
  if (!request.force && !request.resumes) {
    require_no_checkpoint(checkpoint, "continue it with resume, restart with force, or use another folder");
  }
  return open_ensemble_log(checkpoint, resumes, input, width);
}

}  // namespace

FolderEnsemble::FolderEnsemble(const Case& input, const EnsembleRequest& request, Provenance provenance)
    : input_(input),
      request_(request),
      provenance_(std::move(provenance)),
      resumes_(request.resumes && RowLog::identity_of(checkpoint_of(request)).has_value()),
      folder_(request.folder, request.force || resumes_ ? Existing::replace : Existing::refuse, ensemble_file_names()),
      layout_(make_ensemble_layout(input)),
      limits_(parse_limits(request.limits, layout_)),
      log_(open_log(request, resumes_, input, layout_.width())) {}

void FolderEnsemble::run(const std::function<bool(double)>& progress) {
  const auto enough = [&] {
    return request_.target_error && relative_error_of_mean(layout_, log_) < *request_.target_error;
  };
  finished_ = run_ensemble(input_, layout_, log_,
                           {.threads = request_.threads.value_or(available_threads()),
                            .progress = [&](double done) { return progress(done / input_.montecarlo->samples); },
                            .enough = enough});
}

std::pair<RunStatus, std::vector<std::string>> FolderEnsemble::publish() {
  const EnsembleStatistics statistics = make_ensemble_statistics(input_, layout_, log_);
  const RunStatus status = status_of(statistics, !finished_);
  stage_ensemble(input_, layout_, log_, statistics, make_yields(limits_, layout_, log_), status, provenance_, folder_);
  folder_.publish();
  return {status, failure_lines(layout_, statistics)};
}

}  // namespace bumpfoil
