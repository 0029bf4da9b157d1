#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"
#include "bumpfoil/model/case_names.hpp"

namespace bumpfoil {
namespace {

/// A top foil displaced by more per displacement of the journal is almost free: coefficients then hold only for motions
/// far below those of a rotor.
constexpr double most_foil_response = 100.0;
/// Overhangs are reported if the film is thinner than this multiple of the flutter threshold.
constexpr double margin_of_overhang = 2.0;
/// Foil motions up to this fraction of the minimum film thickness are small.
constexpr double linear_part = 0.1;

/// The part that flutters in an unstable state, its location, and advice.
std::string flutter_text(const BearingModel& bearing, const RunningState& state) {
  const auto& [sliding, stuck] = state.held;
  const HeldMotion& motion = sliding && (!stuck || sliding->rate.real() >= stuck->rate.real()) ? *sliding : *stuck;
  const HeldPlace place = held_place(bearing, motion);
  const FilmPad& pad = bearing.film->pads[place.pad];
  const double speed = std::abs(state.last->speed);
  const double per_revolution = 2.0 * std::numbers::pi * motion.rate.real() / speed;
  const double frequency = motion.rate.imag() / (2.0 * std::numbers::pi);
  std::string text = fmt::format(
      "the top foil{} moves most {:.4g} deg from the weld and would {}{}",
      bearing.film->pads.size() > 1 ? fmt::format(" of pad {}", place.pad + 1) : "", to_degrees(place.theta),
      frequency > 0.0 ? fmt::format("flutter at {:.4g} Hz", frequency) : "snap over",
      speed > 0.0 ? fmt::format(", growing {:.3g}-fold each revolution", std::exp(per_revolution)) : std::string());
  if (bearing.film->surface_speed(pad, state.last->speed) < 0.0) {
    const int lifted = lifted_bumps_at_entry(bearing, state);
    text += fmt::format(
        "; the gas enters at the free end{}: hold it down (top_foil.formed_radius = \"seated\", a feed by "
        "film.inlet_pressure), or let the gas enter at the weld (reverse the speed or bearing.wrap)",
        lifted > 0 ? fmt::format(", where {} bumps are not loaded", lifted) : std::string());
  }
  return text;
}

/// Film thickness at the free end of a pad below which its overhang alone may flutter, m. With the last crest as a
/// clamp and an infinite bearing number, P H is constant under the overhang l, and EI' u'''' = pa L (u_in - u) / h is
/// unstable below h = pa L l^4 / (24.35 EI').
double fluttering_thickness(const FilmModel& film, const FilmPad& pad) {
  const FilmMesh& mesh = pad.foil.mesh;
  const double R = film.scales.radius;
  const Vector theta = mesh.angles();
  const double overhang = R * (theta[mesh.columns] - theta[pad.foil.supports.back()]);
  const double p = pad.foil.pitch;
  const double bending_stiffness = pad.foil.stiffness * p * p * p;
  const double width = 2.0 * film.half_width() * pad.part;
  return film.scales.gas.ambient_pressure * width * std::pow(overhang, 4) / (24.35 * bending_stiffness);
}

/// The first pad whose film at the free end, at the gas inlet, is near this thickness.
std::string overhang_text(const FilmModel& film, const RunningState& state) {
  for (std::size_t k = 0; k < film.pads.size(); ++k) {
    const FilmPad& pad = film.pads[k];
    if (film.surface_speed(pad, state.last->speed) >= 0.0) continue;
    const Eigen::Index end = pad.first_column + pad.foil.mesh.columns;
    const double h = film.scales.thickness * state.last->film.thickness(0, end);
    const double least = fluttering_thickness(film, pad);
    if (h >= margin_of_overhang * least) continue;
    return fmt::format(
        "the film at the free end{} is {:.3g} um thick, and below about {:.3g} um the overhang of the top foil "
        "flutters by itself: shorten top_foil.overhang",
        film.pads.size() > 1 ? fmt::format(" of pad {}", k + 1) : "", 1e6 * h, 1e6 * least);
  }
  return {};
}

std::string times_text(int count) {
  return count == 1 ? "once" : fmt::format("{} times", count);
}

}  // namespace

std::string_view command_of(const EquilibriumResult& result) {
  return result.bearing->has_foils() ? "equilibrium" : "film";
}

RunStatus status_of(const EquilibriumResult& result) {
  if (result.converged()) return RunStatus::complete;
  const bool interrupted =
      std::any_of(result.states.begin(), result.states.end(),
                  [](const RunningState& state) { return state.report.status == Status::interrupted; }) ||
      std::any_of(result.limits.begin(), result.limits.end(),
                  [](const FilmLimit& limit) { return limit.status == Status::interrupted; });
  return interrupted ? RunStatus::interrupted : RunStatus::failed;
}

std::vector<std::string> failure_lines(const EquilibriumResult& result) {
  std::vector<std::string> lines;
  for (const RunningState& state : result.states) {
    if (state.found() || state.report.status == Status::interrupted) continue;
    lines.push_back(running_failure(*result.bearing, state));
  }
  for (const FilmLimit& limit : result.limits) {
    if (limit.found() || limit.status == Status::interrupted) continue;
    lines.push_back(fmt::format("{}: {}", name_of_limit(limit), explanation(limit.status)));
  }
  return lines;
}

std::vector<std::string> warning_lines(const Case& input, const EquilibriumResult& result) {
  std::vector<std::string> lines = case_warnings(input);
  std::size_t lifted = 0;
  std::size_t unstable = 0;
  std::string first_unstable;
  std::size_t unknown = 0;
  std::string first_lifted;
  for (const RunningState& state : result.states) {
    if (!state.found()) continue;
    if (state.report.jumps > 0) {
      lines.push_back(
          fmt::format("{}: the branch of states ended {} on the path, and the foil jumped to another one; several "
                      "states exist at this point: compare with --paths",
                      name_of_state(state), times_text(state.report.jumps)));
    }
    if (state.instead_of_unstable) {
      lines.push_back(fmt::format("{}: stable; the path of the case leads to an unstable state at this point",
                                  name_of_state(state)));
    }
    if (const int bumps = lifted_bumps_at_entry(*result.bearing, state); bumps > 1 && lifted++ == 0) {
      first_lifted = fmt::format("{}: {} bumps", name_of_state(state), bumps);
    }
    if (result.bearing->has_foils()) {
      const std::optional<bool> stable = state.held.is_stable();
      if (!stable) ++unknown;
      if (state.light_contacts > 0 && state.held_if_open.is_stable() != stable) {
        lines.push_back(fmt::format(
            "{}: whether the state is stable depends on {} closed contact{} with less than 1 mN, top foil on bumps or "
            "bumps on sleeve: its stability is doubtful",
            name_of_state(state), state.light_contacts, state.light_contacts == 1 ? "" : "s"));
      }
      if (const std::string overhang = overhang_text(*result.bearing->film, state); !overhang.empty()) {
        lines.push_back(fmt::format("{}: {}", name_of_state(state), overhang));
      }
      if (!stable.value_or(true) && unstable++ == 0) {
        first_unstable = fmt::format("{}: {}", name_of_state(state), flutter_text(*result.bearing, state));
      }
    }
    if (state.foil_response.value_or(0.0) > most_foil_response) {
      lines.push_back(
          fmt::format("{}: the state is nearly singular: the top foil moves {:.3g} times as far as the journal; "
                      "stiffness and coefficients at low frequencies hold only for motions below {:.2g} nm",
                      name_of_state(state), *state.foil_response,
                      1e9 * linear_part * state.outcome->thinnest.thickness * result.bearing->film->scales.thickness /
                          *state.foil_response));
    }
    const auto compare = [&](std::string_view foil, std::optional<double> stress, std::optional<double> yield_stress) {
      if (!stress || !yield_stress || *stress <= *yield_stress) return;
      lines.push_back(
          fmt::format("{}: the {} yields: its bending stress reaches {:.4g} MPa, its yield stress is {:.4g} "
                      "MPa",
                      name_of_state(state), foil, 1e-6 * *stress, 1e-6 * *yield_stress));
    };
    compare("top foil", state.top_foil_stress, input.top_foil.yield_stress);
    compare("bump foil", state.bump_foil_stress, input.bump_foil.yield_stress);
  }
  for (const FilmLimit& limit : result.limits) {
    if (!limit.unstable.empty()) {
      const std::string_view what = std::isnan(limit.value) ? "none, because every state on the path is unstable"
                                                            : "without the states on the path that are unstable";
      lines.push_back(
          fmt::format("{}: {} with the journal held ({})", name_of_limit(limit), what, unstable_ranges_text(limit)));
    }
    if (limit.unknown > 0) {
      lines.push_back(
          fmt::format("{}: whether {} states of the path are stable with the journal held is not known; "
                      "they count as stable",
                      name_of_limit(limit), limit.unknown));
    }
    if (!limit.found() || limit.jumps == 0) continue;
    lines.push_back(fmt::format("{}: the branch of states ended {} on the path, and the foil jumped to another one",
                                name_of_limit(limit), times_text(limit.jumps)));
  }
  for (const OtherBranch& other : result.other_branches) {
    const RunningState& state = result.states[other.state];
    lines.push_back(fmt::format(
        "{}: {} ends in another state, with a minimum film thickness of {:.4g} um instead of {:.4g} um: the history of "
        "the bearing decides which one it runs in; compare all paths with --paths",
        name_of_state(state), name_of(other.path), 1e6 * other.minimum_film_thickness,
        1e6 * state.outcome->thinnest.thickness * result.bearing->film->scales.thickness));
  }
  // One line for all: on most paths it concerns all states or none.
  if (lifted > 0) {
    lines.push_back(
        fmt::format("in {} of {} states the foil is detached at the inlet ({}); the extent may depend on the path: "
                    "compare with --paths",
                    lifted, result.states.size(), first_lifted));
  }
  if (unstable > 0) {
    // First: it makes other remarks on such a state irrelevant.
    lines.insert(lines.begin(), fmt::format("{} of {} states are unstable with the journal held, so that no bearing "
                                            "stays in them ({}); see growth_held",
                                            unstable, result.states.size(), first_unstable));
  }
  if (unknown > 0) {
    lines.push_back(fmt::format("whether {} of {} states are stable with the journal held is not known", unknown,
                                result.states.size()));
  }
  return lines;
}

}  // namespace bumpfoil
