#include "bumpfoil/experiments/path/path.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
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
#include "model/checks.hpp"

namespace bumpfoil {
namespace {

/// Point of the orbit after a number of its increments.
Eigen::Vector2d orbit_point(const PathSettings& path, int step) {
  const double turn = (path.sense == Sense::counterclockwise ? 2.0 : -2.0) * std::numbers::pi;
  const double t = turn * (step % path.steps) / path.steps;
  return path.centre.value + Eigen::Rotation2Dd(path.tilt) * Eigen::Vector2d(path.semi_axes.value.x() * std::cos(t),
                                                                             path.semi_axes.value.y() * std::sin(t));
}

Eigen::Vector2d path_point(const PathSettings& path, int number) {
  return path.is_orbit() ? orbit_point(path, number) : path.points.values[static_cast<std::size_t>(number)];
}

/// Number of points after the first.
int further_points(const PathSettings& path) {
  return path.is_orbit() ? path.orbits * path.steps : static_cast<int>(path.points.values.size()) - 1;
}

/// Increments to the first point; none if the path starts at the origin.
int increments_of_approach(const PathSettings& path) {
  if (path_point(path, 0).isZero(0.0)) return 0;
  return path.is_orbit() ? path.steps : 1;
}

/// The largest load, N.
double largest_load(const PathSettings& path) {
  double largest = 0.0;
  if (path.control() != Control::load) return largest;
  const Schedule next_leg = path_schedule(path);
  while (const Leg* leg = next_leg()) largest = std::max(largest, largest_place({*leg}));
  return largest;
}

/// Unit vector from the centre of the bearing towards the journal.
Eigen::Vector2d outward(const Eigen::Vector2d& position) {
  const double distance = position.norm();
  return distance > 0.0 ? Eigen::Vector2d(position / distance) : Eigen::Vector2d::UnitX();
}

/// A smaller length relative to the rise is round-off.
constexpr double length_round_off = 1e-12;

/// Identifies the orbits in the sequence of increments.
class OrbitCounter {
 public:
  OrbitCounter(const PathSettings& path, int increments, const BearingModel& foils)
      : steps_(path.is_orbit() ? path.steps : 0),
        lead_in_(increments - 1 - path.orbits * steps_),
        force_round_off_(foils.round_off.force),
        length_round_off_(length_round_off * foils.rise) {}

  [[nodiscard]] int orbit_of(int increment) const {
    return steps_ > 0 && increment > lead_in_ ? (increment - lead_in_ - 1) / steps_ + 1 : 0;
  }

  /// @return results of the orbit, if one ends here
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
                     .force_defect = cleared(force, force_round_off_),
                     .position_defect = cleared(distance, length_round_off_)};
  }

 private:
  int steps_;
  int lead_in_;  ///< number of the last increment before the first orbit
  double force_round_off_;
  double length_round_off_;
  Increment begin_;
  std::vector<OrbitPoint> points_;  ///< of the current orbit
};

/// @throws Error (input) if the increments of a path exceed memory
void require_memory(const PathSettings& path, int bumps) {
  const int increments = path_increments(path);
  if (increments <= most_bump_increments / bumps) return;
  throw Error(ErrorKind::input,
              {{"", 0, path.is_orbit() ? "path.steps" : "path.points", "",
                fmt::format("{} increments of {} bumps would not fit in memory", increments, bumps),
                "give fewer, or use the program `bumpfoil path`, which writes them to files as they come"}});
}

/// Takes the foils along the path. @param result  receives its cycle
void follow(FoilStepper& stepper, const PathSettings& path, const ProgressCallback& progress, const RecordSink& sink,
            CycleResult& result) {
  Cycle& cycle = result.cycles.emplace_back();
  cycle.due = path_increments(path);
  CycleQuantities quantities(cycle);
  RecordSink pass_on;
  if (sink) {
    pass_on = [&](const CycleResult& recorded) {
      quantities.take_recorded();
      sink(recorded);
    };
  }
  IncrementLog log(stepper, Recording::everything, cycle, pass_on ? [&] { pass_on(result); } : std::function<void()>());
  OrbitCounter orbits(path, cycle.due, stepper.foils());

  Step step;
  const auto add = [&](bool checked) {
    const Eigen::Vector2d& position = step.state.position;
    const Eigen::Vector2d direction = outward(position);
    Increment next = log.make(step, Branch::loading, direction, position.norm(), true);
    next.orbit = orbits.orbit_of(next.index);
    if (next.converged()) next.tangents = stepper.tangents(step.state);
    log.write_down(step, next, direction);
    quantities.add(next, checked && step.converged(), false);
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
    const double reach = stepper.foils().clearance + stepper.foils().rise;
    goes_on = march(stepper_of(stepper, largest_load(path), reach), path_schedule(path), state, step,
                    [&](const Passage& at) { return add(at.ends_leg) ? Verdict::go_on : Verdict::refuse; });
  }
  if (!goes_on && cycle.converged()) cycle.status = Status::interrupted;
  log.finish();
  quantities.finish();
}

}  // namespace

Schedule path_schedule(const PathSettings& path) {
  const int approach = increments_of_approach(path);
  return
      [&path, approach, leg = Leg(), next = approach > 0 ? 0 : 1, last = further_points(path)]() mutable -> const Leg* {
        if (next > last) return nullptr;
        leg = next == 0 ? straight_leg(path.control(), Eigen::Vector2d::Zero(), path_point(path, 0), approach)
                        : straight_leg(path.control(), path_point(path, next - 1), path_point(path, next), 1);
        ++next;
        return &leg;
      };
}

int path_increments(const PathSettings& path) {
  return 1 + increments_of_approach(path) + further_points(path);
}

CycleResult run_path(const Case& input, const ProgressCallback& progress, const RecordSink& sink) {
  const SharedBearing foils = make_bearing_foils(input, {"path"});
  const PathSettings& path = input.settings.get<PathSettings>();
  if (!sink) require_memory(path, foils->bumps());
  const auto begin = std::chrono::steady_clock::now();
  FoilStepper stepper = make_stepper(foils, input.solver);
  CycleResult result{.solver = input.solver.chosen(),
                     .experiment = Experiment::path,
                     .due = 1,
                     .over_width = input.varies_over_the_width(),
                     .cycles = {}};
  follow(stepper, path, progress, sink, result);
  result.cycles.back().wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace bumpfoil
