#include "experiments/equilibrium/equilibrium_sampling.hpp"

#include <string>
#include <utility>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "experiments/run_sampling.hpp"

namespace bumpfoil {
namespace {

/// Requested values do not scatter.
std::vector<RunningQuantity> sampled_quantities(const Case& input) {
  std::vector<RunningQuantity> sampled =
      sampled_of(running_quantities(require_running_bearing(input), input.montecarlo->limits));
  const bool by_load = !input.settings.get<EquilibriumSettings>().loads.empty();
  std::erase_if(sampled, [by_load](const RunningQuantity& quantity) {
    return by_load ? quantity.name.starts_with("force_") : quantity.name == "x" || quantity.name == "y";
  });
  return sampled;
}

EnsembleLayout equilibrium_layout(const Case& input) {
  EnsembleLayout layout{
      .place = {"state", "1", "state of the running bearing, in the order of its path", whole_number},
      .plural = "states",
      .places = {},
      .columns = each(sampled_quantities(input),
                      [](const RunningQuantity& quantity) { return EnsembleColumn{.meaning = quantity.meaning()}; }),
      .target = "h_min",
      .load = "load on the crest of the bump"};
  const std::vector<RunningState> states =
      planned_states(input.settings.get<EquilibriumSettings>(), Status::not_reached);
  for (const RunningState& state : states) {
    layout.places.push_back({name_of_point(state.requested), static_cast<double>(layout.places.size() + 1)});
  }
  const auto add = [&](VariableMeaning meaning, const auto& value) {
    layout.coordinates.push_back(
        {std::move(meaning), each(states, [&](const RunningState& state) { return value(state.requested); })});
  };
  add({"speed", "rad/s", "speed of the journal, positive from X to Y"},
      [](const OperatingPoint& point) { return point.speed; });
  const bool by_load = states.front().requested.by_load();
  const std::string name = by_load ? "load_" : "position_";
  const char* const unit = by_load ? "N" : "m";
  const std::string what = by_load ? "load on the journal, " : "position of the journal, ";
  add({name + "x", unit, what + "X"}, [](const OperatingPoint& point) { return point.journal.x(); });
  add({name + "y", unit, what + "Y"}, [](const OperatingPoint& point) { return point.journal.y(); });
  return layout;
}

/// Values for the bumps of all strips of a split top foil together.
std::vector<double> of_all_strips(const BearingModel& bearing, const Vector& loads) {
  if (!bearing.film->has_slits()) return {loads.begin(), loads.end()};
  std::vector<double> sums;
  Eigen::Index first = 0;
  for (std::size_t k = 0; k < bearing.film->pads.size(); ++k) {
    const Eigen::Index bumps = bearing.film->pads[k].bumps();
    if (bearing.placed[k].strip == 0) sums.resize(sums.size() + static_cast<std::size_t>(bumps));
    Eigen::Map<Vector>(sums.data(), std::ssize(sums)).tail(bumps) += loads.segment(first, bumps);
    first += bumps;
  }
  return sums;
}

SampledPlace sampled_state(const std::vector<RunningQuantity>& quantities, const BearingModel& bearing,
                           const RunningState& state) {
  SampledPlace place{
      .values = each(quantities, [&](const RunningQuantity& quantity) { return value_of(quantity, bearing, state); })};
  if (state.found()) place.loads = of_all_strips(bearing, bump_loads(bearing, *state.last));
  return place;
}

}  // namespace

Sampling equilibrium_sampling() {
  const auto begin = [](const Case& input) -> SampleRun {
    return [quantities = sampled_quantities(input), limits = input.montecarlo->limits](
               const Case& sampled, const ProgressCallback& progress) {
      EquilibriumResult result = run_equilibrium(sampled, {}, progress);
      if (limits) add_film_limits(sampled, result, progress);
      return each(result.states,
                  [&](const RunningState& state) { return sampled_state(quantities, *result.bearing, state); });
    };
  };
  return {.layout = equilibrium_layout, .begin = begin};
}

}  // namespace bumpfoil
