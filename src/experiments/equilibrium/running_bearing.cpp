#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"
#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"

namespace bumpfoil {
namespace {

/// Minimum film thicknesses with a larger relative difference belong to different states.
constexpr double tolerated_difference = 0.02;

/// Checks states on all cores during the walk, and adds the mesh error. States are independent of each other and of the
/// thread.
class ParallelCheckers : public StateCheckers {
 public:
  ParallelCheckers(const Case& input, tbb::task_group& group) : input_(input), group_(group) {}

  void take(const SharedBearing& bearing, RunningState& state, const std::function<void()>& check) override {
    if (!meshes_) meshes_.emplace(input_, bearing);
    group_.run([this, &state, check] {
      check();
      add_mesh_error(state);
    });
  }

  void finish() override { group_.wait(); }

  void add_mesh_error(RunningState& state) const {
    if (state.found()) state.mesh_error = meshes_->estimate(state);
  }

 private:
  const Case& input_;
  std::optional<MeshComparison> meshes_;
  tbb::task_group& group_;
};

double minimum_film_thickness(const EquilibriumResult& result, const RunningState& state) {
  return state.last->film.thickness.minCoeff() * result.bearing->film->scales.thickness;
}

/// States of `result` for which another path reaches a different film.
std::vector<OtherBranch> other_branches(const EquilibriumResult& result, const EquilibriumResult& second) {
  std::vector<OtherBranch> found;
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    const RunningState& state = result.states[i];
    const auto other = std::find_if(second.states.begin(), second.states.end(),
                                    [&](const RunningState& one) { return one.requested == state.requested; });
    if (!state.found() || other == second.states.end() || !other->found()) continue;
    const double h = minimum_film_thickness(result, state);
    const double h_other = minimum_film_thickness(second, *other);
    if (std::abs(h_other - h) > tolerated_difference * h) found.push_back({i, other->path, h_other});
  }
  return found;
}

}  // namespace

FilmPath second_path(const EquilibriumSettings& equilibrium) {
  const bool by_load = !equilibrium.loads.empty();
  const FilmPath gradual = by_load ? FilmPath::load_ramp : FilmPath::position_ray;
  if (equilibrium.path == gradual) return FilmPath::speed_ramp;
  return by_load || equilibrium.path == FilmPath::speed_ramp ? gradual : FilmPath::speed_ramp;
}

EquilibriumResult analyse_running_bearing(const Case& input, const std::function<bool(double)>& progress) {
  const EquilibriumSettings& settings = input.settings.get<EquilibriumSettings>();
  const bool all = settings.paths == ComparedPaths::all;
  const bool second = settings.paths == ComparedPaths::two;
  const double parts = 1.0 + (second ? 1.0 : 0.0) + (settings.limits ? 1.0 : 0.0);
  double done = 0.0;
  const auto part_progress = [&](double fraction) { return !progress || progress((done + fraction) / parts); };

  tbb::task_group group;
  ParallelCheckers checkers(input, group);
  EquilibriumResult result =
      run_equilibrium(input, all ? possible_paths(settings) : std::vector<FilmPath>{}, part_progress, &checkers);
  for (RunningState& state : result.states) {
    if (state.instead_of_unstable) checkers.add_mesh_error(state);
  }
  if (second) {
    done += 1.0;
    NoCheckers none;
    const EquilibriumResult other =
        find_states(result.bearing, settings, thickness_floor(input), {second_path(settings)}, part_progress, &none);
    result.other_branches = other_branches(result, other);
  }
  if (settings.limits) {
    done += 1.0;
    add_film_limits(input, result, part_progress);
  }
  return result;
}

}  // namespace bumpfoil
