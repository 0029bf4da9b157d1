#include "bumpfoil/experiments/path/path.hpp"

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "bearing/settling.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/motion/march.hpp"
#include "experiments/cycle/increment_log.hpp"
#include "experiments/cycle/orbit_energy.hpp"

namespace bumpfoil {
namespace {

Program orbit_program(const PathSettings& path) {
  const double turn = (path.sense == Sense::counterclockwise ? 2.0 : -2.0) * std::numbers::pi;
  const Eigen::Rotation2Dd tilt(path.tilt);
  const auto point = [&](int step) -> Eigen::Vector2d {
    const double t = turn * (step % path.steps) / path.steps;
    return path.centre.value +
           tilt * Eigen::Vector2d(path.semi_axes.value.x() * std::cos(t), path.semi_axes.value.y() * std::sin(t));
  };
  Program program;
  if (!point(0).isZero(0.0))
    program.push_back(straight_leg(path.control(), Eigen::Vector2d::Zero(), point(0), path.steps));
  for (int k = 1; k <= path.orbits * path.steps; ++k)
    program.push_back(straight_leg(path.control(), point(k - 1), point(k), 1));
  return program;
}

/// Unit vector from the centre of the bearing towards the journal.
Eigen::Vector2d outward(const Eigen::Vector2d& position) {
  const double distance = position.norm();
  return distance > 0.0 ? Eigen::Vector2d(position / distance) : Eigen::Vector2d::UnitX();
}

/// A length below this part of the rise is a rounding.
constexpr double length_rounding = 1e-12;

/// Finds the orbits among the increments that pass.
class OrbitCounter {
 public:
  OrbitCounter(const PathSettings& path, int increments, const Foils& foils)
      : steps_(path.is_orbit() ? path.steps : 0),
        lead_in_(increments - 1 - path.orbits * steps_),
        force_rounding_(foils.roundings.force),
        length_rounding_(length_rounding * foils.rise) {}

  [[nodiscard]] int orbit_of(int increment) const {
    return steps_ > 0 && increment > lead_in_ ? (increment - lead_in_ - 1) / steps_ + 1 : 0;
  }

  /// @return what the orbit took, if one ends here
  std::optional<OrbitLoop> pass(const Increment& increment) {
    if (steps_ == 0 || increment.index < lead_in_) return std::nullopt;
    points_.push_back({{increment.x, increment.y}, {increment.force_x, increment.force_y}});
    if ((increment.index - lead_in_) % steps_ != 0) return std::nullopt;
    const Increment begin = std::exchange(begin_, increment);
    if (increment.index == lead_in_) return std::nullopt;
    const double energy =
        orbit_energy(increment.work - begin.work, increment.dissipated_energy - begin.dissipated_energy,
                     std::span(points_).first(points_.size() - 1));
    points_.erase(points_.begin(), points_.end() - 1);
    const double force = std::hypot(increment.force_x - begin.force_x, increment.force_y - begin.force_y);
    const double distance = std::hypot(increment.x - begin.x, increment.y - begin.y);
    return OrbitLoop{.energy = energy,
                     .force_defect = cleared(force, force_rounding_),
                     .position_defect = cleared(distance, length_rounding_)};
  }

 private:
  int steps_;
  int lead_in_;  ///< number of the last increment before the first orbit
  double force_rounding_;
  double length_rounding_;
  Increment begin_;
  std::vector<OrbitPoint> points_;  ///< of the orbit that goes on
};

/// Takes the foils along the path.
Cycle follow(FoilStepper& stepper, const PathSettings& path, double reach, const ProgressCallback& progress) {
  const Program program = path_program(path);
  Cycle cycle;
  cycle.due = increments_of(program);
  IncrementLog log(stepper, Recording::everything, cycle);
  CycleQuantities quantities(cycle);
  OrbitCounter orbits(path, cycle.due, stepper.foils());

  Step step;
  const auto add = [&](bool judged) {
    const Eigen::Vector2d& position = step.state.position;
    const Eigen::Vector2d direction = outward(position);
    Increment next = log.make(step, Branch::loading, direction, position.norm(), true);
    next.orbit = orbits.orbit_of(next.index);
    if (next.converged()) next.tangents = stepper.tangents(step.state);
    log.write_down(step, next, direction);
    quantities.add(next, judged && step.converged(), false);
    if (!next.converged()) return false;
    if (const auto loop = orbits.pass(next)) {
      cycle.orbits.push_back(*loop);
      cycle.loop_energies.push_back(loop->energy);
      cycle.settled = is_settled(cycle.loop_energies);
    }
    return !progress || progress(static_cast<double>(next.index + 1) / cycle.due) || next.index + 1 == cycle.due;
  };

  stepper.assemble({}, step);
  cycle.assembly_dissipation = step.state.dissipated_energy;
  step.state.work = step.state.dissipated_energy = 0.0;
  BearingState state = step.state;
  bool goes_on = add(true);
  if (step.converged()) {
    cycle.initial_journal_load = interface_loads(stepper.foils(), step.state.contacts, Interface::journal_top).sum();
  }
  if (goes_on) {
    goes_on = march(stepper, program, reach, state, step,
                    [&](const Passage& at) { return add(at.ends_leg) ? Verdict::go_on : Verdict::refuse; });
  }
  if (!goes_on && cycle.converged()) cycle.status = Status::interrupted;
  log.finish();
  quantities.finish();
  return cycle;
}

}  // namespace

Program path_program(const PathSettings& path) {
  if (path.is_orbit()) return orbit_program(path);
  Program program;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : path.points.values) {
    const bool is_assembly = &point == &path.points.values.front() && point.isZero(0.0);
    if (!is_assembly) program.push_back(straight_leg(path.control(), from, point, 1));
    from = point;
  }
  return program;
}

CycleResult run_path(const Case& input, const ProgressCallback& progress) {
  const SharedFoils foils = make_bearing_foils(input, {"path"});
  const PathSettings* const path = input.settings.find<PathSettings>();
  if (path == nullptr) throw Error(ErrorKind::input, {{"", 0, "path", "", "this table is missing", "add [path]"}});
  const auto begin = std::chrono::steady_clock::now();
  FoilStepper stepper = make_stepper(foils, input.solver);
  CycleResult result{.solver = input.solver.chosen(), .experiment = Experiment::path, .due = 1, .cycles = {}};
  result.cycles.push_back(follow(stepper, *path, foils->clearance + foils->rise, progress));
  result.cycles.back().wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace bumpfoil
