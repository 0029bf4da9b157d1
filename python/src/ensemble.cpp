#include "ensemble.hpp"

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/ensemble_files.hpp"
#include "bumpfoil/io/ensemble_identity.hpp"
#include "bumpfoil/io/ensemble_table.hpp"
#include "bumpfoil/studies/ensemble_run.hpp"
#include "bumpfoil/studies/parallel_runs.hpp"

namespace bumpfoil {
namespace {

std::filesystem::path checkpoint_of(const EnsembleRequest& request) {
  return request.folder / "ensemble.checkpoint";
}

/// What a run that was not finished left is neither replaced nor gone on with unasked.
void require_no_checkpoint(const EnsembleRequest& request) {
  const std::filesystem::path checkpoint = checkpoint_of(request);
  if (request.force || request.resumes || !std::filesystem::exists(checkpoint)) return;
  throw Error(ErrorKind::file, {{checkpoint.string(), 0, "", "", "is of a run that was not finished",
                                 "go on with it by resume, begin anew by force, or give another folder"}});
}

/// The log of a run that begins, or that goes on.
EnsembleLog open_log(const EnsembleRequest& request, bool resumes, const Case& input, std::size_t width) {
  require_no_checkpoint(request);
  const std::filesystem::path path = checkpoint_of(request);
  if (!resumes) return {path, ensemble_identity(input), width};
  require_same_ensemble(*EnsembleLog::identity_of(path), input, path.string());
  return EnsembleLog::open(path, width);
}

}  // namespace

FolderEnsemble::FolderEnsemble(const Case& input, const EnsembleRequest& request, Provenance provenance)
    : input_(input),
      request_(request),
      provenance_(std::move(provenance)),
      resumes_(request.resumes && EnsembleLog::identity_of(checkpoint_of(request)).has_value()),
      folder_(request.folder, request.force || resumes_ ? Existing::replace : Existing::refuse, ensemble_file_names()),
      layout_(make_ensemble_layout(input)),
      limits_(parse_limits(request.limits, layout_)),
      log_(open_log(request, resumes_, input, layout_.width())) {}

void FolderEnsemble::run(const std::function<bool(double)>& progress) {
  const auto enough = [&] {
    return request_.target_error && relative_error_of_force(layout_, log_) < *request_.target_error;
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
