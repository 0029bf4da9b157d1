#include "bumpfoil/experiments/equilibrium/film_limits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Relative step of the search, and length of the last.
constexpr double step_factor = 1.25;
constexpr int max_steps = 60;
constexpr double last_step = 1e-3;
/// Maximum number of steps below the first load in search of a stable state: to a tenth of it.
constexpr int max_smaller_loads = 10;

/// Searches one limit along a path. The demand on the film, load or reciprocal speed, is 1 at the start.
class LimitSearch {
 public:
  LimitSearch(FilmStepper& stepper, double threshold, FilmLimitKind kind, const OperatingPoint& start)
      : stepper_(stepper), threshold_(threshold), kind_(kind), start_(start) {}

  FilmLimit find(const BearingState& state) {
    path_ = {place(1.0, state, 0)};
    const Status status = cross_threshold();
    if (status == Status::converged && kind_ == FilmLimitKind::load_capacity) look_at_smaller_loads();
    if (status == Status::converged) resolve();
    return interrupted_ ? nothing(Status::interrupted) : status == Status::converged ? result() : nothing(status);
  }

  /// A failed search: only its start is known.
  [[nodiscard]] FilmLimit nothing(Status status) const {
    return {.kind = kind_,
            .status = status,
            .thick = start_,
            .thin = start_,
            .h_thick = absent,
            .h_thin = absent,
            .value = absent};
  }

 private:
  struct Place {
    double demand{};
    double h{absent};  ///< minimum film thickness, m
    BearingState state;
    int jumps{};                   ///< since the start
    std::optional<bool> stable{};  ///< known only if the film is thick enough
  };
  using Places = std::vector<Place>;

  [[nodiscard]] bool is_thick(const Place& place) const { return place.h >= threshold_; }
  [[nodiscard]] bool counts(const Place& place) const { return is_thick(place) && place.stable.value_or(true); }

  /// From the start to the crossing of the threshold. Leaves the path sorted by demand.
  Status cross_threshold() {
    const bool begins_thick = is_thick(path_.front());
    for (int i = 0; is_thick(path_.back()) == begins_thick && !interrupted_; ++i) {
      // The film is too thin at the start, and the path to a thicker one fails.
      if (i == max_steps || std::isnan(path_.back().h)) return Status::not_converged;
      const double demand = path_.back().demand;
      path_.push_back(go(path_.back(), begins_thick ? demand * step_factor : demand / step_factor));
    }
    if (!begins_thick) std::reverse(path_.begin(), path_.end());
    return Status::converged;
  }

  /// If no state of the path is valid, one under a smaller load may be.
  void look_at_smaller_loads() {
    if (std::any_of(path_.begin(), path_.end(), [this](const Place& place) { return counts(place); })) return;
    for (int i = 0; i < max_smaller_loads && !counts(path_.front()) && !interrupted_; ++i) {
      Place smaller = go(path_.front(), path_.front().demand / step_factor);
      if (!is_thick(smaller)) return;
      path_.insert(path_.begin(), std::move(smaller));
    }
  }

  /// Halves steps between two states of which only one is thick enough, or stable.
  void resolve() {
    for (std::size_t i = 0; i + 1 < path_.size() && !interrupted_;) {
      const Place& here = path_[i];
      const Place& next = path_[i + 1];
      const bool alike = is_thick(here) == is_thick(next) && counts(here) == counts(next);
      if (alike || next.demand - here.demand <= last_step * here.demand) {
        ++i;
      } else {
        path_.insert(path_.begin() + static_cast<std::ptrdiff_t>(i) + 1, go(here, 0.5 * (here.demand + next.demand)));
      }
    }
  }

  /// The limit on a path that crosses the threshold.
  [[nodiscard]] FilmLimit result() const {
    const auto end =
        std::find_if_not(path_.begin(), path_.end(), [this](const Place& place) { return is_thick(place); });
    const auto behind_last = std::find_if(std::reverse_iterator(end), path_.rend(), [this](const Place& place) {
                               return counts(place);
                             }).base();
    const bool any = behind_last != path_.begin();
    const Place& thick = *std::prev(any ? behind_last : end);
    const Place& thin = any ? *behind_last : *end;
    FilmLimit limit{.kind = kind_,
                    .status = Status::converged,
                    .bounded_by = !any || is_thick(thin) ? LimitBound::stability
                                  : std::isnan(thin.h)   ? LimitBound::end_of_path
                                                         : LimitBound::film_thickness,
                    .thick = point(thick.demand),
                    .thin = point(thin.demand),
                    .h_thick = thick.h,
                    .h_thin = thin.h,
                    .value = any ? size_at(thick.demand) : absent,
                    .jumps = std::max(thick.jumps, thin.jumps),
                    .stable = thick.stable};
    if (limit.bounded_by == LimitBound::film_thickness) {
      limit.value += (thick.h - threshold_) / (thick.h - thin.h) * (size_at(thin.demand) - limit.value);
    }
    add_unstable(end, limit);
    return limit;
  }

  /// Adds states that are or may be unstable, on the path before `end`.
  void add_unstable(Places::const_iterator end, FilmLimit& limit) const {
    bool goes_on = false;
    for (auto place = path_.begin(); place != end; ++place) {
      if (!place->stable) ++limit.unknown;
      if (!counts(*place)) {
        const double size = size_at(place->demand);
        if (!goes_on) limit.unstable.push_back({size, size});
        UnstableRange& range = limit.unstable.back();
        range = {std::min(range.from, size), std::max(range.to, size)};
      }
      goes_on = !counts(*place);
    }
    std::sort(limit.unstable.begin(), limit.unstable.end(),
              [](const UnstableRange& a, const UnstableRange& b) { return a.from < b.from; });
  }

  [[nodiscard]] OperatingPoint point(double demand) const {
    OperatingPoint point = start_;
    if (kind_ == FilmLimitKind::lift_off_speed) {
      point.speed /= demand;
    } else {
      point.journal *= demand;
    }
    return point;
  }

  /// |Omega| or the load.
  [[nodiscard]] double size_at(double demand) const {
    return kind_ == FilmLimitKind::lift_off_speed ? std::abs(point(demand).speed) : point(demand).journal.norm();
  }

  /// A place with its film thickness and stability.
  Place place(double demand, const BearingState& state, int jumps) {
    Place found{.demand = demand,
                .h = stepper_.film().scales.thickness * state.film.thickness.minCoeff(),
                .state = state,
                .jumps = jumps};
    if (is_thick(found)) found.stable = stepper_.held_motions(state).is_stable();
    return found;
  }

  /// One increment.
  Place go(const Place& from, double demand) {
    BearingState state = from.state;
    const FilmReport report = follow(stepper_, point(demand), state);
    const int jumps = from.jumps + report.jumps;
    interrupted_ = interrupted_ || report.status == Status::interrupted;
    if (report.status == Status::converged) return place(demand, state, jumps);
    return {.demand = demand, .state = std::move(state), .jumps = jumps};
  }

  FilmStepper& stepper_;
  double threshold_;
  FilmLimitKind kind_;
  OperatingPoint start_;
  Places path_;  ///< by increasing demand, once the threshold is crossed
  bool interrupted_{};
};

/// One limit, from the end of a load ramp.
FilmLimit find_limit(const SharedBearing& bearing, const Case& input, FilmLimitKind kind, double speed,
                     const Eigen::Vector2d& load, const std::function<bool()>& keep_going) {
  EquilibriumSettings at_start = input.settings.get<EquilibriumSettings>();
  at_start.speeds = {speed};
  at_start.loads = {load};
  const EquilibriumResult begin = find_states(bearing, at_start, thickness_floor(input), {FilmPath::load_ramp},
                                              [&](double) { return keep_going(); });
  const RunningState& start = begin.states.front();
  FilmStepper stepper(bearing, {.newton = {.thickness_floor = thickness_floor(input) / bearing->film->scales.thickness},
                                .keep_going = keep_going});
  LimitSearch search(stepper, *input.film.h_lift_off, kind, start.requested);
  return start.found() ? search.find(*start.last) : search.nothing(start.report.status);
}

/// Index of a value in the list it was taken from.
template <typename Value>
std::size_t place_in(const std::vector<Value>& list, const Value& value) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin());
}

std::vector<FilmLimit> find_limits(const SharedBearing& bearing, const Case& input,
                                   const std::function<bool(double)>& progress) {
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  const auto total = static_cast<double>(equilibrium.loads.size() + equilibrium.speeds.size());
  std::vector<FilmLimit> limits;
  const auto keep_going = [&] { return !progress || progress(static_cast<double>(limits.size()) / total); };
  for (const Eigen::Vector2d& load : equilibrium.loads) {
    limits.push_back(
        find_limit(bearing, input, FilmLimitKind::lift_off_speed, equilibrium.speeds.front(), load, keep_going));
  }
  for (const double speed : equilibrium.speeds) {
    limits.push_back(
        find_limit(bearing, input, FilmLimitKind::load_capacity, speed, equilibrium.loads.front(), keep_going));
  }
  return limits;
}

}  // namespace

std::vector<FilmLimit> run_film_limits(const Case& input, const std::function<bool(double)>& progress) {
  require_valid(input, {"limits"});
  return find_limits(std::make_shared<const BearingModel>(make_film_bearing(input)), input, progress);
}

void add_film_limits(const Case& input, EquilibriumResult& result, const std::function<bool(double)>& progress) {
  require_valid(input, {"limits"});
  result.with_limits = true;
  result.limits = find_limits(result.bearing, input, progress);
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  for (RunningState& state : result.states) {
    state.lift_off_speed = result.limits[place_in(equilibrium.loads, state.requested.journal)];
    state.load_capacity = result.limits[equilibrium.loads.size() + place_in(equilibrium.speeds, state.requested.speed)];
  }
}

}  // namespace bumpfoil
