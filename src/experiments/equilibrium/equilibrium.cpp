#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/march.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "bumpfoil/motion/start.hpp"
#include "experiments/equilibrium/check_state.hpp"

namespace bumpfoil {
namespace {

/// Initial eccentricity of a path, in C_r less the largest pad offset: along the load, and at most, towards a
/// prescribed position.
constexpr double start_along_load = 0.6;
constexpr double start_towards_position = 0.7;
/// A ramp of speeds starts at this multiple of its first speed.
constexpr double coasting_from = 1.5;

OperatingPoint at_speed(OperatingPoint point, double speed) {
  point.speed = speed;
  return point;
}

/// Appends the states at `points`, not computed yet.
void plan(FilmPath path, const std::vector<OperatingPoint>& points, Status status, std::vector<RunningState>& states) {
  std::optional<OperatingPoint> before;
  for (const OperatingPoint& point : points) {
    RunningState& state = states.emplace_back();
    state.path = path;
    state.requested = point;
    state.before = std::exchange(before, point);
    state.report.status = status;
  }
}

/// Follows paths and stores their states.
class PathWalker {
 public:
  PathWalker(const EquilibriumSettings& settings, double thickness_floor, EquilibriumResult& result,
             const std::function<bool(double)>& progress, StateCheckers* checkers, std::size_t states)
      : result_(result),
        progress_(progress),
        checkers_(checkers),
        states_(states),
        settings_(settings),
        options_(options(thickness_floor)),
        stepper_(result.bearing, options_) {}

  /// Computes the states at `points` in sequence, one increment from each to the next. Behind one that is not found
  /// none is reached.
  void walk(FilmPath path, const std::vector<OperatingPoint>& points) {
    plan(path, points, Status::not_reached, result_.states);
    Program program;
    for (const OperatingPoint& point : points) program.push_back(bumpfoil::ramp(point, point, 1));
    bool begins = true;
    const BearingStepper take = [&](const Leg& leg, int taken, const BearingState& from, Step& step) {
      const auto begin = std::chrono::steady_clock::now();
      done_of_state_ = 0.0;
      step.state = from;
      step.film = begins ? start(path, leg.point(taken), step.state) : go(leg.point(taken), step.state);
      step.status = step.film.status;
      result_.states[done_].wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const std::size_t end = done_ + points.size();
    BearingState state;
    Step step;
    march(take, schedule_of(program), state, step, [&](const Passage& at) {
      RunningState& found = result_.states[done_++];
      found.report.status = Status::converged;
      found.report += at.step.film;
      if (!begins || state_) hand_over(at.step.state, found);
      begins = false;
      return at.step.converged() ? Verdict::go_on : Verdict::refuse;
    });
    done_ = end;
  }

 private:
  [[nodiscard]] FilmBearingOptions options(double thickness_floor) const {
    FilmBearingOptions options;
    options.newton.thickness_floor = thickness_floor / result_.bearing->film->scales.thickness;
    options.keep_going = [this] { return !progress_ || progress_(fraction()); };
    return options;
  }

  [[nodiscard]] double fraction() const {
    return (static_cast<double>(done_) + done_of_state_) / static_cast<double>(states_);
  }

  void hand_over(const BearingState& state, RunningState& found) {
    found.last = state;
    const auto check = [bearing = result_.bearing, &settings = settings_, tabulates = checkers_ && found.found(),
                        &found] { check_state(bearing, settings, tabulates, found); };
    checkers_ ? checkers_->take(result_.bearing, found, check) : check();
  }

  /// From the initial guess to the first state of a path.
  /// @param state  receives it, or the last one that was found on the way there; see state_
  FilmReport start(FilmPath path, const OperatingPoint& point, BearingState& state) {
    state_.reset();
    return start_from_rest(
        stepper_, point, settings_.steps,
        [&](FilmStepper& starting, double clearance_offset, BearingState& begun) {
          starting_ = &starting;
          clearance_offset_ = clearance_offset;
          FilmReport report{.status = Status::converged};
          start_assembled(path, point, report);
          if (state_) begun = *state_;
          return report;
        },
        state);
  }

  /// The same for assembled foils; the clearance is opened if necessary, and restored at the end.
  void start_assembled(FilmPath path, const OperatingPoint& point, FilmReport& total) {
    const bool by_load = point.by_load();
    OperatingPoint opened = point;
    opened.clearance_offset = clearance_offset_;
    // A journal at rest settles onto the foils under its load.
    switch (by_load && point.speed == 0.0 ? FilmPath::cold_start : path) {
      case FilmPath::load_ramp:
        begin_gently(along(point), point.speed, total);
        ramp(opened, total);
        break;
      case FilmPath::position_ray:
        if (by_load) {
          begin(Eigen::Vector2d::Zero(), point.speed, total);
          ramp(OperatingPoint::held_at(along(point), point.speed, clearance_offset_), total);
        } else {
          begin_gently(towards(point), point.speed, total);
        }
        ramp(opened, total);
        break;
      case FilmPath::speed_ramp:
        start_assembled(by_load ? FilmPath::load_ramp : FilmPath::position_ray,
                        at_speed(point, coasting_from * point.speed), total);
        ramp(point, total);
        break;
      case FilmPath::cold_start:
        begin(by_load ? along(point) : point.journal, point.speed, total);
        if (!by_load) {
          ramp(opened, total);  // with its tilt
        } else if (total.status == Status::converged) {
          total += settle(*starting_, opened, *state_);
        }
        break;
    }
    if (state_ && state_->clearance_offset > 0.0) ramp(point, total);
  }

  [[nodiscard]] Eigen::Vector2d along(const OperatingPoint& point) const {
    return start_along_load * (starting_->film().assembled_clearance + clearance_offset_) * point.journal.normalized();
  }

  [[nodiscard]] Eigen::Vector2d towards(const OperatingPoint& point) const {
    const double farthest = start_towards_position * (starting_->film().assembled_clearance + clearance_offset_);
    return point.journal.norm() <= farthest ? point.journal : Eigen::Vector2d(farthest * point.journal.normalized());
  }

  void begin(const Eigen::Vector2d& position, double speed, FilmReport& total) {
    BearingState started;
    total += start_from_ambient(*starting_, position, speed, started, clearance_offset_);
    if (total.status == Status::converged) state_ = std::move(started);
  }

  /// begin(); if that throws the foil onto the journal, starts from the centre and proceeds to the position.
  void begin_gently(const Eigen::Vector2d& position, double speed, FilmReport& total) {
    begin(position, speed, total);
    if (total.status != Status::touchdown) return;
    begin(Eigen::Vector2d::Zero(), speed, total);
    ramp(OperatingPoint::held_at(position, speed, clearance_offset_), total);
  }

  /// Proceeds to a point in equal increments; none if already there.
  void ramp(const OperatingPoint& point, FilmReport& total) {
    if (total.status != Status::converged) return;
    const OperatingPoint from = point_of(*result_.bearing, *state_, point);
    if (from == point) return;
    int taken = 0;
    const Program program{bumpfoil::ramp(from, point, settings_.steps)};
    march(stepper_of(*starting_), schedule_of(program), *state_, step_, [&](const Passage& at) {
      total += at.step.film;
      done_of_state_ = static_cast<double>(++taken % settings_.steps) / settings_.steps;
      return at.step.converged() ? Verdict::go_on : Verdict::stop;
    });
  }

  /// One increment. If a journal starts to turn under a load, it breaks loose: asperities rub immediately, and the
  /// march in time finds its next rest position.
  FilmReport go(const OperatingPoint& to, BearingState& state) {
    const bool breaks_loose = state.speed == 0.0 && to.speed != 0.0 && to.by_load();
    return breaks_loose ? settle(stepper_, to, state) : follow(stepper_, to, state);
  }

  EquilibriumResult& result_;
  const std::function<bool(double)>& progress_;
  StateCheckers* checkers_;
  std::size_t states_;
  const EquilibriumSettings& settings_;
  FilmBearingOptions options_;
  std::size_t done_{};  ///< states
  double done_of_state_{};
  FilmStepper stepper_;
  FilmStepper* starting_{};            ///< of the start: its foils may be formed differently from those of stepper_
  double clearance_offset_{};          ///< initial clearance offset, m
  std::optional<BearingState> state_;  ///< current state of the start; none where none was found yet
  Step step_;
};

/// |Omega| at the vertex of the parabola through three points of the torque; none unless the middle one is the minimum.
std::optional<double> least_torque_between(const std::array<const RunningState*, 3>& states) {
  std::array<double, 3> speed{};
  std::array<double, 3> torque{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!states.at(i)->found()) return std::nullopt;
    speed.at(i) = std::abs(states.at(i)->requested.speed);
    torque.at(i) = std::abs(states.at(i)->outcome->torque);
  }
  if (torque[1] >= torque[0] || torque[1] > torque[2]) return std::nullopt;
  const double before = (torque[1] - torque[0]) / (speed[1] - speed[0]);
  const double after = (torque[2] - torque[1]) / (speed[2] - speed[1]);
  const double curvature = (after - before) / (speed[2] - speed[0]);
  return 0.5 * (speed[0] + speed[1] - before / curvature);
}

/// All loads or positions, at speed 0.
std::vector<OperatingPoint> journal_points(const EquilibriumSettings& equilibrium, const JournalTilt& tilt) {
  const bool by_load = !equilibrium.loads.empty();
  std::vector<OperatingPoint> points;
  for (const Eigen::Vector2d& value : by_load ? equilibrium.loads : equilibrium.positions) {
    points.push_back(by_load ? OperatingPoint::loaded_by(value, 0.0) : OperatingPoint::held_at(value, 0.0));
    points.back().tilt = tilt;
  }
  return points;
}

/// Groups of states that are computed in sequence on a path.
std::vector<std::vector<OperatingPoint>> chains_of(FilmPath path, const EquilibriumSettings& equilibrium,
                                                   const JournalTilt& tilt) {
  const std::vector<OperatingPoint> journals = journal_points(equilibrium, tilt);
  std::vector<std::vector<OperatingPoint>> chains;
  if (path == FilmPath::speed_ramp) {
    for (const OperatingPoint& journal : journals) {
      auto& chain = chains.emplace_back();
      for (const double speed : equilibrium.speeds) chain.push_back(at_speed(journal, speed));
    }
    return chains;
  }
  for (const double speed : equilibrium.speeds) {
    if (path != FilmPath::cold_start) chains.emplace_back();
    for (const OperatingPoint& journal : journals) {
      if (path == FilmPath::cold_start) chains.emplace_back();
      chains.back().push_back(at_speed(journal, speed));
    }
  }
  return chains;
}

/// The first stable state from other paths at the point of an unstable one.
std::optional<RunningState> stable_instead(const EquilibriumResult& result, const EquilibriumSettings& equilibrium,
                                           double thickness_floor, const RunningState& unstable,
                                           const std::function<bool(double)>& progress) {
  EquilibriumSettings alone = equilibrium;
  alone.speeds = {unstable.requested.speed};
  (unstable.requested.by_load() ? alone.loads : alone.positions) = {unstable.requested.journal};
  for (const FilmPath path : possible_paths(equilibrium)) {
    if (path == unstable.path && !unstable.before) continue;
    EquilibriumResult other = find_states(result.bearing, alone, thickness_floor, {path}, progress);
    RunningState& found = other.states.front();
    if (found.report.status == Status::interrupted) return std::nullopt;
    if (!found.found() || found.held.is_stable() != true) continue;
    found.instead_of_unstable = true;
    return std::move(found);
  }
  return std::nullopt;
}

}  // namespace

void add_least_torque_speeds(EquilibriumResult& result) {
  if (!result.bearing->film->surroundings.asperities) return;
  for (RunningState& state : result.states) {
    // States of the same path, journal and direction of rotation, by increasing speed.
    std::vector<const RunningState*> curve;
    for (const RunningState& other : result.states) {
      if (other.path == state.path && other.requested.control == state.requested.control &&
          other.requested.journal == state.requested.journal && other.requested.speed * state.requested.speed >= 0.0) {
        curve.push_back(&other);
      }
    }
    std::stable_sort(curve.begin(), curve.end(), [](const RunningState* a, const RunningState* b) {
      return std::abs(a->requested.speed) < std::abs(b->requested.speed);
    });
    // From rest, the torque jumps before it falls.
    std::optional<double> least;
    for (std::size_t i = 1; i + 1 < curve.size() && !least; ++i) {
      if (curve[i - 1]->requested.speed == 0.0) continue;
      least = least_torque_between({curve[i - 1], curve[i], curve[i + 1]});
    }
    state.least_torque_speed = least;
  }
}

bool EquilibriumResult::converged() const {
  const auto found = [](const auto& one) { return one.found(); };
  return std::all_of(states.begin(), states.end(), found) && std::all_of(limits.begin(), limits.end(), found);
}

std::vector<RunningState> planned_states(const EquilibriumSettings& equilibrium, Status status) {
  std::vector<RunningState> states;
  for (const auto& chain : chains_of(equilibrium.path, equilibrium, {})) {
    plan(equilibrium.path, chain, status, states);
  }
  return states;
}

std::vector<FilmPath> possible_paths(const EquilibriumSettings& equilibrium) {
  std::vector<FilmPath> paths{FilmPath::speed_ramp, FilmPath::position_ray, FilmPath::cold_start};
  if (!equilibrium.loads.empty()) paths.insert(paths.begin(), FilmPath::load_ramp);
  return paths;
}

BearingModel require_running_bearing(const Case& input) {
  static_cast<void>(input.settings.get<EquilibriumSettings>());  // reports a missing table
  return make_film_bearing(input);
}

EquilibriumResult run_equilibrium(const Case& input, std::vector<FilmPath> paths,
                                  const std::function<bool(double)>& progress, StateCheckers* checkers) {
  const auto bearing = std::make_shared<const BearingModel>(require_running_bearing(input));
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  if (paths.empty()) paths.push_back(equilibrium.path);
  EquilibriumResult result = find_states(bearing, equilibrium, thickness_floor(input), paths, progress, checkers);
  add_least_torque_speeds(result);
  if (!equilibrium.prefer_stable || paths.size() > 1) return result;
  for (RunningState& state : result.states) {
    if (!state.found() || state.held.is_stable() != false) continue;
    const auto keep_going = [&](double) { return !progress || progress(1.0); };
    if (auto better = stable_instead(result, equilibrium, thickness_floor(input), state, keep_going)) {
      state = std::move(*better);
      if (checkers) check_state(result.bearing, equilibrium, true, state);
    }
  }
  return result;
}

EquilibriumResult find_states(const SharedBearing& bearing, const EquilibriumSettings& equilibrium,
                              double thickness_floor, const std::vector<FilmPath>& paths,
                              const std::function<bool(double)>& progress, StateCheckers* checkers) {
  EquilibriumResult result;
  result.bearing = bearing;
  const std::size_t states =
      paths.size() * equilibrium.speeds.size() * std::max(equilibrium.loads.size(), equilibrium.positions.size());
  result.states.reserve(states);  // so that references stay valid during the checks
  PathWalker walker(equilibrium, thickness_floor, result, progress, checkers, states);
  try {
    for (const FilmPath path : paths) {
      for (const auto& chain : chains_of(path, equilibrium, bearing->film->surroundings.tilt)) walker.walk(path, chain);
    }
  } catch (...) {
    if (checkers) checkers->finish();
    throw;
  }
  if (checkers) checkers->finish();
  return result;
}

}  // namespace bumpfoil
