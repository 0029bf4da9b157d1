#include "bumpfoil/experiments/unbalance/unbalance.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/motion/orbit.hpp"
#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/motion/rotor_equilibria.hpp"

namespace bumpfoil {
namespace {

/// Change of an orbit in a turn, over c, that counts as zero: friction lets journals creep for long, and time steps are
/// solved to 1e-6.
constexpr double orbit_tolerance = 1e-5;

/// Finds the orbits of a machine speed by speed, each from the previous one.
class OrbitFollower {
 public:
  OrbitFollower(MachineStepper& machine, RotorForces forces) : machine_(machine), forces_(std::move(forces)) {}

  /// @param linear  initial state at the speed, from the linear response
  Orbit find(const MachineState& linear, const OrbitOptions& options) {
    std::optional<Orbit> orbit;
    int spent = 0;
    if (const auto start = before_ ? moved_orbit(linear, before_->orbit, before_->linear) : std::nullopt) {
      orbit = find_orbit(machine_, forces_, *start, options);
    }
    if (!orbit || (orbit->status != Status::converged && orbit->status != Status::interrupted)) {
      if (orbit) spent = orbit->turns;
      orbit = find_orbit(machine_, forces_, linear, options);
      orbit->turns += spent;
    }
    before_.reset();
    if (orbit->status == Status::converged) before_ = Before{.linear = linear, .orbit = orbit->state};
    return *std::move(orbit);
  }

 private:
  struct Before {
    MachineState linear, orbit;
  };

  MachineStepper& machine_;
  RotorForces forces_;
  std::optional<Before> before_;
};

}  // namespace

UnbalanceResult unbalance_not_begun(const Case& input) {
  const UnbalanceSettings& settings = input.settings.get<UnbalanceSettings>();
  UnbalanceResult result{
      .machine = make_machine(input, settings.speeds, "unbalance"), .points = {}, .with_orbits = settings.orbits};
  for (const double speed : settings.speeds) {
    UnbalancePoint& point = result.points.emplace_back();
    point.speed = speed;
    point.status = Status::interrupted;
  }
  return result;
}

UnbalanceResult run_unbalance(const Case& input, const std::function<bool(double)>& progress) {
  UnbalanceResult result = unbalance_not_begun(input);
  const RotorSettings& settings = input.settings.get<RotorSettings>();
  const Rotor& rotor = result.machine.rotor;
  std::size_t done = 0;
  const auto goes_on = [&] {
    return !progress || progress(static_cast<double>(done) / static_cast<double>(result.points.size()));
  };
  std::deque<FilmStepper> steppers = result.machine.make_steppers(goes_on);
  const std::vector<FilmStepper*> pointers = pointers_to(steppers);
  MachineStepper machine(rotor, pointers);
  const RotorForces forces = forces_on(settings, rotor);
  const Eigen::VectorXd weight = forces(RotorInstant{});  // no unbalance force at rest
  const UnbalanceSettings& run = input.settings.get<UnbalanceSettings>();
  const RotorEquilibria equilibria(rotor, pointers, settings.gravity_vector());
  OrbitFollower follower(machine, forces);
  std::vector<BearingState> states;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    UnbalancePoint& point = result.points[i];
    if (i > 0 && result.points[i - 1].status != Status::converged) {
      point.status = result.points[i - 1].status == Status::interrupted ? Status::interrupted : Status::not_reached;
      continue;
    }
    done = i;
    if (!goes_on()) continue;
    point.status = equilibria.go_to(point.speed, states);
    if (point.status != Status::converged) continue;
    point.states = states;
    const std::vector<CarryingBearing> bearings = equilibria.carrying(states);
    const Eigen::VectorXcd force = unbalance_force(settings, rotor, point.speed);
    const std::complex<double> once(0.0, std::abs(point.speed));
    point.sliding = linear_response(rotor, bearings, force, once);
    point.stuck = linear_response(rotor, bearings, force, once, true);
    if (!run.orbits) continue;
    MachineState start = machine.at_rest(states, weight);
    if (point.stuck) add_motion(machine, *point.stuck, start);
    point.orbit = follower.find(
        start, {.steps_per_turn = run.steps_per_revolution, .tolerance = orbit_tolerance, .keep_going = goes_on});
    if (point.orbit->status == Status::interrupted) point.status = Status::interrupted;
  }
  return result;
}

}  // namespace bumpfoil
