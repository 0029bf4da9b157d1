#include "bumpfoil/motion/branch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/motion/rest.hpp"

namespace bumpfoil {
namespace {

/// The next step may grow after a step with at most this many iterations.
constexpr int easy_iterations = 12;
/// A step that ends closer to the end than this fraction of it is extended to the end.
constexpr double last_step_round_off = 1e-12;
/// Steps grow until the departure from the tangent is this fraction of the accepted one, by at most the following
/// factor at once.
constexpr double aimed_departure = 0.5;
constexpr double largest_growth = 8.0;
/// A contact change at the start of a step bends the branch there: half the step then has half the departure, within
/// these fractions, however short the step.
constexpr double least_part_at_corner = 0.35;
constexpr double largest_part_at_corner = 0.65;
/// Growth factor of steps that search for another branch, and of those behind the end of one.
constexpr double step_growth_off_branch = 8.0;

/// Follows a state along a line of operating points, by fractions of the line.
class BranchFollower {
 public:
  BranchFollower(FilmStepper& stepper, const OperatingPoint& to, BearingState& state)
      : stepper_(stepper),
        options_(stepper.options()),
        from_(point_of(stepper.bearing(), state, to)),
        to_(to),
        state_(state),
        longest_(1.0 / steps()),
        shortest_((to.by_load() ? options_.smallest_load_fraction : options_.smallest_fraction) / steps()) {}

  FilmReport follow();

 private:
  [[nodiscard]] double steps() const;
  [[nodiscard]] OperatingPoint at(double fraction) const;
  [[nodiscard]] double largest_departure(const FilmReport& report) const;
  [[nodiscard]] double growth(const FilmReport& taken) const;
  FilmReport solve_on_branch(const OperatingPoint& to, double twice_as_far);
  void jump();

  FilmStepper& stepper_;
  const FilmBearingOptions& options_;
  OperatingPoint from_, to_;
  BearingState& state_;
  double longest_, shortest_;  ///< steps
  double reached_{};           ///< by the last state
  double leap_{shortest_};     ///< from the end of a branch to the next state behind it
  bool comes_to_rest_{true};   ///< where the film was marched in time so far
  FilmReport total_;
};

/// Number of steps of the first length, at least one.
double BranchFollower::steps() const {
  const double c = stepper_.film().scales.thickness;
  double steps = 1.0;
  if (to_.speed != from_.speed) {
    const double speed = std::max(std::abs(from_.speed), std::abs(to_.speed));
    steps = std::max(steps, std::abs(to_.speed - from_.speed) / (options_.speed_step * speed));
  }
  steps = std::max(steps, std::abs(to_.clearance_offset - from_.clearance_offset) / (options_.position_step * c));
  const auto by_distance = [&](Control control, const Eigen::Vector2d& displacement) {
    if (control == Control::displacement) steps = std::max(steps, displacement.norm() / (options_.position_step * c));
  };
  by_distance(to_.control, to_.journal - from_.journal);
  by_distance(to_.tilt.control, to_.tilt.value - from_.tilt.value);
  return steps;
}

OperatingPoint BranchFollower::at(double fraction) const {
  OperatingPoint point = to_;
  point.journal = from_.journal + fraction * (to_.journal - from_.journal);
  point.speed = from_.speed + fraction * (to_.speed - from_.speed);
  point.clearance_offset = from_.clearance_offset + fraction * (to_.clearance_offset - from_.clearance_offset);
  point.tilt.value = from_.tilt.value + fraction * (to_.tilt.value - from_.tilt.value);
  return point;
}

double BranchFollower::largest_departure(const FilmReport& report) const {
  return std::max(options_.largest_departure * report.predicted_change, options_.resolved_departure);
}

/// The next state. Under a load it must be on the same branch: Newton's method has reached another branch if the
/// departure from the tangent prediction exceeds what curvature and contacts explain.
/// @param twice_as_far  departure in a step of twice the length, if that was too large
FilmReport BranchFollower::solve_on_branch(const OperatingPoint& to, double twice_as_far) {
  BearingState found = state_;
  FilmReport report = stepper_.solve(stepper_.move_to(to), found, to.by_load());
  if (report.status != Status::converged) return report;
  const bool is_corner = report.departure < report.predicted_change &&
                         report.departure > least_part_at_corner * twice_as_far &&
                         report.departure < largest_part_at_corner * twice_as_far;
  if (to.by_load() && report.departure > largest_departure(report) && !is_corner) {
    report.status = Status::not_converged;
    return report;
  }
  state_ = std::move(found);
  return report;
}

/// Growth factor of the next step after a successful one.
double BranchFollower::growth(const FilmReport& taken) const {
  if (taken.iterations >= easy_iterations) return 1.0;
  if (!to_.by_load()) return options_.time_growth;
  return std::clamp(aimed_departure * largest_departure(taken) / taken.departure, 1.0, largest_growth);
}

/// Continues behind the end of a branch from its last state to where the film comes to rest in time. If it does not,
/// under a load, takes the state that Newton's method reaches in the shortest step that converges. This counts as a
/// jump unless it is only a corner of the branch at which Newton's method failed.
void BranchFollower::jump() {
  const BearingState last = state_;
  const double begin = reached_;
  const auto behind = [&](double leap) {
    reached_ = std::min(1.0, begin + std::min(leap, longest_));
    return at(reached_);
  };
  const bool marches_first = comes_to_rest_ || !to_.by_load();
  if (marches_first) {
    total_ += march_to_rest(stepper_, behind(leap_), state_);
    comes_to_rest_ = total_.status == Status::converged;
  }
  Status rested = total_.status;
  if (rested == Status::interrupted) return;
  for (double leap = leap_; total_.status != Status::converged && to_.by_load(); leap *= step_growth_off_branch) {
    total_ += stepper_.solve(stepper_.move_to(behind(leap)), state_);
    if (total_.status == Status::interrupted) return;
    if (leap >= longest_) break;
  }
  if (total_.status != Status::converged && !marches_first) {
    total_ += march_to_rest(stepper_, behind(leap_), state_);
    rested = total_.status;
    if (rested == Status::interrupted) return;
  }
  if (total_.status == Status::converged) {
    if (stepper_.distance(last, state_) > options_.resolved_departure) ++total_.jumps;
  } else {
    total_.status = rested == Status::not_converged ? Status::fold : rested;
  }
}

FilmReport BranchFollower::follow() {
  int ends = 0;
  double step = longest_;
  double too_far = 0.0;  // departure of the last step, if that was too large
  while (reached_ < 1.0) {
    step = std::min(step, 1.0 - reached_);
    const double next = step < (1.0 - last_step_round_off) * (1.0 - reached_) ? reached_ + step : 1.0;
    const FilmReport report = solve_on_branch(at(next), too_far);
    total_ += report;
    if (report.status == Status::interrupted) return total_;
    if (report.status == Status::converged) {
      reached_ = next;
      leap_ = shortest_;
      step *= growth(report);
      too_far = 0.0;
      continue;
    }
    too_far = report.departure;
    step *= 0.5;
    if (step >= leap_) continue;
    if (report.status != Status::not_converged) return total_;
    // The branch ends: there is no neighbouring state that continues it.
    if (ends++ == options_.max_ends) {
      total_.status = Status::fold;
      return total_;
    }
    jump();
    if (total_.status != Status::converged) return total_;
    // If the next step fails immediately, the end has not been passed yet.
    leap_ = std::min(step_growth_off_branch * leap_, longest_);
    step = leap_;
    too_far = 0.0;
  }
  return total_;
}

}  // namespace

FilmReport follow(FilmStepper& stepper, const OperatingPoint& to, BearingState& state) {
  state.begin_increment();
  return BranchFollower(stepper, to, state).follow();
}

}  // namespace bumpfoil
