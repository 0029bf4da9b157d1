#include "bumpfoil/experiments/cycle/sampled_cycles.hpp"

#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"

namespace bumpfoil {

CycleResult SampledCycleRunner::run(const Case& sampled, const ProgressCallback& progress) {
  SharedBearing foils = make_bearing_foils(sampled, {"cycle"});
  if (runner_ && settings_ == sampled.solver) {
    runner_->set_foils(std::move(foils));
  } else {
    settings_ = sampled.solver;
    runner_.emplace(std::move(foils), settings_);
  }
  CycleResult result{.solver = sampled.solver.chosen(), .experiment = Experiment::cycle, .cycles = {}};
  const CycleSettings& settings = sampled.settings.get<CycleSettings>();
  for (const double direction : settings.directions) {
    result.cycles.push_back(runner_->run(direction, settings, Recording::quantities, progress));
  }
  return result;
}

std::optional<CycleResult> run_sampled_cycles(const Case& sampled, const ProgressCallback& progress) {
  try {
    return SampledCycleRunner().run(sampled, progress);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
    return std::nullopt;
  }
}

}  // namespace bumpfoil
