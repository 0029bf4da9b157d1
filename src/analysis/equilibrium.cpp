#include "bumpfoil/analysis/equilibrium.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "bumpfoil/analysis/film_fields.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case_names.hpp"

namespace bumpfoil {
namespace {

/// Where journals are held at the cold start of a path, in C_r less the largest lobe: along the load, and at most on
/// the way to a position.
constexpr double start_along_load = 0.6;
constexpr double start_towards_position = 0.7;
/// Least room in a clearance that is opened, m.
constexpr double least_opened_room = 10e-6;
/// A ramp of speeds comes from this part of its first.
constexpr double coasting_from = 1.5;

OperatingPoint at_speed(OperatingPoint point, double speed) {
  point.speed = speed;
  return point;
}

/// By how much the clearance is opened, m, for a path to begin: where foils leave no room, until they leave c and at
/// least least_opened_room.
double opening_to_begin(const FilmBearing& bearing) {
  return bearing.room > 0.0 ? 0.0 : std::max(bearing.scales.thickness, least_opened_room) - bearing.room;
}

/// Walks along paths and keeps what is found.
class PathWalker {
 public:
  PathWalker(const Case& input, EquilibriumResult& result, const std::function<bool(double)>& progress,
             std::size_t states)
      : result_(result),
        progress_(progress),
        states_(states),
        settings_(*input.equilibrium),
        opening_(opening_to_begin(*result.bearing)),
        solver_(*result.bearing, options_of(input)) {}

  /// The states at `points`, one after the other.
  void walk(FilmPath path, const std::vector<OperatingPoint>& points) {
    state_.reset();
    for (const OperatingPoint& point : points) {
      done_of_state_ = 0.0;
      RunningState& found = result_.states.emplace_back();
      found.path = path;
      found.asked = point;
      const auto begin = std::chrono::steady_clock::now();
      found.report.status = FilmStatus::converged;
      if (!reached_) {
        found.report.status = FilmStatus::not_reached;
      } else if (state_) {
        go(point, found.report);
      } else {
        start(path, point, found.report);
      }
      reached_ = found.found();
      if (state_ && found.report.status != FilmStatus::not_reached) judge(found);
      found.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    reached_ = true;
  }

 private:
  FilmBearingOptions options_of(const Case& input) const {
    FilmBearingOptions options;
    options.newton.thickness_floor = input.film.h_floor / result_.bearing->scales.thickness;
    options.keep_going = [this] { return !progress_ || progress_(fraction()); };
    return options;
  }

  [[nodiscard]] double fraction() const {
    const double done = static_cast<double>(std::max<std::size_t>(result_.states.size(), 1) - 1);
    return (done + done_of_state_) / static_cast<double>(states_);
  }

  void judge(RunningState& found) {
    found.last = state_;
    found.outcome = film_bearing_outcome(*result_.bearing, *state_);
    found.stiffness = solver_.stiffness(*state_);
    found.stuck_stiffness = solver_.stiffness(*state_, true);
    found.whirls = whirls();
    find_stresses(found);
  }

  /// The largest ones of all pads.
  void find_stresses(RunningState& found) const {
    const Foils& foils = *result_.foils;
    const FilmBearing& bearing = *result_.bearing;
    const Vector x = foil_state(foils, bearing, *state_).contacts.x;
    const Eigen::Index size = foils.structure.dofs.size;
    for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
      const FilmPad& pad = bearing.pads[k];
      const StressModel& model = foils.stress[k];
      const double moment = pad.foil.stiffness * pad.foil.pitch * bearing.scales.thickness;
      const double top = moment * state_->foil.moment(pad.columns()).cwiseAbs().maxCoeff() / model.top_section_modulus;
      found.top_foil_stress = std::max(found.top_foil_stress.value_or(0.0), top);
      const auto [first, count] = foils.structure.blocks_of(static_cast<int>(k));
      const FoilStress stress = foil_stress(model, x.segment(first * size, count * size));
      if (stress.bump_largest.size() == 0) continue;
      found.bump_foil_stress = std::max(
          {found.bump_foil_stress.value_or(0.0), stress.bump_largest.maxCoeff(), stress.bump_weld.value_or(0.0)});
    }
  }

  [[nodiscard]] std::vector<FilmWhirl> whirls() {
    std::vector<double> frequencies = settings_.frequencies;
    if (frequencies.empty()) frequencies.push_back(std::abs(state_->speed));
    std::vector<std::complex<double>> rates;
    rates.reserve(frequencies.size());
    for (const double frequency : frequencies) rates.emplace_back(0.0, frequency);
    const auto moving = solver_.impedances(*state_, rates);
    const auto stuck = solver_.impedances(*state_, rates, true);
    std::vector<FilmWhirl> whirls(frequencies.size());
    for (std::size_t i = 0; i < whirls.size(); ++i) {
      whirls[i].frequency = frequencies[i];
      if (moving) whirls[i].impedance = (*moving)[i];
      if (stuck) whirls[i].stuck_impedance = (*stuck)[i];
    }
    return whirls;
  }

  static void add(FilmReport& total, const FilmReport& more) {
    total.status = more.status;
    total.iterations += more.iterations;
    total.factorisations += more.factorisations;
    total.residual = more.residual;
    total.jumps += more.jumps;
  }

  /// From rest to the first state of a path: with a clearance that is opened where it has to be, and closes at the end.
  void start(FilmPath path, const OperatingPoint& point, FilmReport& total) {
    const bool by_load = point.control == OperatingPoint::Control::load;
    OperatingPoint opened = point;
    opened.opening = opening_;
    switch (path) {
      case FilmPath::load_ramp:
        begin_gently(along(point), point.speed, total);
        ramp(opened, total);
        break;
      case FilmPath::position_ray:
        if (by_load) {
          begin(Eigen::Vector2d::Zero(), point.speed, total);
          ramp(OperatingPoint::held_at(along(point), point.speed, opening_), total);
        } else {
          begin_gently(towards(point), point.speed, total);
        }
        ramp(opened, total);
        break;
      case FilmPath::speed_ramp:
        start(by_load ? FilmPath::load_ramp : FilmPath::position_ray, at_speed(point, coasting_from * point.speed),
              total);
        ramp(point, total);
        break;
      case FilmPath::cold_start:
        begin(by_load ? along(point) : point.journal, point.speed, total);
        if (by_load && total.status == FilmStatus::converged) {
          add(total, solver_.settle(opened, state_->contact, *state_));
        }
        break;
    }
    if (state_ && state_->opening > 0.0) ramp(point, total);
  }

  [[nodiscard]] Eigen::Vector2d along(const OperatingPoint& point) const {
    return start_along_load * (result_.bearing->room + opening_) * point.journal.normalized();
  }

  [[nodiscard]] Eigen::Vector2d towards(const OperatingPoint& point) const {
    const double farthest = start_towards_position * (result_.bearing->room + opening_);
    return point.journal.norm() <= farthest ? point.journal : Eigen::Vector2d(farthest * point.journal.normalized());
  }

  void begin(const Eigen::Vector2d& position, double speed, FilmReport& total) {
    FilmBearingState started;
    add(total, solver_.cold_start(position, speed, started, opening_));
    if (total.status == FilmStatus::converged) state_ = std::move(started);
  }

  /// begin(); where that throws the foil onto the journal, at the centre instead, and from there on to the position.
  void begin_gently(const Eigen::Vector2d& position, double speed, FilmReport& total) {
    begin(position, speed, total);
    if (total.status != FilmStatus::touchdown) return;
    begin(Eigen::Vector2d::Zero(), speed, total);
    ramp(OperatingPoint::held_at(position, speed, opening_), total);
  }

  /// On to a point in equal increments; a point that is there already takes none.
  void ramp(const OperatingPoint& point, FilmReport& total) {
    if (total.status != FilmStatus::converged) return;
    OperatingPoint from = point;
    from.speed = state_->speed;
    from.opening = state_->opening;
    from.journal = point.control == OperatingPoint::Control::load
                       ? film_force(*result_.bearing, state_->foil.film.pressure)
                       : state_->position;
    if (from == point) return;
    for (int i = 1; i <= settings_.steps && total.status == FilmStatus::converged; ++i) {
      const double part = static_cast<double>(i) / settings_.steps;
      OperatingPoint to = point;
      to.journal = from.journal + part * (point.journal - from.journal);
      to.speed = from.speed + part * (point.speed - from.speed);
      to.opening = from.opening + part * (point.opening - from.opening);
      done_of_state_ = part - 1.0 / settings_.steps;
      go(to, total);
    }
  }

  /// One increment.
  void go(const OperatingPoint& to, FilmReport& total) { add(total, solver_.follow(to, state_->contact, *state_)); }

  EquilibriumResult& result_;
  const std::function<bool(double)>& progress_;
  std::size_t states_;
  const EquilibriumSettings& settings_;
  double opening_;  ///< of the clearance where a path begins, m
  double done_of_state_{};
  bool reached_{true};
  FilmBearingSolver solver_;
  std::optional<FilmBearingState> state_;  ///< where the path is
};

/// All loads or positions, at speed 0.
std::vector<OperatingPoint> journal_points(const EquilibriumSettings& equilibrium) {
  const bool by_load = !equilibrium.loads.empty();
  std::vector<OperatingPoint> points;
  for (const Eigen::Vector2d& value : by_load ? equilibrium.loads : equilibrium.positions) {
    points.push_back(by_load ? OperatingPoint::loaded_by(value, 0.0) : OperatingPoint::held_at(value, 0.0));
  }
  return points;
}

/// States that follow from one another on a path.
std::vector<std::vector<OperatingPoint>> chains_of(FilmPath path, const EquilibriumSettings& equilibrium) {
  const std::vector<OperatingPoint> journals = journal_points(equilibrium);
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

}  // namespace

bool EquilibriumResult::converged() const {
  const auto found = [](const auto& one) { return one.found(); };
  return std::all_of(states.begin(), states.end(), found) && std::all_of(limits.begin(), limits.end(), found);
}

std::vector<OperatingPoint> asked_points(const EquilibriumSettings& equilibrium) {
  std::vector<OperatingPoint> points;
  for (const auto& chain : chains_of(equilibrium.path, equilibrium)) {
    points.insert(points.end(), chain.begin(), chain.end());
  }
  return points;
}

std::vector<FilmPath> possible_paths(const EquilibriumSettings& equilibrium) {
  std::vector<FilmPath> paths{FilmPath::speed_ramp, FilmPath::position_ray, FilmPath::cold_start};
  if (!equilibrium.loads.empty()) paths.insert(paths.begin(), FilmPath::load_ramp);
  return paths;
}

FilmBearing require_running_bearing(const Case& input) {
  if (!input.equilibrium) {
    throw Error(ErrorKind::input, {{"", 0, "equilibrium", "", "this table is missing", "add [equilibrium]"}});
  }
  return make_film_bearing(input);
}

EquilibriumResult run_equilibrium(const Case& input, std::vector<FilmPath> paths,
                                  const std::function<bool(double)>& progress) {
  EquilibriumResult result;
  result.bearing = std::make_shared<const FilmBearing>(require_running_bearing(input));
  result.foils = make_bearing_foils(input);
  const EquilibriumSettings& equilibrium = *input.equilibrium;
  if (paths.empty()) paths.push_back(equilibrium.path);
  const std::size_t states =
      paths.size() * equilibrium.speeds.size() * std::max(equilibrium.loads.size(), equilibrium.positions.size());
  PathWalker walker(input, result, progress, states);
  for (const FilmPath path : paths) {
    for (const auto& chain : chains_of(path, equilibrium)) walker.walk(path, chain);
  }
  return result;
}

}  // namespace bumpfoil
