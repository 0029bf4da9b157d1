#include "bumpfoil/motion/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "bumpfoil/bearing/energy.hpp"
#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/motion/march.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Turns after which film and foils are independent of their initial state.
constexpr int forgetting_turns = 2;
/// Number of differences in excess of the number of unknowns.
constexpr int more_differences = 2;
/// Smaller fractions of the largest difference count as zero.
constexpr double no_difference = 1e-9;
/// Smallest fraction of a film that remains after a motion is added to a state.
constexpr double least_film_left = 0.5;
/// Smaller multipliers count as zero.
constexpr double least_multiplier = 1e-3;
/// Differences above so many tolerances determine multipliers, and singular values below so many are noise: friction
/// creeps below them, and steps have finite accuracy.
constexpr double telling_tolerances = 10.0;
constexpr double noisy_tolerances = 0.3;
/// Disturbance of orbits over c: not hidden by friction, and small compared with any film thickness.
constexpr double disturbance = 1e-3;

/// Numbers that are compared between turns: y/c and v / (c |Omega|) of the journals.
Eigen::VectorXd journal_numbers(const MachineStepper& stepper, const MachineState& state) {
  const std::vector<RotorStation>& bearings = stepper.rotor().bearings;
  Eigen::VectorXd numbers(4 * static_cast<Eigen::Index>(bearings.size()));
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const double c = stepper.bearings()[i]->film().scales.thickness;
    const Eigen::Index at = 4 * static_cast<Eigen::Index>(i);
    const Eigen::Vector2d place = bearings[i].motion * state.rotor.y;
    const Eigen::Vector2d velocity = bearings[i].motion * state.rotor.v;
    numbers.segment<2>(at) = place / c;
    numbers.segment<2>(at + 2) = velocity / (c * std::abs(state.speed));
  }
  return numbers;
}

/// Accumulates over the steps of a turn.
class TurnRecord {
 public:
  explicit TurnRecord(const MachineStepper& stepper)
      : stepper_(stepper),
        turn_(stepper.bearings().size(), BearingTurn{.thinnest = std::numeric_limits<double>::infinity()}) {
    for (const RotorStation& bearing : stepper.rotor().bearings) places_.push_back({&bearing});
    for (const RotorStation& station : stepper.rotor().stations) places_.push_back({&station});
  }

  void add(const MachineState& state, int steps) {
    const double part = 1.0 / steps;
    const Complex back = std::polar(2.0 * part, -std::abs(state.angle));
    for (Place& place : places_) {
      const Eigen::Vector2d q = place.station->motion * state.rotor.y;
      place.orbit.mean += part * q;
      place.orbit.once += back * q;
      place.orbit.twice += std::polar(2.0 * part, -2.0 * std::abs(state.angle)) * q;
      place.least = place.least.cwiseMin(q);
      place.most = place.most.cwiseMax(q);
    }
    for (std::size_t i = 0; i < turn_.size(); ++i) {
      const BearingModel& bearing = stepper_.bearings()[i]->bearing();
      const BearingState& now = state.bearings[i];
      turn_[i].thinnest = std::min(turn_[i].thinnest, bearing.film->scales.thickness * now.film.thickness.minCoeff());
      turn_[i].power += part * film_bearing_outcome(bearing, now).power;
      turn_[i].friction += friction_work(bearing.problem, state.bearings_before[i].contacts, now.contacts);
    }
  }

  void write(Orbit& orbit) const {
    orbit.turn = turn_;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      StationOrbit found = places_[i].orbit;
      found.half_peak_to_peak = 0.5 * (places_[i].most - places_[i].least);
      (i < turn_.size() ? orbit.bearings : orbit.stations).push_back(found);
    }
  }

 private:
  struct Place {
    const RotorStation* station;
    StationOrbit orbit{};
    Eigen::Vector2d least{Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity())};
    Eigen::Vector2d most{-least};
  };

  const MachineStepper& stepper_;
  std::vector<Place> places_;
  std::vector<BearingTurn> turn_;
};

/// sum g_i a_i of one quantity of all states.
template <typename Read>
void combine(const Eigen::VectorXd& weights, const std::vector<MachineState>& states, const Read& part,
             MachineState& sum) {
  auto&& to = part(sum);
  to *= weights[0];
  for (std::size_t i = 1; i < states.size(); ++i) to += weights[static_cast<Eigen::Index>(i)] * part(states[i]);
}

/// Visits the numbers of a bearing of which states are combined, without those of previous steps.
/// @param add  (quantity of a bearing's state)
template <typename Add>
void for_parts_of_bearings(const Add& add) {
  add([](auto& b) -> auto& { return b.position; });
  add([](auto& b) -> auto& { return b.tilt; });
  add([](auto& b) -> auto& { return b.film.pressure; });
  add([](auto& b) -> auto& { return b.film.thickness; });
  add([](auto& b) -> auto& { return b.film.deflection; });
  add([](auto& b) -> auto& { return b.film.moment; });
  add([](auto& b) -> auto& { return b.film.membrane; });
  add([](auto& b) -> auto& { return b.slip_origin; });
  add([](auto& b) -> auto& { return b.contacts.x; });
  add([](auto& b) -> auto& { return b.contacts.gap; });
  add([](auto& b) -> auto& { return b.contacts.normal_force; });
  add([](auto& b) -> auto& { return b.contacts.friction_force; });
}

/// sum g_i of whole states. Modes, time and angle are those of the last.
/// @param with_steps  includes previous steps, which all states must have
MachineState combined(const Eigen::VectorXd& weights, const std::vector<MachineState>& states, bool with_steps = true) {
  MachineState sum = states.front();
  const auto add = [&](const auto& part) { combine(weights, states, part, sum); };
  add([](auto& s) -> auto& { return s.rotor.y; });
  add([](auto& s) -> auto& { return s.rotor.v; });
  for (std::size_t i = 0; i < sum.bearings.size(); ++i) {
    for_parts_of_bearings([&](const auto& part) { add([&](auto& s) -> auto& { return part(s.bearings[i]); }); });
    sum.bearings[i].contacts.mode = states.back().bearings[i].contacts.mode;
  }
  sum.time = states.back().time;
  sum.angle = states.back().angle;
  if (!with_steps) return sum;
  add([](auto& s) -> auto& { return s.rotor_before.y; });
  add([](auto& s) -> auto& { return s.rotor_before.v; });
  for (std::size_t i = 0; i < sum.bearings.size(); ++i) {
    for_parts_of_bearings([&](const auto& part) { add([&](auto& s) -> auto& { return part(s.bearings_before[i]); }); });
    add([i](auto& s) -> auto& { return s.bearings[i].last_step.content; });
    add([i](auto& s) -> auto& { return s.bearings_before[i].last_step.content; });
  }
  return sum;
}

bool has_films(const MachineState& state) {
  return std::all_of(state.bearings.begin(), state.bearings.end(), [](const BearingState& bearing) {
    return bearing.film.pressure.minCoeff() > 0.0 && bearing.film.thickness.minCoeff() > 0.0;
  });
}

/// Minimum of |sum g_i d_i| with sum g_i = 1; of several solutions, the shortest.
Eigen::VectorXd extrapolating_weights(const Eigen::MatrixXd& differences) {
  Eigen::MatrixXd rows(differences.rows() + 1, differences.cols());
  rows << differences / differences.cwiseAbs().maxCoeff(), Eigen::RowVectorXd::Ones(differences.cols());
  const Eigen::VectorXd weights =
      least_squares(rows, Eigen::VectorXd::Unit(rows.rows(), rows.rows() - 1), no_difference);
  return weights / weights.sum();
}

/// Whether differences exceed those of a periodic orbit.
bool tell_multipliers(const Eigen::MatrixXd& differences, double tolerance) {
  return differences.cwiseAbs().maxCoeff() > telling_tolerances * tolerance;
}

/// Eigenvalues of the map from each difference to the next, in descending magnitude.
std::vector<Complex> multipliers_of(const Eigen::MatrixXd& differences, double tolerance) {
  const Eigen::Index n = differences.cols() - 1;
  const double largest = differences.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd scaled = differences.transpose() / largest;
  const Eigen::MatrixXd map = least_squares(scaled.topRows(n), scaled.bottomRows(n),
                                            std::max(no_difference, noisy_tolerances * tolerance / largest));
  const std::optional<Eigen::VectorXcd> values = eigenvalues(map);
  if (!values) return {};
  std::vector<Complex> found(values->begin(), values->end());
  std::sort(found.begin(), found.end(), [](Complex a, Complex b) { return std::abs(a) > std::abs(b); });
  std::erase_if(found, [&](Complex value) { return std::abs(value) < least_multiplier; });
  return found;
}

/// A motion that differs between all journals and has both directions of whirl, with the size of a disturbance.
Eigen::VectorXcd disturbing_motion(const MachineStepper& stepper) {
  const std::vector<RotorStation>& bearings = stepper.rotor().bearings;
  Eigen::MatrixXd places(2 * static_cast<Eigen::Index>(bearings.size()), stepper.rotor().size());
  Eigen::MatrixXd motions(places.rows(), 2);  // real and imaginary parts
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const Eigen::Index at = 2 * static_cast<Eigen::Index>(i);
    const double size = disturbance * stepper.bearings()[i]->film().scales.thickness;
    places.middleRows(at, 2) = bearings[i].motion;
    for (const Eigen::Index axis : {0, 1}) {
      const auto phase = static_cast<double>(at + axis);
      motions.row(at + axis) = size * Eigen::RowVector2d(std::cos(phase), std::sin(phase));
    }
  }
  const Eigen::MatrixXd motion = least_squares(places, motions);
  return motion.col(0) + Complex(0.0, 1.0) * motion.col(1);
}

/// Restarts time integration from here.
void forget_steps(MachineState& state) {
  state.last_dt = 0.0;
  for (BearingState& bearing : state.bearings) bearing.last_step = {};
}

}  // namespace

void add_motion(const MachineStepper& stepper, const Eigen::VectorXcd& motion, MachineState& state) {
  const std::vector<JointLaw::Journal>& journals = stepper.journals();
  const auto thickness_at = [&](std::size_t i, double part) {
    const BearingModel& bearing = stepper.bearings()[i]->bearing();
    const BearingState& there = state.bearings[i];
    const Eigen::VectorXd y = state.rotor.y + part * motion.real();
    Matrix thickness = undeformed_thickness(bearing, journals[i].place(y), there.clearance_offset);
    return Matrix(thickness + bearing.film->over_the_width(there.film.deflection));
  };
  double part = 1.0;
  for (std::size_t i = 0; i < journals.size(); ++i) {
    const Matrix& before = state.bearings[i].film.thickness;
    const Matrix loss = (before - thickness_at(i, 1.0)).cwiseQuotient(before);
    part = std::min(part, (1.0 - least_film_left) / std::max(1.0 - least_film_left, loss.maxCoeff()));
  }
  for (std::size_t i = 0; i < journals.size(); ++i) {
    state.bearings[i].film.thickness = thickness_at(i, part);
    FilmModel::place_journal(journals[i].place(state.rotor.y + part * motion.real()), state.bearings[i]);
  }
  state.rotor.y += part * motion.real();
  state.rotor.v += part * std::abs(state.speed) * (Complex(0.0, 1.0) * motion).real();
}

std::optional<MachineState> moved_orbit(const MachineState& linear, const MachineState& orbit,
                                        const MachineState& before) {
  MachineState moved = combined(Eigen::Vector3d(1.0, -1.0, 1.0), {linear, before, orbit}, false);
  forget_steps(moved);
  if (!has_films(moved)) return std::nullopt;
  return moved;
}

Orbit find_orbit(MachineStepper& stepper, const RotorForces& forces, const MachineState& start,
                 const OrbitOptions& options) {
  BUMPFOIL_ASSERT(!stepper.bearings().empty());
  Orbit orbit{.state = start};
  const double dt = 2.0 * std::numbers::pi / (std::abs(start.speed) * options.steps_per_turn);
  MachineStep step;
  /// @return change of the journals in a turn; nothing if the turn failed
  const auto take_turn = [&](TurnRecord* record) -> std::optional<Eigen::VectorXd> {
    if (options.keep_going && !options.keep_going()) {
      orbit.status = Status::interrupted;
      return std::nullopt;
    }
    const Eigen::VectorXd before = journal_numbers(stepper, orbit.state);
    const MachineSchedule one_turn = equal_steps(options.steps_per_turn, {.dt = dt, .speed = start.speed});
    const bool whole = march(stepper, one_turn, forces, orbit.state, step, [&](const MachineStep& at) {
      orbit.iterations += at.report.iterations;
      orbit.status = at.report.status;
      if (orbit.status != Status::converged) return Verdict::refuse;
      if (record != nullptr) record->add(at.state, options.steps_per_turn);
      return Verdict::go_on;
    });
    if (!whole) return std::nullopt;
    ++orbit.turns;
    Eigen::VectorXd difference = journal_numbers(stepper, orbit.state) - before;
    orbit.change = difference.cwiseAbs().maxCoeff();
    return difference;
  };

  const auto count = static_cast<Eigen::Index>(4 * stepper.bearings().size() + more_differences);
  Eigen::MatrixXd differences(4 * static_cast<Eigen::Index>(stepper.bearings().size()), count);
  std::vector<MachineState> ends;
  bool is_periodic = false;
  for (int taken = 0; orbit.turns < options.max_turns; ++taken) {
    const auto difference = take_turn(nullptr);
    if (!difference) return orbit;
    is_periodic = orbit.change < options.tolerance;
    if (is_periodic) break;
    if (taken < forgetting_turns) continue;
    differences.col(std::ssize(ends)) = *difference;
    ends.push_back(orbit.state);
    if (std::ssize(ends) < count) continue;
    if (tell_multipliers(differences, options.tolerance)) {
      orbit.multipliers = multipliers_of(differences, options.tolerance);
    }
    MachineState next = combined(extrapolating_weights(differences), ends);
    if (has_films(next)) orbit.state = std::move(next);
    ends.clear();
    taken = -1;
  }
  TurnRecord record(stepper);
  if (!take_turn(&record)) return orbit;
  record.write(orbit);
  if (!is_periodic) orbit.status = Status::not_converged;
  if (!is_periodic || !orbit.multipliers.empty()) return orbit;
  const MachineState found = orbit.state;
  const double change = orbit.change;
  add_motion(stepper, disturbing_motion(stepper), orbit.state);
  forget_steps(orbit.state);
  Eigen::Index seen = -forgetting_turns;
  for (; seen < count; ++seen) {
    const auto difference = take_turn(nullptr);
    if (!difference) break;
    if (seen >= 0) differences.col(seen) = *difference;
  }
  if (seen == count) orbit.multipliers = multipliers_of(differences, options.tolerance);
  // The end of the disturbed march does not affect the orbit.
  if (orbit.status != Status::interrupted) orbit.status = Status::converged;
  orbit.state = found;
  orbit.change = change;
  return orbit;
}

}  // namespace bumpfoil
