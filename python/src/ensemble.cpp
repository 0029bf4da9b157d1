#include "ensemble.hpp"

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/ensemble_files.hpp"
#include "bumpfoil/io/ensemble_identity.hpp"
#include "bumpfoil/io/ensemble_log.hpp"
#include "bumpfoil/io/ensemble_table.hpp"
#include "bumpfoil/io/ensemble_yield.hpp"
#include "bumpfoil/studies/ensemble_run.hpp"
#include "bumpfoil/studies/parallel_runs.hpp"

namespace bumpfoil {
namespace {

EnsembleLog open_log(const std::filesystem::path& path, bool resumes, const Case& input, std::size_t width) {
  if (!resumes) return {path, ensemble_identity(input), width};
  require_same_ensemble(*EnsembleLog::identity_of(path), input, path.string());
  return EnsembleLog::open(path, width);
}

}  // namespace

EnsembleOutcome run_ensemble_to(const Case& input, const EnsembleRequest& request, const Provenance& provenance,
                                const std::function<void(const std::function<void()>&)>& unlocked,
                                const std::function<bool(double)>& progress) {
  const std::filesystem::path checkpoint = request.folder / "ensemble.checkpoint";
  const bool resumes = request.resumes && EnsembleLog::identity_of(checkpoint).has_value();
  ResultFolder folder(request.folder, request.force || resumes ? Existing::replace : Existing::refuse,
                      ensemble_file_names());
  if (!request.force && !request.resumes && std::filesystem::exists(checkpoint)) {
    throw Error(ErrorKind::file, {{checkpoint.string(), 0, "", "", "is of a run that was not finished",
                                   "go on with it by resume, begin anew by force, or give another folder"}});
  }
  const EnsembleLayout layout = make_ensemble_layout(input);
  const std::vector<EnsembleLimit> limits = parse_limits(request.limits, layout);
  EnsembleLog log = open_log(checkpoint, resumes, input, layout.width());
  bool finished = false;
  unlocked([&] {
    const auto enough = [&] {
      return request.target_error && relative_error_of_force(layout, log) < *request.target_error;
    };
    finished = run_ensemble(input, layout, log,
                            {.threads = request.threads.value_or(available_threads()),
                             .progress = [&](double done) { return progress(done / input.montecarlo->samples); },
                             .enough = enough});
  });
  const EnsembleStatistics statistics = make_ensemble_statistics(input, layout, log);
  const RunStatus status = status_of(statistics, !finished);
  stage_ensemble(input, layout, log, statistics, make_yields(limits, layout, log), status, provenance, folder);
  folder.publish();
  return {status, failure_lines(layout, statistics)};
}

}  // namespace bumpfoil
