#include "bumpfoil/experiments/equilibrium/film_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Steps of the search, and the length of the last, relative to the value.
constexpr double step_factor = 1.25;
constexpr int max_steps = 60;
constexpr double last_step = 1e-3;

/// Looks for one limit along a path. What is asked of the film is a demand, 1 at the start: load, or one over speed.
class LimitSearch {
 public:
  LimitSearch(FilmStepper& stepper, double threshold, FilmLimitKind kind, const OperatingPoint& start)
      : stepper_(stepper), threshold_(threshold), kind_(kind), start_(start) {}

  FilmLimit find(const BearingState& state) {
    Place here{1.0, thickness(state), state, 0};
    Place there = here;
    const bool begins_thick = is_thick(here);
    for (int i = 0; is_thick(there) == begins_thick; ++i) {
      if (i > 0) here = there;
      // A film that is too thin at the start and cannot be followed to where it is thicker.
      if (i == max_steps || std::isnan(here.h)) return nothing(Status::not_converged);
      there = go(here, begins_thick ? here.demand * step_factor : here.demand / step_factor);
      if (interrupted_) return nothing(Status::interrupted);
    }
    Place thick = begins_thick ? here : there;
    Place thin = begins_thick ? there : here;
    while (thin.demand - thick.demand > last_step * thick.demand) {
      const Place middle = go(thick, 0.5 * (thick.demand + thin.demand));
      if (interrupted_) return nothing(Status::interrupted);
      (is_thick(middle) ? thick : thin) = middle;
    }
    FilmLimit limit = nothing(Status::converged);
    limit.thick = point(thick.demand);
    limit.thin = point(thin.demand);
    limit.h_thick = thick.h;
    limit.h_thin = thin.h;
    limit.jumps = std::max(thick.jumps, thin.jumps);
    limit.stable = stepper_.held_motions(thick.state).is_stable();
    const double part = std::isnan(thin.h) ? 0.0 : (thick.h - threshold_) / (thick.h - thin.h);
    limit.value = size_of(limit.thick) + part * (size_of(limit.thin) - size_of(limit.thick));
    return limit;
  }

  /// Nothing is known but where the search began.
  [[nodiscard]] FilmLimit nothing(Status status) const {
    constexpr double absent = std::numeric_limits<double>::quiet_NaN();
    return {.kind = kind_,
            .status = status,
            .thick = start_,
            .thin = start_,
            .h_thick = absent,
            .h_thin = absent,
            .value = absent,
            .jumps = 0,
            .stable = {}};
  }

 private:
  struct Place {
    double demand{};
    double h{};  ///< minimum film thickness, m; not a number where there is no film
    BearingState state;
    int jumps{};  ///< on the way from the start
  };

  [[nodiscard]] bool is_thick(const Place& place) const { return place.h >= threshold_; }

  [[nodiscard]] OperatingPoint point(double demand) const {
    OperatingPoint point = start_;
    if (kind_ == FilmLimitKind::lift_off_speed) {
      point.speed /= demand;
    } else {
      point.journal *= demand;
    }
    return point;
  }

  [[nodiscard]] double size_of(const OperatingPoint& point) const {
    return kind_ == FilmLimitKind::lift_off_speed ? std::abs(point.speed) : point.journal.norm();
  }

  [[nodiscard]] double thickness(const BearingState& state) const {
    return stepper_.bearing().scales.thickness * state.film.thickness.minCoeff();
  }

  /// One increment.
  Place go(const Place& from, double demand) {
    Place to{demand, std::numeric_limits<double>::quiet_NaN(), from.state, from.jumps};
    const FilmReport report = follow(stepper_, point(demand), to.state);
    to.jumps += report.jumps;
    interrupted_ = report.status == Status::interrupted;
    if (report.status == Status::converged) to.h = thickness(to.state);
    return to;
  }

  FilmStepper& stepper_;
  double threshold_;
  FilmLimitKind kind_;
  OperatingPoint start_;
  bool interrupted_{};
};

/// One limit, from the end of a load ramp.
FilmLimit find_limit(const SharedFilmBearing& bearing, const Case& input, FilmLimitKind kind, double speed,
                     const Eigen::Vector2d& load, const std::function<bool()>& keep_going) {
  EquilibriumSettings at_start = *input.equilibrium;
  at_start.speeds = {speed};
  at_start.loads = {load};
  const EquilibriumResult begin =
      find_states(bearing, at_start, input.film.h_floor, {FilmPath::load_ramp}, [&](double) { return keep_going(); });
  const RunningState& start = begin.states.front();
  FilmStepper stepper(bearing, {.newton = {.thickness_floor = input.film.h_floor / bearing->scales.thickness},
                                .keep_going = keep_going});
  LimitSearch search(stepper, *input.film.h_lift_off, kind, start.asked);
  return start.found() ? search.find(*start.last) : search.nothing(start.report.status);
}

/// Where a value stands in a list that it was taken from.
template <typename Value>
std::size_t place_in(const std::vector<Value>& list, const Value& value) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin());
}

std::vector<FilmLimit> find_limits(const SharedFilmBearing& bearing, const Case& input,
                                   const std::function<bool(double)>& progress) {
  const EquilibriumSettings& equilibrium = *input.equilibrium;
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
  return find_limits(std::make_shared<const FilmBearing>(make_film_bearing(input)), input, progress);
}

void add_film_limits(const Case& input, EquilibriumResult& result, const std::function<bool(double)>& progress) {
  require_valid(input, {"limits"});
  result.with_limits = true;
  result.limits = find_limits(result.bearing, input, progress);
  const std::vector<double>& speeds = input.equilibrium->speeds;
  const std::vector<Eigen::Vector2d>& loads = input.equilibrium->loads;
  const auto value_at = [&result](std::size_t place) {
    const FilmLimit& limit = result.limits[place];
    return limit.found() ? std::optional(limit.value) : std::nullopt;
  };
  for (RunningState& state : result.states) {
    state.lift_off_speed = value_at(place_in(loads, state.asked.journal));
    state.load_capacity = value_at(loads.size() + place_in(speeds, state.asked.speed));
  }
}

}  // namespace bumpfoil
