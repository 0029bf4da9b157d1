#include "bumpfoil/experiments/rotor_settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/rotor/unbalance.hpp"
#include "case/case_keys.hpp"
#include "experiments/film/film_keys.hpp"
#include "experiments/rotor_keys.hpp"
#include "experiments/rotor_matrices_json.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

/// Minimum number of elements of a shaft.
constexpr double shaft_elements = 60.0;

constexpr Range mass_range{1e-6, 1e6, "kg"};
constexpr Range inertia_range{1e-15, 1e6, "kg m2"};
constexpr Range density_of_shaft_range{1.0, 1e5, "kg/m3"};
constexpr double most_gravity = 1e5;      // m/s^2
constexpr double most_rotor_speed = 1e6;  // rad/s
constexpr std::size_t most_rotor_speeds = 10'000;
/// Accepted distance of a plane from a position of the matrices, relative to the distance of the bearings.
constexpr double same_plane = 1e-6;
/// A bearing with a smaller fraction of the weight counts as unloaded.
constexpr double least_part_of_weight = 1e-6;

double length_of(const std::vector<ShaftSection>& shaft) {
  return std::accumulate(shaft.begin(), shaft.end(), 0.0,
                         [](double sum, const ShaftSection& section) { return sum + section.length; });
}

/// Fraction of the rotor in the model if it does not tilt.
constexpr double half = 0.5;

std::vector<double> planes_of(const RotorSettings& settings) {
  std::vector<double> planes;
  planes.reserve(settings.unbalances.size());
  for (const RotorUnbalance& unbalance : settings.unbalances) planes.push_back(unbalance.at);
  return planes;
}

/// Unbalances in their planes; half of each if half the rotor is modelled.
std::vector<std::pair<RotorStation, Unbalance>> placed_unbalances(const RotorSettings& settings, const Rotor& rotor) {
  const std::size_t count = settings.unbalances.size();
  const double part = settings.tilts() ? 1.0 : half;
  std::vector<std::pair<RotorStation, Unbalance>> placed;
  for (std::size_t i = 0; i < count; ++i) {
    const RotorUnbalance& one = settings.unbalances[i];
    const double amount = one.amount ? *one.amount
                                     : unbalance_of_grade(one.grade.value_or(0.0), rotor.total_mass() / part,
                                                          one.grade_speed.value_or(1.0));
    // Planes are the last stations.
    placed.emplace_back(settings.tilts() ? rotor.stations[rotor.stations.size() - count + i] : rotor.bearings.front(),
                        Unbalance{.amount = part * amount, .phase = one.phase});
  }
  return placed;
}

/// The position of a rotor given by matrices in the plane of an unbalance; null if there is none.
const MatrixPlace* place_at(const RotorMatrices& matrices, double z) {
  const double span = std::abs(matrices.bearings.back().z - matrices.bearings.front().z);
  for (const std::vector<MatrixPlace>* places : {&matrices.bearings, &matrices.stations}) {
    const auto found = std::find_if(places->begin(), places->end(), [&](const MatrixPlace& place) {
      return std::abs(place.z - z) <= same_plane * span;
    });
    if (found != places->end()) return &*found;
  }
  return nullptr;
}

/// Adds a station in the plane of each unbalance after those of the matrices.
Rotor rotor_of_matrices(const RotorSettings& settings) {
  RotorMatrices matrices = *settings.matrices;
  for (std::size_t i = 0; i < settings.unbalances.size(); ++i) {
    MatrixPlace plane = *place_at(*settings.matrices, settings.unbalances[i].at);
    plane.name = fmt::format("plane {}", i + 1);
    matrices.stations.push_back(std::move(plane));
  }
  return make_rotor(matrices);
}

Rotor full_rotor(const RotorSettings& settings) {
  if (settings.matrices) return rotor_of_matrices(settings);
  if (!settings.tilts()) return make_point_mass(half * settings.mass.value_or(0.0));
  if (settings.is_flexible()) {
    return make_flexible_rotor({.sections = settings.shaft,
                                .discs = settings.disks,
                                .bearings = settings.bearings,
                                .planes = planes_of(settings),
                                .longest_element = length_of(settings.shaft) / shaft_elements});
  }
  return make_rigid_rotor({.mass = settings.mass.value_or(0.0),
                           .transverse_inertia = settings.transverse_inertia.value_or(0.0),
                           .polar_inertia = settings.polar_inertia.value_or(0.0),
                           .bearings = settings.bearings,
                           .planes = planes_of(settings)});
}

void describe(CaseVisitor& keys, ShaftSection& section) {
  using enum Presence;
  using enum Dimension;
  keys.value({"length", required, "Length", "", "40 mm", length}, &section.length);
  keys.value({"outer_diameter", required, "Outer diameter", "", "38 mm", length}, &section.outer_diameter);
  keys.value({"inner_diameter", defaulted, "Inner diameter", "0: solid", "0 mm", length}, &section.inner_diameter);
  keys.value({"youngs_modulus", required, "Young's modulus", "", "210 GPa", pressure}, &section.youngs_modulus);
  keys.value({"poisson_ratio", required, "Poisson's ratio", "", "0.3"}, &section.poisson_ratio);
  keys.value({"density", required, "Density", "", "7800 kg/m3", density}, &section.density);
}

void describe(CaseVisitor& keys, ShaftDisc& disk) {
  using enum Presence;
  using enum Dimension;
  keys.value({"at", required, "Place", "of its centre of mass, from the start of the shaft", "150 mm", length},
             &disk.z);
  keys.value({"mass", required, "Mass", "", "0.3 kg", mass}, &disk.mass);
  keys.value(
      {"transverse_inertia", required, "Transverse inertia", "about a diameter", "1e-4 kg m2", moment_of_inertia},
      &disk.transverse_inertia);
  keys.value({"polar_inertia", required, "Polar inertia", "about the axis", "2e-4 kg m2", moment_of_inertia},
             &disk.polar_inertia);
}

void describe(CaseVisitor& keys, RotorUnbalance& one) {
  using enum Presence;
  using enum Dimension;
  keys.value({"amount", optional, "Amount", "mass times distance from the axis", "2 g mm", unbalance}, &one.amount);
  keys.value({.name = "grade",
              .presence = optional,
              .title = "Balance quality grade",
              .text = "of ISO 21940-11: its whole permissible unbalance of the rotor acts in this plane",
              .example = "2.5 mm/s",
              .dimension = velocity,
              .instead = true},
             &one.grade);
  keys.value({"grade_speed", optional, "Speed of the grade", "at which it applies", "60000 rpm", frequency},
             &one.grade_speed);
  keys.value(
      {"at", defaulted, "Place", "of its plane along the axis, measured like those of the bearings", "0 mm", length},
      &one.at);
  keys.value(
      {"phase", defaulted, "Phase", "of the heavy spot, from X towards Y, with the rotor at angle 0", "0 deg", angle},
      &one.phase);
}

void describe(CaseVisitor& keys, MatrixPlace& place) {
  using enum Presence;
  keys.value({"name", required, "Name", "", "\"drive end\""}, &place.name);
  keys.value({"z", required, "Place", "along the axis", "40 mm", Dimension::length}, &place.z);
  keys.value({"x", required, "Unknown along X", "number of its row, from 0", "0"}, &place.x);
  keys.value({"y", required, "Unknown along Y", "number of its row, from 0", "1"}, &place.y);
}

void describe(CaseVisitor& keys, RotorMatrices& matrices) {
  using enum Presence;
  constexpr std::string_view example = "[1.0, 0.0, 0.0, ...]";
  keys.value({"M", required, "Mass matrix", "M of M y'' + (Omega G + C) y' + K y, symmetric", example}, &matrices.mass);
  keys.value({"C", required, "Damping matrix", "of parts that do not rotate, symmetric", example}, &matrices.damping);
  keys.value({"G", required, "Gyroscopic matrix", "antisymmetric; positive speeds turn X to Y", example},
             &matrices.gyroscopic);
  keys.value({"K", required, "Stiffness matrix", "symmetric", example}, &matrices.stiffness);
  list_of_tables(keys, {"bearing", required, "Bearing", "position of a bearing"}, matrices.bearings,
                 [](CaseVisitor& inner, MatrixPlace& place) { describe(inner, place); });
  list_of_tables(keys, {"station", optional, "Station", "another position that results include, or with an unbalance"},
                 matrices.stations, [](CaseVisitor& inner, MatrixPlace& place) { describe(inner, place); });
}

void describe(CaseVisitor& keys, RotorSettings& rotor) {
  using enum Presence;
  using enum Dimension;
  keys.value(
      {"mass", optional, "Mass",
       "of the rotor, half on each of two equal bearings; that of a flexible one follows from its shaft", "2 kg", mass},
      &rotor.mass);
  keys.value({"gravity", defaulted, "Gravity", "along X and Y", "[\"0 m/s2\", \"-9.81 m/s2\"]", acceleration},
             &rotor.gravity);
  keys.value(
      {"bearings", optional, "Bearings",
       "positions along the axis, for a rotor that tilts: from the centre of mass of a rigid one, from the start "
       "of a shaft",
       "[\"-50 mm\", \"60 mm\"]", length},
      &rotor.bearings);
  keys.value(
      {"transverse_inertia", optional, "Transverse inertia",
       "of a rigid rotor that tilts, about a diameter through its centre of mass", "9e-3 kg m2", moment_of_inertia},
      &rotor.transverse_inertia);
  keys.value({"polar_inertia", optional, "Polar inertia", "of a rigid rotor that tilts, about its axis", "1.1e-3 kg m2",
              moment_of_inertia},
             &rotor.polar_inertia);
  list_of_tables(keys, {"shaft", optional, "Shaft", "a section of a flexible shaft, one after the other"}, rotor.shaft,
                 [](CaseVisitor& inner, ShaftSection& section) { describe(inner, section); });
  list_of_tables(keys, {"disk", optional, "Disk", "rigid, on the shaft"}, rotor.disks,
                 [](CaseVisitor& inner, ShaftDisc& disk) { describe(inner, disk); });
  keys.file({"matrices", optional, "File of matrices",
             "of a free rotor, instead of all of these: a JSON file beside this one with M, C, G, K, bearing and "
             "station",
             "\"rotor.json\""},
            "matrix", [&rotor](const std::string& path) {
              rotor.matrices.emplace();  // of this kind, even if the file is invalid
              rotor.matrices = read_rotor_matrices(path);
            });
  optional_table(keys,
                 {"matrix", optional, "Matrices", "of a rotor, the contents of the file: row by row, in SI units"},
                 rotor.matrices, [](CaseVisitor& inner, RotorMatrices& matrices) { describe(inner, matrices); });
  list_of_tables(keys, {"unbalance", optional, "Unbalance", "in one plane, for the command unbalance"},
                 rotor.unbalances, [](CaseVisitor& inner, RotorUnbalance& one) { describe(inner, one); });
}

/// Bearings that differ from that of the case.
void describe_bearings(CaseVisitor& keys, Case& input) {
  list_of_tables(
      keys,
      {"bearing", Presence::optional, "Bearing of the rotor",
       "one for each entry of bearings, in the same order: its keys that differ from the tables of the case; "
       "empty if none does"},
      input.rotor_bearings, [&input](CaseVisitor& inner, RotorBearing& own) {
        describe_own_design(inner, input, own);
        describe_own_film(inner, input, own);
      });
}

/// Checks positive numbers that may be absent.
bool check_optional(Checks& checks, const std::string& key, const std::optional<double>& value, const Range& range) {
  return !value || checks.within(key, *value, range);
}

bool check_shaft(Checks& checks, const RotorSettings& rotor) {
  if (!rotor.is_flexible()) return true;
  bool right = true;
  for (std::size_t i = 0; i < rotor.shaft.size(); ++i) {
    const ShaftSection& section = rotor.shaft[i];
    const auto key = [i](const char* name) { return fmt::format("rotor.shaft[{}].{}", i + 1, name); };
    right &= checks.within(key("length"), section.length, length_range);
    right &= checks.within(key("outer_diameter"), section.outer_diameter, length_range);
    right &= checks.within(key("inner_diameter"), section.inner_diameter, {0.0, length_range.most, "m"});
    right &= checks.require(section.inner_diameter < section.outer_diameter || section.outer_diameter <= 0.0,
                            key("inner_diameter"), quantity(section.inner_diameter, "m"),
                            "is not smaller than the outer diameter", "give a smaller one, or 0 for a solid shaft");
    right &= checks.within(key("youngs_modulus"), section.youngs_modulus, modulus_range);
    right &= checks.within(key("poisson_ratio"), section.poisson_ratio, poisson_range);
    right &= checks.within(key("density"), section.density, density_of_shaft_range);
  }
  if (!right) return false;
  const double end = length_of(rotor.shaft);
  const auto lies_on_it = [&](const std::string& key, double z) {
    return checks.require(z >= 0.0 && z <= end * (1.0 + round_off), key, quantity(z, "m"), "is not on the shaft",
                          fmt::format("give a position between its start, 0 m, and its end, {:.6g} m", end));
  };
  for (std::size_t i = 0; i < rotor.disks.size(); ++i) {
    const ShaftDisc& disk = rotor.disks[i];
    const std::string name = fmt::format("rotor.disk[{}]", i + 1);
    right &= lies_on_it(name + ".at", disk.z);
    right &= checks.within(name + ".mass", disk.mass, mass_range);
    right &= checks.within(name + ".transverse_inertia", disk.transverse_inertia, inertia_range);
    right &= checks.within(name + ".polar_inertia", disk.polar_inertia, {0.0, inertia_range.most, "kg m2"});
  }
  for (std::size_t i = 0; i < rotor.bearings.size(); ++i) {
    right &= lies_on_it(fmt::format("rotor.bearings[{}]", i + 1), rotor.bearings[i]);
  }
  return right;
}

bool check_unbalances(Checks& checks, const RotorSettings& rotor) {
  bool right = true;
  const double end = length_of(rotor.shaft);
  for (std::size_t i = 0; i < rotor.unbalances.size(); ++i) {
    const RotorUnbalance& one = rotor.unbalances[i];
    const std::string name = fmt::format("rotor.unbalance[{}]", i + 1);
    right &= check_optional(checks, name + ".amount", one.amount, {0.0, 1.0, "kg m"});
    right &= check_optional(checks, name + ".grade", one.grade, {0.0, 10.0, "m/s"});
    right &= check_optional(checks, name + ".grade_speed", one.grade_speed, frequency_range);
    right &= checks.require(one.amount.has_value() != one.grade.has_value(), name + ".amount", "",
                            one.amount ? "is given in addition to a grade" : "is missing, as is a grade",
                            "give an amount such as \"2 g mm\", or a grade such as \"2.5 mm/s\" with its grade_speed");
    right &= checks.require(one.grade.has_value() == one.grade_speed.has_value(), name + ".grade_speed", "",
                            one.grade ? "is missing: a grade applies at a speed" : "is given without a grade",
                            "give both, such as grade = \"2.5 mm/s\" and grade_speed = \"60000 rpm\"");
    right &= checks.finite(name + ".phase", one.phase, "rad");
    if (rotor.matrices) {
      right &= checks.require(place_at(*rotor.matrices, one.at) != nullptr, name + ".at", quantity(one.at, "m"),
                              "is not a bearing or station of the matrices", "give the z of a bearing or station");
    } else if (rotor.is_flexible()) {
      right &= checks.require(one.at >= 0.0 && one.at <= end * (1.0 + round_off), name + ".at", quantity(one.at, "m"),
                              "is not on the shaft",
                              fmt::format("give a position between its start, 0 m, and its end, {:.6g} m", end));
    } else {
      right &= checks.finite(name + ".at", one.at, "m");
      right &= checks.require(rotor.tilts() || one.at == 0.0, name + ".at", quantity(one.at, "m"),
                              "is a position on a rotor that does not tilt",
                              "remove it, or give rotor.bearings and rotor.transverse_inertia");
    }
  }
  return right;
}

/// Checks for keys of another kind of rotor, and for missing keys of its own kind.
bool check_kind(Checks& checks, const RotorSettings& rotor) {
  bool right = true;
  const auto belongs = [&](bool is_right, const char* key, const char* what, const char* advice) {
    right &= checks.require(is_right, key, "", what, advice);
  };
  if (rotor.matrices) {
    const std::array others{std::pair("rotor.mass", rotor.mass.has_value()),
                            std::pair("rotor.transverse_inertia", rotor.transverse_inertia.has_value()),
                            std::pair("rotor.polar_inertia", rotor.polar_inertia.has_value()),
                            std::pair("rotor.bearings", !rotor.bearings.empty()),
                            std::pair("rotor.shaft", !rotor.shaft.empty()),
                            std::pair("rotor.disk", !rotor.disks.empty())};
    for (const auto& [key, given] : others) {
      belongs(!given, key, "is given in addition to matrices, which include it", "remove it, or rotor.matrices");
    }
    return right;
  }
  if (rotor.is_flexible()) {
    belongs(!rotor.mass, "rotor.mass", "is given in addition to a shaft, whose sections and disks have the mass",
            "remove rotor.mass, or all [[rotor.shaft]]");
    belongs(!rotor.transverse_inertia && !rotor.polar_inertia,
            rotor.transverse_inertia ? "rotor.transverse_inertia" : "rotor.polar_inertia",
            "is given in addition to a shaft, whose sections and disks have the inertia",
            "remove it, or all [[rotor.shaft]]");
  } else {
    belongs(rotor.mass.has_value(), "rotor.mass", "is missing",
            "give a mass such as \"2 kg\", or the sections of a shaft, [[rotor.shaft]]");
    belongs(rotor.disks.empty(), "rotor.disk", "has no shaft to sit on", "give [[rotor.shaft]], or remove it");
    if (rotor.tilts()) {
      belongs(rotor.transverse_inertia.has_value(), "rotor.transverse_inertia",
              "is missing: a rotor with bearing positions can tilt",
              "give a moment of inertia such as \"9e-3 kg m2\", or remove rotor.bearings");
    } else {
      belongs(!rotor.transverse_inertia && !rotor.polar_inertia,
              rotor.transverse_inertia ? "rotor.transverse_inertia" : "rotor.polar_inertia",
              "applies to a rotor that tilts, and this one has no bearing positions",
              "give rotor.bearings such as [\"-50 mm\", \"60 mm\"], or remove it");
    }
  }
  if (rotor.tilts()) {
    belongs(rotor.bearings.size() == 2 && rotor.bearings[0] != rotor.bearings[1], "rotor.bearings",
            "are not two different positions", "give two, such as [\"-50 mm\", \"60 mm\"]");
  }
  return right;
}

bool check_matrices(Checks& checks, const RotorMatrices& matrices) {
  const std::vector<InputError> errors = find_matrix_errors(matrices);
  for (const InputError& error : errors) {
    checks.require(false, "rotor.matrix." + error.key, error.value, error.what, error.advice);
  }
  return errors.empty();
}

/// Checks that bearings that differ match one position each.
void check_own_bearings(Checks& checks, const RotorSettings& rotor, std::size_t count) {
  if (count == 0) return;
  if (!checks.require(rotor.tilts(), "rotor.bearing", "",
                      "is given for a rotor that does not tilt, which has two equal bearings",
                      "remove all [[rotor.bearing]], or give rotor.bearings and rotor.transverse_inertia")) {
    return;
  }
  checks.require(
      count == rotor.bearing_count(), "rotor.bearing", "",
      fmt::format("is given {} times, for {} bearing positions", count, rotor.bearing_count()),
      "give one [[rotor.bearing]] for each position, in the same order; an empty one is the bearing of the case");
}

/// Bearings that resist tilt require a rotor model with tilt.
void check_tilting(Checks& checks, const RotorSettings& rotor, const Case& input) {
  if (!rotor.matrices) return;
  bool resists = false;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, input.rotor_bearings.size()); ++i) {
    const Case bearing = bearing_at(input, i);
    resists |= bearing.width.modes > 1 || bearing.top_foil.split || !bearing.has_equal_halves();
  }
  if (!resists) return;
  checks.require_for(
      experiments_where(&CaseTable::rotor), false, "rotor.matrices", "",
      "name only displacements at the bearings, but these bearings also resist inclinations",
      "set width.modes = 1 without tilt, conicity, unlike side pressures and split top foils, or give the rotor by "
      "[[rotor.shaft]]");
}

}  // namespace

ReducedRotor rotor_of(const RotorSettings& settings, double range, const std::vector<double>& half_widths) {
  Rotor rotor = full_rotor(settings);
  for (std::size_t i = 0; i < half_widths.size(); ++i) rotor.bearings[i].half_width = half_widths[i];
  if (!settings.is_flexible() && !settings.matrices) return {std::move(rotor), 0.0};
  return reduce_rotor(rotor, range);
}

Eigen::VectorXcd unbalance_force(const RotorSettings& settings, const Rotor& rotor, double speed) {
  Eigen::VectorXcd force = Eigen::VectorXcd::Zero(rotor.size());
  for (const auto& [plane, unbalance] : placed_unbalances(settings, rotor)) {
    force += unbalance_force(plane, unbalance, speed);
  }
  return force;
}

RotorForces forces_on(const RotorSettings& settings, const Rotor& rotor) {
  const Eigen::VectorXd weight = rotor.inertia_force(settings.gravity_vector());
  return [weight, placed = placed_unbalances(settings, rotor)](const RotorInstant& now) -> Eigen::VectorXd {
    Eigen::VectorXd force = weight;
    for (const auto& [plane, unbalance] : placed) {
      force += unbalance_force(plane, unbalance, now.angle, now.speed, now.acceleration);
    }
    return force;
  };
}

void describe_rotor(CaseVisitor& keys, Case& input) {
  const RotorSettings* const held = input.settings.find<RotorSettings>();
  RotorSettings rotor = held == nullptr ? RotorSettings{} : *held;
  keys.table({"rotor", Presence::optional, "Rotor",
              "carried by this bearing and an equal one: a mass; with bearings and inertias a rigid rotor that tilts; "
              "with sections of a shaft a flexible one; or any rotor by its matrices"},
             held != nullptr, [&](CaseVisitor& inner) {
               describe(inner, rotor);
               input.settings.set(rotor);
               describe_bearings(inner, input);
             });
}

void check_rotor(Checks& checks, const Case& input) {
  const RotorSettings* const rotor = input.settings.find<RotorSettings>();
  if (rotor == nullptr) return;
  const bool gravity_right =
      checks.require(rotor->gravity.size() == 2 && std::hypot(rotor->gravity[0], rotor->gravity[1]) > 0.0 &&
                         std::hypot(rotor->gravity[0], rotor->gravity[1]) <= most_gravity,
                     "rotor.gravity", "", "is not an acceleration along X and Y",
                     "give two components such as [\"0 m/s2\", \"-9.81 m/s2\"]");
  bool right = check_optional(checks, "rotor.mass", rotor->mass, mass_range);
  right &= check_optional(checks, "rotor.transverse_inertia", rotor->transverse_inertia, inertia_range);
  right &= check_optional(checks, "rotor.polar_inertia", rotor->polar_inertia, {0.0, inertia_range.most, "kg m2"});
  if (right && rotor->transverse_inertia && rotor->polar_inertia) {
    right &= checks.require(*rotor->polar_inertia <= 2.0 * *rotor->transverse_inertia, "rotor.polar_inertia",
                            quantity(*rotor->polar_inertia, "kg m2"),
                            "is more than twice the transverse inertia, which no body can have",
                            "give I_p about the axis, and I_t about a diameter");
  }
  for (std::size_t i = 0; i < rotor->bearings.size(); ++i) {
    right &= checks.finite(fmt::format("rotor.bearings[{}]", i + 1), rotor->bearings[i], "m");
  }
  if (rotor->matrices && !check_matrices(checks, *rotor->matrices)) return;
  right &= check_kind(checks, *rotor);
  check_own_bearings(checks, *rotor, input.rotor_bearings.size());
  check_tilting(checks, *rotor, input);
  right &= check_shaft(checks, *rotor);
  right &= check_unbalances(checks, *rotor);
  if (!right || !gravity_right) return;
  const Rotor made = full_rotor(*rotor);
  const std::vector<Eigen::Vector2d> loads = weights_on_bearings(made, rotor->gravity_vector());
  const double weight = made.total_mass() * rotor->gravity_vector().norm();
  for (std::size_t i = 0; i < loads.size(); ++i) {
    checks.require(loads[i].norm() > least_part_of_weight * weight, fmt::format("rotor.bearings[{}]", i + 1), "",
                   "carries nothing: the centre of mass lies over the other bearing", "move one of the bearings");
  }
}

void check_rotor_speeds(Checks& checks, const std::string& key, const std::vector<double>& speeds) {
  checks.require(!speeds.empty(), key, "[]", "is empty", "give a list such as [\"10000 rpm\", \"14000 rpm\"]");
  checks.require(speeds.size() <= most_rotor_speeds, key, fmt::format("{} speeds", speeds.size()), "are too many",
                 fmt::format("give {} at most", most_rotor_speeds));
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double speed = speeds[i];
    const std::string entry = fmt::format("{}[{}]", key, i + 1);
    if (!checks.finite(entry, speed, "rad/s")) continue;
    const bool turns = checks.require(speed != 0.0 && std::abs(speed) <= most_rotor_speed, entry,
                                      quantity(speed, "rad/s"), "is not a speed at which a film carries",
                                      fmt::format("give a speed other than zero, {} rad/s at most", most_rotor_speed));
    if (!turns) continue;
    checks.require(speed * speeds.front() >= 0.0, entry, quantity(speed, "rad/s"), "has another sign than the first",
                   "give speeds of one sense of rotation");
  }
}

}  // namespace bumpfoil
