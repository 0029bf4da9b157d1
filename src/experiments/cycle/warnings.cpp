#include "bumpfoil/experiments/cycle/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

/// Limits of the compression over the rise of a bump. Up to the first, linear foils are at most about 5 % too stiff;
/// above the second, the model has not been compared with finite elements.
constexpr double linear_limit = 1.0 / 8.0;
constexpr double checked_limit = 1.0 / 2.0;
/// Relative softening of the foils by large displacements, per compression over rise: linear and nonlinear frames of
/// the reference bearing, compressed by 0.12, 0.14 and 0.19 of the rise, differ by 4.5, 5.5 and 7.5 %.
constexpr double softening = 0.4;
/// The truss applies to rows of at least this many bumps.
constexpr int shortest_row = 4;

double rise_of(const Case& input, int bump) {
  const PadBump found = find_bump(input, bump);
  return nominal_bump(bump_foil_of(input, found.pad), static_cast<std::size_t>(found.bump)).rise;
}

std::optional<std::string> compression_warning(const Case& input, const Cycle& cycle) {
  if (!cycle.compression) return std::nullopt;
  const CompressionPeak& peak = *cycle.compression;
  const double part = peak.compression / rise_of(input, peak.bump);
  const bool linear = input.bump_foil.geometry == Geometry::linear;
  if (part <= (linear ? linear_limit : checked_limit)) return std::nullopt;
  std::string text = fmt::format("bump {} is compressed by {:.3g} um, {:.2g} of its rise (increment {})",
                                 bump_text(input, peak.bump), 1e6 * peak.compression, part, peak.increment);
  if (part > checked_limit) return text + ": not verified beyond half the rise; reduce the displacement";
  return fmt::format(
      "{}: large displacements, which are not modelled, would soften the foils by about {:.0f} %; use bump_foil.model "
      "= \"frame\" with bump_foil.geometry = \"nonlinear\"",
      text, 100.0 * softening * part);
}

/// For a result whose foils carry no load at full displacement, nor at the start.
std::optional<std::string> contact_warning(const CycleResult& result, const Cycle& cycle) {
  if (!cycle.turning_point || !cycle.start) return std::nullopt;
  if (cycle.turning_point->bump_loads.maxCoeff() > 0.0 || cycle.turning_point->max_force != 0.0) return std::nullopt;
  if (cycle.start->elastic_energy > 0.0) return std::nullopt;
  if (result.experiment == Experiment::strip) {
    return fmt::format("the plate, pushed to {:.4g} um, never loads the foils: push it further", 1e6 * cycle.amplitude);
  }
  if (!cycle.first_contact) return "the journal never touches the foils: no bump faces this direction";
  return fmt::format(
      "the journal, pushed to {:.4g} um, never touches the foils, which start at {:.4g} um: raise cycle.amplitude",
      1e6 * cycle.amplitude, 1e6 * *cycle.first_contact);
}

std::optional<std::string> settling_warning(const CycleResult& result, const Cycle& cycle) {
  const std::vector<double>& loops = cycle.loop_energies;
  if (loops.size() < 2 || cycle.settled || !cycle.converged()) return std::nullopt;
  const bool orbits = result.experiment == Experiment::path;
  return fmt::format("{}; raise {}", unsettled(cycle, orbits ? "orbits" : "cycles"),
                     orbits ? "path.orbits" : "cycle.cycles");
}

std::optional<std::string> truss_warning(const Case& input, const CycleResult& result) {
  int bumps = bump_foil_of(input, 0).bumps;
  for (std::size_t k = 1; k < count_pads(input); ++k) bumps = std::min(bumps, bump_foil_of(input, k).bumps);
  if (result.experiment == Experiment::strip) bumps = input.settings.get<StripSettings>().bumps;
  if (input.bump_foil.model != BumpFoilModel::truss || bumps >= shortest_row) return std::nullopt;
  return fmt::format(
      "the truss is meant for long rows of bumps; for {} it may be up to 26 % too stiff: bump_foil.model = \"frame\" "
      "stays within 1 %",
      bumps == 1 ? "one bump" : fmt::format("{} bumps", bumps));
}

std::optional<std::string> yield_warning(const Case& input, const Cycle& cycle, const StressedFoil& foil) {
  if (above_yield(foil, cycle, input) != 1.0) return std::nullopt;
  const StressPeak& peak = *(cycle.*foil.peak);
  return fmt::format(
      "the {} yields: its bending stress reaches {:.4g} MPa ({}, increment {}), its yield stress is {:.4g} MPa; the "
      "foils are computed as elastic all the same",
      foil.long_name, 1e-6 * peak.stress, place_text(input, peak), peak.increment, 1e-6 * *foil.yield_stress(input));
}

}  // namespace

std::string unsettled(const Cycle& cycle, std::string_view loops) {
  const double last = cycle.loop_energies.back();
  const double before = *(cycle.loop_energies.end() - 2);
  return fmt::format(
      "the loop has not settled after {} {}: its energy, {:.4g} mJ, is {:.2g} % {} than that of the previous loop",
      cycle.loop_energies.size(), loops, 1e3 * last, 100.0 * std::abs(last / before - 1.0),
      last < before ? "smaller" : "larger");
}

std::vector<std::string> warnings_of(const Case& input, const CycleResult& result, std::size_t cycle) {
  const Cycle& of = result.cycles[cycle];
  std::vector<std::string> warnings = case_warnings(input);
  const auto take = [&warnings](const std::optional<std::string>& warning) {
    if (warning) warnings.push_back(*warning);
  };
  take(compression_warning(input, of));
  take(contact_warning(result, of));
  take(settling_warning(result, of));
  take(truss_warning(input, result));
  for (const StressedFoil& foil : stressed_foils()) take(yield_warning(input, of, foil));
  return warnings;
}

std::vector<std::string> warning_lines(const Case& input, const CycleResult& result) {
  std::vector<std::string> lines = case_warnings(input);  // once for all cycles
  const std::size_t on_case = lines.size();
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    const std::vector<std::string> warnings = warnings_of(input, result, i);
    for (std::size_t k = on_case; k < warnings.size(); ++k) {
      lines.push_back(fmt::format("{}: {}", cycle_name(result, i), warnings[k]));
    }
  }
  return lines;
}

}  // namespace bumpfoil
