#include "experiments/vibration/loaded_foils.hpp"

#include "bumpfoil/experiments/build.hpp"
#include "experiments/cycle/cycle_series.hpp"

namespace bumpfoil {

LoadedFoils::LoadedFoils(const Case& input)
    : steps_(input.settings.get<VibrationSettings>().steps),
      stepper_(make_stepper(make_bearing_foils(input, {"vibration"}), input.solver)),
      reach_(stepper_.foils().clearance + stepper_.foils().rise) {}

StaticLoad LoadedFoils::go_to(const Eigen::Vector2d& load) {
  load_ = load;
  approach(stepper_, {.preload = PlaneTarget{Control::load, load}, .steps = steps_, .reach = reach_}, loaded_);
  StaticLoad out;
  out.load = load;
  out.status = loaded_.status;
  if (!loaded_.converged()) return out;
  out.position = loaded_.state.position;
  out.tangents = stepper_.tangents(loaded_.state);
  out.pad_forces = pad_forces(stepper_.foils(), loaded_.state.contacts.normal_force);
  return out;
}

Cycle LoadedFoils::vibrate(double direction, double amplitude, const ProgressCallback& progress) {
  const CycleCourse course{.direction = direction,
                           .amplitude = {Control::displacement, amplitude},
                           .preload = PlaneTarget{Control::load, load_},
                           .fully_reversed = true,
                           .steps = steps_,
                           .reach = reach_};
  Step step = loaded_;
  CycleSeries series(stepper_, course, step);
  return series.until_settled(most_vibration_loops, Recording::curve, progress);
}

}  // namespace bumpfoil
