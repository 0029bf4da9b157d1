#include "experiments/stability/stability_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): for the tables below

/// A larger error of a shaft reduction is reported.
constexpr double tolerated_reduction_error = 1e-3;

/// A quantity of the fastest growing motion.
template <bool of_stuck, auto value>
double of_fastest(const StabilityResult&, const SpeedPoint& point) {
  const auto& motions = point.motions(of_stuck);
  return motions && !motions->whirls.empty() ? value(motions->whirls.front(), std::abs(point.speed)) : absent;
}
double growth(const Whirl& whirl, double speed) {
  return whirl.rate.real() / speed;
}
double whirl_ratio(const Whirl& whirl, double speed) {
  return whirl.rate.imag() / speed;
}
double log_decrement(const Whirl& whirl, double /*speed*/) {
  const double decrement = whirl.log_decrement();
  return std::isfinite(decrement) ? decrement : absent;
}
double sense(const Whirl& whirl, double /*speed*/) {
  return static_cast<double>(sense_of(whirl));
}
double belongs_to_foils(const Whirl& whirl, double /*speed*/) {
  return whirl.is_of_foils() ? 1.0 : 0.0;
}

template <bool of_stuck>
double growth_by_coefficients(const StabilityResult&, const SpeedPoint& point) {
  const auto& motions = point.motions(of_stuck);
  return motions && motions->by_coefficients ? motions->by_coefficients->real() / std::abs(point.speed) : absent;
}

double thinnest(const StabilityResult& result, const SpeedPoint& point) {
  return result.machine.thinnest_film(point.states);
}

/// The first onset of a kind at increasing |Omega|.
const WhirlOnset* first_onset(const StabilityResult& result, bool stuck, bool by_coefficients) {
  const WhirlOnset* first = nullptr;
  for (const WhirlOnset& found : result.map.onsets) {
    if (found.stuck != stuck || found.by_coefficients != by_coefficients || !found.begins) continue;
    if (first == nullptr || std::abs(found.onset.speed) < std::abs(first->onset.speed)) first = &found;
  }
  return first;
}
template <bool stuck, bool by_coefficients, double Onset::*member>
double of_first_onset(const StabilityResult& result) {
  const WhirlOnset* const first = first_onset(result, stuck, by_coefficients);
  return first == nullptr ? absent : first->onset.*member;
}

/// Speed points by increasing |Omega|.
std::vector<const SpeedPoint*> from_the_lowest(const StabilityResult& result) {
  std::vector<const SpeedPoint*> rising;
  for (const SpeedPoint& point : result.map.points) rising.push_back(&point);
  std::stable_sort(rising.begin(), rising.end(),
                   [](const SpeedPoint* a, const SpeedPoint* b) { return std::abs(a->speed) < std::abs(b->speed); });
  return rising;
}

/// The lowest |Omega| of an onset between two neighbours, with sliding or sticking contacts; the lower neighbour if
/// none was found.
double lowest_onset(const StabilityResult& result, double low, double high) {
  double lowest = high;
  bool found_any = false;
  for (const WhirlOnset& found : result.map.onsets) {
    const double speed = std::abs(found.onset.speed);
    if (found.by_coefficients || speed < low || speed > lowest) continue;
    lowest = speed;
    found_any = true;
  }
  return found_any ? lowest : low;
}

double stable_up_to(const StabilityResult& result) {
  double reached = absent;
  for (const SpeedPoint* const point : from_the_lowest(result)) {
    const std::optional<bool> stable = is_stable(*point);
    if (!stable) break;
    const double speed = std::abs(point->speed);
    if (!*stable) return std::isnan(reached) ? 0.0 : lowest_onset(result, reached, speed);
    reached = speed;
  }
  return reached;
}

double stable_throughout(const StabilityResult& result) {
  bool known = true;
  for (const SpeedPoint& point : result.map.points) {
    const std::optional<bool> stable = is_stable(point);
    if (stable == false) return 0.0;
    known = known && stable;
  }
  return known ? 1.0 : absent;
}

double unstable_at_lowest(const StabilityResult& result) {
  const std::optional<bool> stable = is_stable(*from_the_lowest(result).front());
  return stable ? (*stable ? 0.0 : 1.0) : absent;
}

constexpr auto stability_quantity_table = std::to_array<StabilityQuantity>({
    {"status",
     "",
     "how the search for the equilibria ended: that of the last speed that was looked for",
     [](const StabilityResult& result) {
       Status status = Status::not_reached;
       for (const SpeedPoint& point : result.map.points) {
         if (point.status != Status::not_reached) status = point.status;
       }
       return static_cast<double>(status);
     },
     sampled,
     "",
     {},
     search_status},
    // Without an onset a rotor is stable at all speeds, or at none: stable_up_to says which.
    {"onset_speed", "rad/s", "lowest speed at which whirl begins, sliding contacts keep sliding",
     of_first_onset<false, false, &Onset::speed>, headline | leading | sampled | no_limits, "onset of whirl",
     shown::revolutions},
    {"onset_whirl_ratio", "1", "whirl frequency at the onset over the speed of rotation",
     of_first_onset<false, false, &Onset::whirl_ratio>, headline | sampled | no_limits, "whirl ratio at the onset",
     shown::unitless},
    {"onset_speed_stuck", "rad/s", "lowest speed at which whirl begins, full stick",
     of_first_onset<true, false, &Onset::speed>, headline | sampled | no_limits, "onset, stuck", shown::revolutions},
    {"onset_whirl_ratio_stuck", "1", "whirl frequency at the onset over the speed of rotation",
     of_first_onset<true, false, &Onset::whirl_ratio>, sampled | no_limits, "whirl ratio at the onset",
     shown::unitless},
    {"onset_speed_by_coefficients", "rad/s",
     "lowest speed at which whirl begins by synchronous coefficients, sliding contacts keep sliding",
     of_first_onset<false, true, &Onset::speed>, headline | sampled | no_limits, "by synchronous K, C",
     shown::revolutions},
    {"onset_speed_by_coefficients_stuck", "rad/s",
     "lowest speed at which whirl begins by synchronous coefficients, full stick",
     of_first_onset<true, true, &Onset::speed>, sampled | no_limits, "by synchronous K, C, stuck", shown::revolutions},
    {"stable_up_to", "rad/s",
     "magnitude of the speed up to which all motions are known to decay, contacts sliding and stuck, from the lowest "
     "one on: that of the first onset, or the highest one; 0 if the lowest one is unstable",
     stable_up_to, headline | key_figure | sampled, "stable up to", shown::revolutions},
    {"stable_throughout", "1", "whether all motions decay at all speeds, contacts sliding and stuck", stable_throughout,
     sampled, "stable at all speeds", shown::unitless, yes_or_no},
    {"unstable_at_lowest", "1", "whether a motion grows at the lowest speed", unstable_at_lowest, sampled,
     "unstable at the lowest speed", shown::unitless, yes_or_no},
    {"load_of_rotor", "N", "weight of the rotor",
     [](const StabilityResult& result) {
       double sum = 0.0;
       for (const Eigen::Vector2d& load : result.machine.loads) sum += load.norm();
       return sum;
     },
     none, "weight on the bearings", shown::newtons},
    {"reduction_error", "1", "largest error of a natural frequency of the reduced shaft in the range of interest",
     [](const StabilityResult& result) { return result.machine.reduction_error; }, of_solver},
});

// Tables of the terminal show what is shown first in this order.
constexpr auto speed_quantity_table = std::to_array<SpeedQuantity>({
    {"h_min", "m", "minimum film thickness of all bearings", thinnest, shown_first | key_figure,
     "minimum film thickness", shown::micrometres},
    {"growth", "1",
     "growth rate of the motion that grows fastest over the speed of rotation, sliding contacts keep sliding",
     of_fastest<false, growth>, shown_first, "growth", shown::unitless},
    {"whirl_ratio", "1", "damped frequency of the motion that grows fastest over the speed of rotation",
     of_fastest<false, whirl_ratio>, shown_first, "whirl ratio", shown::unitless},
    {"least_log_decrement", "1", "logarithmic decrement of the motion that grows fastest",
     of_fastest<false, log_decrement>, shown_first, "log. decrement", shown::unitless},
    {"fastest_direction", "", "sense of the whirl of the motion that grows fastest, relative to the rotation",
     of_fastest<false, sense>, shown_first, "whirl", shown::unitless, flags<WhirlSense>},
    {"fastest_of_foils", "1", "whether the motion is one of foils and film, in which the rotor takes little part",
     of_fastest<false, belongs_to_foils>, shown_first, "motion of the foils", shown::unitless, yes_or_no},
    {"growth_stuck", "1", "growth rate of the motion that grows fastest over the speed of rotation, full stick",
     of_fastest<true, growth>, shown_first, "growth, stuck", shown::unitless},
    {"growth_by_coefficients", "1",
     "growth over the speed of rotation by synchronous coefficients, sliding contacts keep sliding",
     growth_by_coefficients<false>, shown_first, "growth by synchronous K, C", shown::unitless},
    {"stable", "1", "whether all motions decay, with contacts sliding and stuck",
     [](const StabilityResult&, const SpeedPoint& point) {
       const std::optional<bool> stable = is_stable(point);
       return stable ? (*stable ? 1.0 : 0.0) : absent;
     },
     shown_first, "stable", shown::unitless, yes_or_no},
    {"speed_status", "", "how the search for the equilibrium ended",
     [](const StabilityResult&, const SpeedPoint& point) { return static_cast<double>(point.status); }, none, "status",
     shown::unitless, search_status},
    {"whirl_ratio_stuck", "1",
     "damped frequency of the motion that grows fastest over the speed of rotation, full stick",
     of_fastest<true, whirl_ratio>, none, "whirl ratio, stuck", shown::unitless},
    {"least_log_decrement_stuck", "1", "logarithmic decrement of the motion that grows fastest, full stick",
     of_fastest<true, log_decrement>, none, "log. decrement, stuck", shown::unitless},
    {"fastest_of_foils_stuck", "1", "whether the motion is one of foils and film, in which the rotor takes little part",
     of_fastest<true, belongs_to_foils>, none, "motion of the foils, stuck", shown::unitless, yes_or_no},
    {"growth_by_coefficients_stuck", "1", "growth over the speed of rotation by synchronous coefficients, full stick",
     growth_by_coefficients<true>, none, "growth by synchronous K, C, stuck", shown::unitless},
});

constexpr auto motion_quantity_table = std::to_array<MotionQuantity>({
    {"real", "rad/s", "growth rate: real part of s in exp(s t)",
     [](const SpeedMotion& motion) { return motion.whirl.rate.real(); }, csv, "growth rate"},
    {"imag", "rad/s", "damped frequency: imaginary part of s",
     [](const SpeedMotion& motion) { return motion.whirl.rate.imag(); }, csv, "damped frequency"},
    {"log_decrement", "1", "logarithmic decrement",
     [](const SpeedMotion& motion) { return log_decrement(motion.whirl, 1.0); }, csv, "log. decrement"},
    {"damping_ratio", "1", "damping ratio: -Re s over the modulus of s",
     [](const SpeedMotion& motion) { return motion.whirl.damping_ratio(); }, csv},
    {"direction",
     "",
     "sense of the whirl relative to the rotation",
     [](const SpeedMotion& motion) { return static_cast<double>(sense_of(motion.whirl)); },
     csv,
     "",
     {},
     flags<WhirlSense>},
    {"directivity", "1", "1: forward circle, 0: line, -1: backward circle; mean of all journals",
     [](const SpeedMotion& motion) { return motion.whirl.direction; }, csv},
    {"rotor_share", "1", "part that the inertia of the rotor has in the motion; 0: foils and film alone",
     [](const SpeedMotion& motion) { return motion.whirl.rotor_share; }, csv},
    {"of_foils",
     "1",
     "whether the motion is one of foils and film, in which the rotor takes little part",
     [](const SpeedMotion& motion) { return belongs_to_foils(motion.whirl, 1.0); },
     csv,
     "motion of the foils",
     {},
     yes_or_no},
    {"residual", "1", "smallest singular value of the dynamic stiffness over the largest one",
     [](const SpeedMotion& motion) { return motion.whirl.residual; }, of_solver},
});

}  // namespace

std::span<const StabilityQuantity> stability_quantities() {
  return stability_quantity_table;
}

std::span<const SpeedQuantity> speed_quantities() {
  return speed_quantity_table;
}

WhirlSense sense_of(const Whirl& whirl) {
  return whirl.direction < 0.0 ? WhirlSense::backward : WhirlSense::forward;
}

std::span<const MotionQuantity> motion_quantities() {
  return motion_quantity_table;
}

std::optional<bool> is_stable(const SpeedPoint& point) {
  bool known = true;
  for (const bool stuck : {false, true}) {
    const auto& motions = point.motions(stuck);
    const bool any = motions && !motions->whirls.empty();
    if (any && motions->whirls.front().rate.real() >= 0.0) return false;
    known = known && any;
  }
  return known ? std::optional(true) : std::nullopt;
}

std::vector<SpeedMotion> motions_at(const SpeedPoint& point) {
  std::vector<SpeedMotion> all;
  for (const ContactMotion contacts : {ContactMotion::sliding, ContactMotion::stuck}) {
    const auto& motions = point.motions(contacts == ContactMotion::stuck);
    if (!motions) continue;
    for (std::size_t i = 0; i < motions->whirls.size(); ++i) {
      all.push_back({contacts, motions->whirls[i], motions->numbers[i]});
    }
  }
  return all;
}

RunStatus status_of(const StabilityResult& result) {
  if (result.map.interrupted) return RunStatus::interrupted;
  return run_status(each(result.map.points, [](const SpeedPoint& point) { return point.status; }),
                    result.map.points.size());
}

std::vector<std::string> failure_lines(const StabilityResult& result) {
  return missing_equilibria(each(result.map.points, [](const SpeedPoint& point) {
    return SpeedStatus{point.speed, point.status};
  }));
}

std::vector<std::string> warning_lines(const Case& input, const StabilityResult& result) {
  std::vector<std::string> lines = rotor_case_warnings(input);
  std::size_t fluttering = 0;
  std::size_t unknown = 0;
  const SpeedPoint* first = nullptr;
  for (const SpeedPoint& point : result.map.points) {
    if (point.status != Status::converged) continue;
    const auto foils_grow = [](const std::optional<SpeedMotions>& motions) {
      return motions && std::any_of(motions->whirls.begin(), motions->whirls.end(),
                                    [](const Whirl& whirl) { return whirl.is_of_foils() && whirl.rate.real() > 0.0; });
    };
    if (foils_grow(point.sliding) || foils_grow(point.stuck)) {
      if (fluttering++ == 0) first = &point;
    }
    if (!is_stable(point)) ++unknown;
  }
  if (fluttering > 0) {
    lines.push_back(fmt::format(
        "at {} of {} speeds (first at {}) the foils themselves are unstable, whatever rotor they carry: bumpfoil "
        "equilibrium shows where they flutter and what helps, such as top_foil.formed_radius = \"seated\" or the other "
        "sense of rotation",
        fluttering, result.map.points.size(), rotor_speed_text(first->speed)));
  }
  if (unknown > 0) {
    lines.push_back(
        fmt::format("whether all motions decay is not known at {} of {} speeds: the modes of the contacts "
                    "leave a singular system",
                    unknown, result.map.points.size()));
  }
  if (result.machine.reduction_error > tolerated_reduction_error) {
    lines.push_back(fmt::format("the reduced shaft has natural frequencies that are wrong by up to {:.2g} %",
                                100.0 * result.machine.reduction_error));
  }
  return lines;
}

std::string onset_text(const WhirlOnset& found) {
  return fmt::format("whirl{} {} at {}, whirl ratio {:.4f}{}", found.of_foils ? " of the foils" : "",
                     found.begins ? "begins" : "ends", rotor_speed_text(found.onset.speed), found.onset.whirl_ratio,
                     found.onset.jumps ? " (contacts change there)" : "");
}

}  // namespace bumpfoil
