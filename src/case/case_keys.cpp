#include "case/case_keys.hpp"

#include <limits>
#include <optional>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/deviations_csv.hpp"
#include "case/height_errors_csv.hpp"
#include "case/profile_csv.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, Waviness& waves) {
  using enum Presence;
  using enum Dimension;
  keys.value({"harmonic", required, "Waves", "around the circumference", "3"}, &waves.harmonic);
  keys.value({"amplitude", required, "Amplitude", "from the mean radius", "5 um", length}, &waves.amplitude);
  keys.value({"phase", defaulted, "Phase", "harmonic times the angle of a crest of the waves, from X towards Y",
              "0 deg", angle},
             &waves.phase);
}

void describe_profile(CaseVisitor& keys, const Key& waviness, const Key& deviations, const Key& file,
                      RadiusProfile& profile) {
  keys.value(deviations, &profile.deviations);
  keys.file(file, deviations.name, [&profile](const std::string& path) { profile.deviations = read_profile(path); });
  list_of_tables(keys, waviness, profile.waves, [](CaseVisitor& inner, Waviness& waves) { describe(inner, waves); });
}

void describe(CaseVisitor& keys, Bearing& bearing) {
  using enum Presence;
  using enum Dimension;
  // A strip has no radius of its own, and no clearance to the plate.
  std::optional<double> radius;
  std::optional<double> clearance;
  if (!bearing.is_flat()) {
    radius = bearing.radius;
    clearance = bearing.radial_clearance;
  }
  keys.once_or_twice({.name = "radius",
                      .title = "Radius",
                      .text = "R of the circle on which the foils lie, also used for sleeve and journal; a strip alone "
                              "needs neither radius nor clearance",
                      .example = "19.05 mm",
                      .dimension = length,
                      .spared_by = "strip"},
                     {"diameter", required, "Diameter", "instead of the radius", "38.1 mm", length}, radius);
  bearing.radius = radius.value_or(std::numeric_limits<double>::infinity());
  keys.value({"axial_length", required, "Axial length", "along the axis, L", "38.1 mm", length}, &bearing.axial_length);
  keys.value({.name = "radial_clearance",
              .title = "Radial clearance",
              .text = "C_r, journal to undeformed top foil; zero or negative is interference",
              .example = "31.8 um",
              .dimension = length,
              .spared_by = radius ? "" : "strip"},
             &clearance);
  bearing.radial_clearance = clearance.value_or(0.0);
  keys.value({"weld_angle", defaulted, "Weld angle", "angle of the weld, from the X axis towards Y", "180 deg", angle},
             &bearing.weld_angle);
  keys.choice({"wrap", defaulted, "Foil direction", "foil direction, from the weld; or \"counterclockwise\""},
              bearing.wrap);
  describe_profile(
      keys,
      {"sleeve_waviness", optional, "Waviness of the sleeve",
       "the radius of the sleeve differs by amplitude cos(harmonic angle - phase), and the foils follow it; "
       "several add up"},
      {"sleeve_profile", optional, "Profile of the sleeve",
       "radial deviation from nominal, at equal angles from X towards Y", "[\"3 um\", \"0 um\", \"-3 um\", \"0 um\"]",
       length},
      {"sleeve_profile_file", optional, "File of the profile of the sleeve",
       "or a CSV file beside this one; column deviation_um, and angle_deg, which is checked", "\"sleeve.csv\""},
      bearing.sleeve);
  describe_profile(
      keys,
      {"journal_waviness", optional, "Waviness of the journal",
       "the radius of the journal, which does not rotate, differs by amplitude cos(harmonic angle - phase)"},
      {"journal_profile", optional, "Profile of the journal",
       "radial deviation from nominal, at equal angles from X towards Y", "[\"1 um\", \"0 um\", \"-1 um\", \"0 um\"]",
       length},
      {"journal_profile_file", optional, "File of the profile of the journal", "instead, as for the sleeve",
       "\"journal.csv\""},
      bearing.journal);
  keys.value({"taper", defaulted, "Taper", "increase of the sleeve radius from the weld to the free end of the foils",
              "0 um", length},
             &bearing.taper);
  keys.value(
      {"pad_gap", optional, "Gap between pads",
       "free angle after each pad without its own arc; by default arcs are as long as their bumps", "5 deg", angle},
      &bearing.pad_gap);
}

void describe(CaseVisitor& keys, TrussOverrides& truss) {
  using enum Presence;
  using enum Dimension;
  keys.value({"k1", optional, "k₁", "rods between crest and feet", "150 MN/m", stiffness}, &truss.k1);
  keys.value({"k2", optional, "k₂", "between neighbouring feet", "5.43 MN/m", stiffness}, &truss.k2);
  keys.value({"k3", optional, "k₃", "between neighbouring crests", "1.36 MN/m", stiffness}, &truss.k3);
  keys.value({"k4", optional, "k₄", "between the weld and the first crest", "11.25 MN/m", stiffness}, &truss.k4);
  keys.value({"theta_d", optional, "Inclination of the rods", "inclination of the rods", "15.83 deg", angle},
             &truss.theta_d);
}

/// @param of_strip  its pitches and heights apply to all strips
void describe(CaseVisitor& keys, BumpSection& section, bool of_strip) {
  using enum Presence;
  using enum Dimension;
  keys.value({"from", required, "From bump", "first bump; bumps count from 1 at the weld", "1"}, &section.from);
  keys.value({"to", required, "To bump", "last bump", "5"}, &section.to);
  if (!of_strip) keys.value({"pitch", optional, "Pitch", "", "4.572 mm", length}, &section.pitch);
  keys.value({"length", optional, "Length of a bump", "", "3.4 mm", length}, &section.length);
  if (!of_strip) keys.value({"height", optional, "Height of a bump", "", "0.5 mm", length}, &section.height);
  keys.value({"thickness", optional, "Thickness", "", "0.127 mm", length}, &section.thickness);
}

void describe(CaseVisitor& keys, Shim& shim) {
  using enum Presence;
  using enum Dimension;
  keys.value({"from", required, "From bump", "first bump on it; bumps count from 1 at the weld", "10"}, &shim.from);
  keys.value({"to", required, "To bump", "last bump on it", "12"}, &shim.to);
  keys.value({"thickness", required, "Thickness", "", "20 um", length}, &shim.thickness);
}

void describe(CaseVisitor& keys, FoilStrip& strip) {
  using enum Presence;
  using enum Dimension;
  keys.value({"stagger", defaulted, "Stagger", "of its weld and bumps along the foil, in pitches: a multiple of 1/6"},
             &strip.stagger);
  keys.value(
      {"height_errors", defaulted, "Height errors",
       "one for all its bumps or one for each, positive is taller; added to those of the bump foil", "0 um", length},
      &strip.height_errors);
  keys.value({"thickness", optional, "Thickness", "instead of bump_foil.thickness; overall heights do not change",
              "0.127 mm", length},
             &strip.thickness);
  list_of_tables(keys,
                 {"section", optional, "Section",
                  "bumps of the strip from one to another have these dimensions; pitches and heights are common to all "
                  "strips, except for height_errors"},
                 strip.sections, [](CaseVisitor& inner, BumpSection& section) { describe(inner, section, true); });
}

void describe(CaseVisitor& keys, BumpFoil& foil) {
  using enum Presence;
  using enum Dimension;
  keys.choice({.name = "model",
               .presence = defaulted,
               .title = "Model",
               .text = "springs between crests and feet; \"frame\": arcs and flats as beams; \"former\": Le Lez (2007) "
                       "model. Without a model, a foil that cannot be a truss is modelled as a frame, with a warning",
               .left_open = foil.model == BumpFoilModel::truss},
              foil.model);
  keys.choice({"geometry", defaulted, "Displacements", "small displacements; frame only: \"nonlinear\" for large ones"},
              foil.geometry);
  keys.value({"bumps", required, "Bumps"}, &foil.bumps);
  keys.value({"pitch", required, "Pitch",
              "crest to crest along the foil; like length, height and thickness one value, a list of one per bump, or "
              "{ start = \"4 mm\", end = \"5 mm\", law = \"linear\" } from bump 1 to the last (or \"geometric\")",
              "4.572 mm", length},
             &foil.pitch);
  keys.value({"length", required, "Length of a bump", "chord of a bump's arc; the rest of the pitch is flat",
              "3.556 mm", length},
             &foil.length);
  keys.value({"height", required, "Height of a bump", "", "0.508 mm", length}, &foil.height);
  keys.choice({"height_reference", defaulted, "Height measured",
               "over the sleeve, foil thickness included; \"midsurface\": rise of the mid-surface"},
              foil.height_reference);
  keys.value({"thickness", required, "Thickness", "", "0.102 mm", length}, &foil.thickness);
  keys.value({"youngs_modulus", required, "Young’s modulus", "", "214 GPa", pressure}, &foil.youngs_modulus);
  keys.value({"poisson_ratio", required, "Poisson’s ratio"}, &foil.poisson_ratio);
  keys.value({"yield_stress", optional, "Yield stress", "a bending stress of the foil above it gives a warning",
              "1.1 GPa", pressure},
             &foil.yield_stress);
  list_of_tables(
      keys, {"section", optional, "Section", "bumps from one to another have these dimensions instead of those above"},
      foil.sections, [](CaseVisitor& inner, BumpSection& section) { describe(inner, section, false); });
  list_of_tables(keys, {"shim", optional, "Shim", "a sheet under some bumps that raises them"}, foil.shims,
                 [](CaseVisitor& inner, Shim& shim) { describe(inner, shim); });
  keys.value({"height_errors", optional, "Height errors", "one per bump from the weld, positive is taller",
              "[\"5 um\", \"-3 um\", ...]", length},
             &foil.height_errors);
  keys.file({"height_errors_file", optional, "File of height errors",
             "or a CSV file beside this one; columns bump and height_error_um or height_mm", "\"heights.csv\""},
            "height_errors", [&foil](const std::string& path) {
              if (foil.bumps < 1 || foil.bumps > most_bumps) return;  // reported elsewhere
              const auto count = static_cast<std::size_t>(foil.bumps);
              const auto has_all = [count](const PerBump& one) { return !one.is_list() || one.values.size() == count; };
              // If a list of dimensions is invalid, the file is still read for its own errors.
              const bool known =
                  has_all(foil.pitch) && has_all(foil.length) && has_all(foil.height) && has_all(foil.thickness);
              std::vector<double> heights(count);
              std::vector<double> rises(count);
              for (std::size_t n = 0; known && n < count; ++n) {
                heights[n] = nominal_height(foil, n);
                rises[n] = nominal_bump(foil, n).rise;
              }
              std::vector<double> errors = read_height_errors(path, heights, rises);
              if (known) foil.height_errors = std::move(errors);
            });
  keys.value({"stiffness_follows_height", defaulted, "Stiffness follows height",
              "frame only; true: the stiffness of a bump follows its height error"},
             &foil.stiffness_follows_height);
  keys.value({"sleeve_gaps", optional, "Sleeve gaps", "one per bump, initial gap between its foot and the sleeve",
              "[\"0 um\", \"2 um\", ...]", length},
             &foil.sleeve_gaps);
  keys.value({"strips", defaulted, "Strips", "side by side over the width, of equal width"}, &foil.strips);
  keys.value({"strip_gap", defaulted, "Gap between strips", "axial, between neighbouring strips of the bump foil",
              "0 mm", length},
             &foil.strip_gap);
  list_of_tables(keys,
                 {"strip", optional, "Strip",
                  "properties of each strip, in order from the side z < 0; none: all strips are alike"},
                 foil.strip, [](CaseVisitor& inner, FoilStrip& strip) { describe(inner, strip); });
  keys.choice(
      {"weld_at", defaulted, "Weld at", "clamped before bump 1 in the middle of a flat; frame only: \"arc_start\""},
      foil.weld_at);
  keys.table({"truss", optional, "Prescribed truss constants",
              "any of them, instead of those identified from the shape of the foil"},
             foil.truss != TrussOverrides{}, [&foil](CaseVisitor& inner) { describe(inner, foil.truss); });
}

void describe(CaseVisitor& keys, TopFoil& foil) {
  using enum Presence;
  using enum Dimension;
  keys.value({"thickness", required, "Thickness", "", "0.102 mm", length}, &foil.thickness);
  keys.value({"youngs_modulus", defaulted, "Young’s modulus", "", "214 GPa", pressure, "bump_foil.youngs_modulus"},
             &foil.youngs_modulus);
  keys.value({"poisson_ratio", defaulted, "Poisson’s ratio", "", "", {}, "bump_foil.poisson_ratio"},
             &foil.poisson_ratio);
  keys.value({"yield_stress", optional, "Yield stress", "", "1.1 GPa", pressure, "bump_foil.yield_stress"},
             &foil.yield_stress);
  keys.value({"formed_radius", optional, "Formed radius",
              "radius that the foil is formed to before its assembly, by default that of the bearing; 0.5 to 1 % more "
              "presses its free end on the last bump, or \"seated\": R/(1 - 6 C_r/R)",
              "19.24 mm", length},
             &foil.formed_radius);
  keys.value({"seat_pressure", optional, "Seat pressure",
              "pressure on all bumps alike, from forming in addition to that radius", "100 Pa", pressure},
             &foil.seat_pressure);
  keys.value(
      {"overhang", optional, "Overhang", "from the last crest to the free end; default: half a pitch", "2 mm", length},
      &foil.overhang);
  keys.value(
      {"split", defaulted, "Split", "true: split over the width like the bump foil; the film leaks at the slits"},
      &foil.split);
}

void describe(CaseVisitor& keys, const PadDesign& common, Pad& pad) {
  using enum Presence;
  using enum Dimension;
  keys.value({"weld_angle", optional, "Weld angle",
              "from the X axis towards Y; by default pads start at equal angles, the first at bearing.weld_angle",
              "180 deg", angle},
             &pad.weld_angle);
  keys.choice({"weld_edge", defaulted, "Welded at",
               "the first edge in the direction of bearing.wrap; or \"trailing\": the foils run against it"},
              pad.weld_edge);
  keys.value(
      {"arc", optional, "Arc", "from the weld to the free end; pitches are stretched to fill it", "110 deg", angle},
      &pad.arc);
  keys.value(
      {"lobe", defaulted, "Pad offset (preload)",
       "mechanical preload: offset of its circle, which reduces the gap in its middle by as much", "0 um", length},
      &pad.lobe);
  const auto own_foil = [&keys](const Key& key, const auto& foil, auto& own) {
    own_table(keys, key, foil, own, [](CaseVisitor& inner, auto& members) { describe(inner, members); });
  };
  own_foil({"bump_foil", inherited, "Bump foil of the pad", "any keys of [bump_foil] that differ"}, common.bump_foil,
           pad.bump_foil);
  own_foil({"top_foil", inherited, "Top foil of the pad", "any keys of [top_foil] that differ"}, common.top_foil,
           pad.top_foil);
}

void describe(CaseVisitor& keys, Friction& friction) {
  using enum Presence;
  keys.once_or_each({"coefficient", required, "Both coefficients", "at both interfaces; 0 for none"},
                    {{{"top_bump", required, "Top foil on bumps", "or one for each interface: with the top foil"},
                      &friction.top_bump},
                     {{"bump_sleeve", required, "Bumps on sleeve", "and with the sleeve"}, &friction.bump_sleeve}});
}

void describe(CaseVisitor& keys, SolverSettings& solver) {
  using enum Presence;
  using enum Dimension;
  keys.choice({"name", defaulted, "Name",
               "exact contact and friction; \"events\" follows the path from one contact change to the next, and is "
               "the default of montecarlo for cycles with small displacements; \"uzawa\" is the method of the 2019 "
               "paper, with the penalties below",
               "\"newton\""},
              solver.name);
  UzawaParameters& uzawa = solver.uzawa;
  keys.value({"eps_alm", optional, "Penalty, normal contacts",
              "penalty of the normal contacts; default: from the stiffness", "100 MN/m", stiffness},
             &uzawa.eps_alm);
  keys.value({"eps_f", optional, "Penalty, sticking contacts",
              "penalty of sticking contacts; default: from the stiffness", "10 GN/m", stiffness},
             &uzawa.eps_f);
  keys.value({"eps_r", optional, "Penalty, journal", "penalty of the journal's contact; default: from the stiffness",
              "1 TN/m", stiffness},
             &uzawa.eps_r);
  keys.value({"tau_f", optional, "Slip of half friction",
              "slip over which the friction force reverses; default: from the stiffness", "0.1 nm", length},
             &uzawa.tau_f);
}

/// A distribution of a deviation, with the examples of its keys.
struct Deviation {
  std::optional<Dimension> dimension;
  std::string_view sigma, lower, upper, values;
};
constexpr Deviation of_height{Dimension::length, "10 um", "-20 um", "20 um", "[\"3 um\", \"-8 um\", ...]"};
constexpr Deviation of_thickness{Dimension::length, "2 um", "-5 um", "5 um", "[\"1 um\", \"-2 um\", ...]"};
constexpr Deviation of_radius{Dimension::length, "50 um", "-100 um", "100 um", "[\"40 um\", \"-20 um\", ...]"};
constexpr Deviation of_friction{{}, "0.02", "-0.05", "0.05", "[0.01, -0.02, ...]"};

void describe(CaseVisitor& keys, Distribution& distribution, const Deviation& deviation) {
  using enum Presence;
  keys.choice(
      {"distribution", defaulted, "Distribution", "of the deviation; or \"truncated_normal\", \"uniform\", \"table\""},
      distribution.kind);
  keys.value(
      {"std", optional, "Standard deviation", "normal and truncated_normal", deviation.sigma, deviation.dimension},
      &distribution.sigma);
  const auto instead = [&deviation](std::string_view name, std::string_view title, std::string_view text,
                                    std::string_view example) {
    return Key{.name = name,
               .presence = optional,
               .title = title,
               .text = text,
               .example = example,
               .dimension = deviation.dimension,
               .instead = true};
  };
  keys.value(instead("lower", "Lower bound", "truncated_normal and uniform", deviation.lower), &distribution.lower);
  keys.value(instead("upper", "Upper bound", "truncated_normal and uniform", deviation.upper), &distribution.upper);
  keys.value(instead("values", "Measured values", "table: one of these, all equally likely", deviation.values),
             &distribution.values);
  keys.file({"file", optional, "File of measured values", "or a file beside this one with the column deviation",
             "\"measured.csv\""},
            "values", [&distribution](const std::string& path) { distribution.values = read_deviations(path); });
}

void describe(CaseVisitor& keys, HeightScatter& heights) {
  using enum Presence;
  using enum Dimension;
  describe(keys, heights.distribution, of_height);
  keys.value(
      {"correlation_length", defaulted, "Correlation length",
       "along the foil, over which the correlation of heights falls by 1/e; 0: they are independent", "0 mm", length},
      &heights.correlation_length);
}

void describe(CaseVisitor& keys, WavinessScatter& waves) {
  using enum Presence;
  using enum Dimension;
  keys.value({"harmonic", required, "Waves", "around the circumference; with a random phase", "3"}, &waves.harmonic);
  keys.value({"amplitude", required, "Amplitude", "from the mean radius", "5 um", length}, &waves.amplitude);
}

void describe(CaseVisitor& keys, MonteCarloSettings& ensemble) {
  using enum Presence;
  keys.choice({"command", defaulted, "Command",
               "command that is run for each bearing; or \"equilibrium\": the running bearing, or \"stability\", "
               "\"unbalance\" or \"transient\": a rotor whose bearings all have the deviations that are drawn"},
              sampled_experiments(), ensemble.command);
  keys.value({"samples", defaulted, "Samples", "number of bearings"}, &ensemble.samples);
  keys.value({"seed", defaulted, "Seed", "of the random numbers; the same seed draws the same bearings"},
             &ensemble.seed);
  keys.value({"limits", defaulted, "Limits",
              "for running bearings: also lift-off speeds and load capacities, at a film thickness of film.h_lift_off"},
             &ensemble.limits);
  const auto scatter = [&keys](std::string_view name, std::string_view title, auto& members,
                               const Deviation& deviation) {
    optional_table(keys, {name, optional, title, "the same for the whole bearing"}, members,
                   [&deviation](CaseVisitor& inner, auto& distribution) { describe(inner, distribution, deviation); });
  };
  optional_table(keys, {"bump_height", optional, "Scatter of bump heights", "each bump has its own deviation"},
                 ensemble.bump_height, [](CaseVisitor& inner, HeightScatter& heights) { describe(inner, heights); });
  scatter("bump_foil_thickness", "Scatter of the thickness of the bump foil", ensemble.bump_foil_thickness,
          of_thickness);
  scatter("top_foil_thickness", "Scatter of the thickness of the top foil", ensemble.top_foil_thickness, of_thickness);
  scatter("bump_length", "Scatter of the bump length", ensemble.bump_length, of_height);
  scatter("friction_top_bump", "Scatter of friction, top foil on bumps", ensemble.friction_top_bump, of_friction);
  scatter("friction_bump_sleeve", "Scatter of friction, bumps on sleeve", ensemble.friction_bump_sleeve, of_friction);
  scatter("radial_clearance", "Scatter of the radial clearance", ensemble.radial_clearance, of_thickness);
  scatter("formed_radius", "Scatter of the formed radius", ensemble.formed_radius, of_radius);
  optional_table(keys, {"sleeve_waviness", optional, "Random waviness of the sleeve", "waves with a random phase"},
                 ensemble.sleeve_waviness, [](CaseVisitor& inner, WavinessScatter& waves) { describe(inner, waves); });
}

template <typename Table>
void table(CaseVisitor& keys, const Key& key, Table& members) {
  defaulted_table(keys, key, members, [](CaseVisitor& inner, Table& held) { describe(inner, held); });
}

}  // namespace

void describe_own_design(CaseVisitor& keys, const BearingDesign& common, RotorBearing& own) {
  using enum Presence;
  const auto own_part = [&keys](std::string_view name, std::string_view title, std::string_view text,
                                const auto& members, auto& held) {
    own_table(keys, {name, inherited, title, text}, members, held,
              [](CaseVisitor& inner, auto& visited) { describe(inner, visited); });
  };
  own_part("bearing", "Its bearing", "any keys of [bearing] that differ", common.bearing, own.bearing);
  own_part("bump_foil", "Its bump foil", "any keys of [bump_foil] that differ", common.bump_foil, own.bump_foil);
  own_part("top_foil", "Its top foil", "any keys of [top_foil] that differ", common.top_foil, own.top_foil);
  own_part("friction", "Its friction", "any keys of [friction] that differ", common.friction, own.friction);
  PadDesign design = common;
  design.bump_foil = own.bump_foil.value_or(common.bump_foil);
  design.top_foil = own.top_foil.value_or(common.top_foil);
  list_of_tables(keys, {"pad", optional, "Its pad", "in place of all pads of the case"}, own.pads,
                 [&design](CaseVisitor& inner, Pad& pad) { describe(inner, design, pad); });
}

void describe(CaseVisitor& keys, Case& input) {
  using enum Presence;
  keys.value({"title", defaulted, "Title"}, &input.title);
  table(keys, {"bearing", required, "Bearing"}, input.bearing);
  table(keys, {"bump_foil", required, "Bump foil"}, input.bump_foil);
  // The Le Lez (2007) model has no top foil.
  const Presence top_foil = input.bump_foil.model == BumpFoilModel::former ? optional : required;
  table(keys, {"top_foil", top_foil, "Top foil"}, input.top_foil);
  list_of_tables(
      keys,
      {"pad", optional, "Pad", "a part of the sleeve with its own foils, welded at one edge and free at the other"},
      input.pads, [&input](CaseVisitor& inner, Pad& pad) { describe(inner, input, pad); });
  table(keys, {"friction", required, "Coefficients of friction", "Coulomb friction of the bump foil; 0 for none"},
        input.friction);
  table(keys, {"solver", defaulted, "Solver"}, input.solver);
  for (const CaseTable& table : case_tables()) table.describe(keys, input);
  optional_table(
      keys,
      {"montecarlo", optional, "Ensemble",
       "bearings that differ within their tolerances, for the command montecarlo: for each a cycle in each direction "
       "of [cycle], the states of [equilibrium], or the rotor over the speeds of [stability], [unbalance] or "
       "[transient]; "
       "deviations are from the values above"},
      input.montecarlo, [](CaseVisitor& inner, MonteCarloSettings& ensemble) { describe(inner, ensemble); });
}

}  // namespace bumpfoil
