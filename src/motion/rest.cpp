#include "bumpfoil/motion/rest.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "bumpfoil/motion/march.hpp"

namespace bumpfoil {
namespace {

/// Time steps below this fraction of the first are given up.
constexpr double smallest_time_step = 1e-6;
/// Control of time steps near the start (largest difference of P, U and position over c below near_start). If the state
/// departs at a rate s, implicit Euler multiplies the distance by 1 / (1 - s dt). Longer steps amplify it excessively,
/// and steps beyond s dt = 1 reverse its sign: the march then ends in a state on the other side, if anywhere. The next
/// step aims at a given s dt, with s from the last two changes, and no step may change the state by more than a given
/// multiple of the previous change. Steps stay above a given fraction of the first: foils snap through at once.
constexpr double near_start = 0.1;
constexpr double aimed_growth = 0.4;
constexpr double largest_change_ratio = 4.0;
constexpr double shortest_bounded_step = 1e-3;

/// Growth factor of time steps that change less than the solver's tolerance: motion has not started, or has ended.
constexpr double growth_while_still = 8.0;
/// Without rotation there is no flutter for long steps to hide: factor of the first step, and the growth of steps.
constexpr double first_step_without_speed = 4.0;
constexpr double growth_without_speed = 2.0;

/// Distance from the journal at which foils are assembled, in bulges: more than one step of the film may close.
constexpr double bulges_away = 10.0;

/// Time steps of adapted length until rest, then a steady step.
class RestSearch {
 public:
  RestSearch(const FilmStepper& stepper, const OperatingPoint& to, const BearingState& start)
      : stepper_(stepper),
        options_(stepper.options()),
        start_(start),
        first_((to.speed == 0.0 ? first_step_without_speed : 1.0) * options_.first_time_step *
               stepper.film().scales.squeeze_time()),
        growth_(to.speed == 0.0 ? growth_without_speed : options_.time_growth),
        dt_(first_),
        last_dt_(first_),
        leg_(ramp(to, to, 1)) {}

  /// The next leg of the schedule.
  const Leg* next() {
    if (!rests_ && steps_++ == options_.max_time_steps) {
      total_.status = Status::not_converged;
      return nullptr;
    }
    leg_.dt = rests_ ? 0.0 : dt_;
    return &leg_;
  }

  Verdict see(const Passage& at) {
    total_ += at.step.film;
    if (total_.status == Status::interrupted) return Verdict::refuse;
    return rests_ ? see_rest() : see_step(at);
  }

  [[nodiscard]] const FilmReport& report() const { return total_; }

 private:
  Verdict see_rest() {
    rests_ = false;
    if (total_.status == Status::converged) return Verdict::stop;
    if (total_.status != Status::not_converged) return Verdict::refuse;
    grow();
    return Verdict::retry;
  }

  Verdict see_step(const Passage& at) {
    if (!at.step.converged()) {
      dt_ *= 0.25;
      return dt_ < smallest_time_step * first_ ? Verdict::refuse : Verdict::retry;
    }
    change_ = stepper_.distance(at.from, at.step.state);
    is_near_ = stepper_.distance(start_, at.from) < near_start;
    if (change_ > largest_change_ratio * last_change_ && is_near_ && dt_ > shortest_bounded_step * first_) {
      dt_ *= 0.25;
      return Verdict::retry;
    }
    // A drift that grows with the step is not rest: the march passes the former end of a branch.
    rests_ = dt_ > options_.last_time_step && change_ < options_.resting_change && change_ <= last_change_;
    if (!rests_) grow();
    return Verdict::go_on;
  }

  void grow() {
    // The distance grows by change / last_change, corrected for the longer step.
    const double s_dt = 1.0 - dt_ / last_dt_ * last_change_ / change_;
    const bool is_left = is_near_ && change_ > options_.marching_tolerance && s_dt > 0.0;
    last_change_ = std::max(change_, options_.marching_tolerance);
    last_dt_ = dt_;
    const double usual = change_ < options_.marching_tolerance ? growth_while_still : growth_;
    dt_ *= is_left ? std::min(usual, aimed_growth / s_dt) : usual;
  }

  const FilmStepper& stepper_;
  const FilmBearingOptions& options_;
  const BearingState& start_;
  double first_;   ///< time step, s
  double growth_;  ///< of time steps
  double dt_;
  double last_dt_;  ///< of the last step, s
  Leg leg_;         ///< of one increment
  int steps_{};
  bool rests_{};  ///< the next step is steady
  double change_{};
  bool is_near_{};  ///< whether the state is near the start
  double last_change_{std::numeric_limits<double>::infinity()};
  FilmReport total_;
};

}  // namespace

FilmReport march_to_rest(FilmStepper& stepper, const OperatingPoint& to, BearingState& state) {
  RestSearch search(stepper, to, state);
  BearingState moving = state;
  Step step;
  const auto take = [&](const Leg& leg, int taken, const BearingState& from, Step& next) {
    next.state = from;
    // A film that only seems to rest, passing the end of a branch, has no steady state there.
    const bool rests = leg.dt == 0.0;
    next.film = stepper.solve(stepper.move_to(leg.point(taken), leg.dt, TimeScheme::implicit_euler), next.state, rests);
    next.status = next.film.status;
  };
  march(
      take, [&] { return search.next(); }, moving, step, [&](const Passage& at) { return search.see(at); });
  if (search.report().status == Status::converged) state = std::move(moving);
  return search.report();
}

BearingState assembled(FilmStepper& stepper, const Eigen::Vector2d& position, double speed, double clearance_offset) {
  const BearingModel& bearing = stepper.bearing();
  BearingState foils = resting(bearing, position, speed, clearance_offset);
  if (bearing.assembly.empty()) return foils;
  // Far from the journal, without motion or supply of gas, one Newton step is exact.
  const Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double bulge = 0.0;
  for (const PadAssembly& pad : bearing.assembly) bulge = std::max(bulge, pad.bulge);
  const OperatingPoint far = OperatingPoint::held_at(centre, 0.0, bulges_away * bulge + bearing.film->scales.thickness);
  BearingState state = resting(bearing, centre, 0.0, far.clearance_offset);
  state.film.pressure = bearing.film->field(1.0);
  if (stepper.solve(stepper.move_to(far), state).status != Status::converged) return foils;
  foils.contacts = std::move(state.contacts);
  foils.film.deflection = std::move(state.film.deflection);
  foils.film.moment = std::move(state.film.moment);
  foils.film.membrane = std::move(state.film.membrane);
  foils.film.thickness += bearing.film->over_the_width(foils.film.deflection);
  foils.begin_increment();
  return foils;
}

FilmReport settle(FilmStepper& stepper, const OperatingPoint& to, BearingState& state) {
  state.begin_increment();
  return march_to_rest(stepper, to, state);
}

FilmReport start_from_ambient(FilmStepper& stepper, const Eigen::Vector2d& position, double speed, BearingState& state,
                              double clearance_offset) {
  BearingState start = assembled(stepper, position, speed, clearance_offset);
  const FilmReport report = settle(stepper, OperatingPoint::held_at(position, speed, clearance_offset), start);
  if (report.status == Status::converged) state = std::move(start);
  return report;
}

}  // namespace bumpfoil
