#include "support/film_bearing_cases.hpp"

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"

#include <numbers>

#include "support/json_data.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

constexpr double micrometre = 1e-6;

const nlohmann::json& prototype() {
  static const nlohmann::json parsed = json_data("film_bearing.json");
  return parsed;
}

Eigen::Vector2d read_force(const nlohmann::json& entry) {
  return {entry.at("Fx").get<double>(), entry.at("Fy").get<double>()};
}

FilmResolution read_resolution(const nlohmann::json& entry) {
  return {.columns_per_pitch = entry.at("m"), .rows = entry.at("nz")};
}

Eigen::Matrix2d read_matrix(const nlohmann::json& entry) {
  const auto rows = entry.get<std::vector<std::vector<double>>>();
  Eigen::Matrix2d matrix;
  matrix << rows[0][0], rows[0][1], rows[1][0], rows[1][1];
  return matrix;
}

/// K + i omega C
Eigen::Matrix2cd read_impedance(const nlohmann::json& stiffness, const nlohmann::json& damping, double frequency) {
  return read_matrix(stiffness) + std::complex<double>(0.0, frequency) * read_matrix(damping);
}

std::vector<ReferenceRun> read_runs() {
  std::vector<ReferenceRun> runs;
  for (const nlohmann::json& entry : prototype().at("frictionless")) {
    const nlohmann::json& position = entry.at("position_Cr");
    ReferenceRun run{.position = {position.at(0).get<double>(), position.at(1).get<double>()},
                     .speed = speed_of_rpm(entry.at("rpm"))};
    for (const nlohmann::json& level : entry.at("levels")) {
      run.levels.push_back({.resolution = read_resolution(level),
                            .force = read_force(level),
                            .thinnest = level.at("hmin").get<double>() * micrometre,
                            .max_pressure = level.at("Pmax"),
                            .min_pressure = level.at("Pmin"),
                            .torque = level.at("torque"),
                            .power = level.at("power"),
                            .dissipation = level.at("dissipation"),
                            .flows = {level.at("flow_theta0"), level.at("flow_theta_end"), level.at("flow_sides")},
                            .loaded_bumps = level.at("closed_top")});
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<ReferenceEquilibrium> read_equilibria() {
  std::vector<ReferenceEquilibrium> equilibria;
  for (const nlohmann::json& entry : prototype().at("load_equilibria")) {
    const auto load = entry.at("load_N").get<std::vector<double>>();
    ReferenceEquilibrium equilibrium{
        .resolution = read_resolution(entry), .load = {load[0], load[1]}, .speed = speed_of_rpm(entry.at("rpm"))};
    equilibrium.position = {entry.at("x").get<double>(), entry.at("y").get<double>()};
    equilibrium.stiffness = read_matrix(entry.at("K0"));
    equilibrium.impedance = read_impedance(entry.at("K_whirl"), entry.at("C_whirl"), equilibrium.speed);
    equilibria.push_back(equilibrium);
  }
  return equilibria;
}

ReferencePath read_path() {
  const nlohmann::json& entry = prototype().at("friction_path");
  ReferencePath path{.resolution = read_resolution(entry), .speed = speed_of_rpm(entry.at("rpm"))};
  for (const nlohmann::json& row : entry.at("rows")) {
    path.increments.push_back({.eccentricity = row.at("e"),
                               .force = read_force(row),
                               .thinnest = row.at("hmin").get<double>() * micrometre,
                               .power = row.at("power"),
                               .dissipated = row.at("dissipated"),
                               .loaded_bumps = row.at("closed_top")});
  }
  path.last_bump_loads = entry.at("bump_loads_end").get<std::vector<double>>();
  return path;
}

std::vector<ReferenceWhirl> read_whirls() {
  const double speed = read_path().speed;
  std::vector<ReferenceWhirl> whirls;
  for (const nlohmann::json& entry : prototype().at("friction_whirl")) {
    const double frequency = entry.at("frequency_over_speed").get<double>() * speed;
    whirls.push_back({entry.at("stuck"), frequency, read_impedance(entry.at("K"), entry.at("C"), frequency)});
  }
  return whirls;
}

}  // namespace

Case film_reference_case(const FilmResolution& resolution, double friction_coefficient) {
  Case input = case_with_given_constants();
  input.friction = {.top_bump = friction_coefficient, .bump_sleeve = friction_coefficient};
  input.gas = {.viscosity = 1.85e-5, .ambient_pressure = 101325.0};
  input.film = {.columns_per_pitch = resolution.columns_per_pitch, .rows = resolution.rows};
  input.width.modes = resolution.width_modes;
  input.width.sheet = resolution.sheet == SheetModel::elastic;
  if (resolution.width == WidthPart::whole) input.width.moment = {0.0, 0.0};
  return input;
}

BearingModel film_reference_bearing(const FilmResolution& resolution, double friction_coefficient) {
  return make_film_bearing(film_reference_case(resolution, friction_coefficient));
}

double speed_of_rpm(double rpm) {
  return rpm * std::numbers::pi / 30.0;
}

std::vector<double> speeds_of_rpm(const std::vector<double>& rpm) {
  std::vector<double> speeds;
  speeds.reserve(rpm.size());
  for (const double one : rpm) speeds.push_back(speed_of_rpm(one));
  return speeds;
}

Case film_rotor_case(const FilmResolution& resolution) {
  Case input = film_reference_case(resolution);
  RotorSettings rotor;
  rotor.mass = 2.0;
  rotor.gravity = {9.81, 0.0};
  input.settings.set(rotor);
  return input;
}

const std::vector<ReferenceRun>& reference_runs() {
  static const std::vector<ReferenceRun> runs = read_runs();
  return runs;
}

const std::vector<ReferenceEquilibrium>& reference_equilibria() {
  static const std::vector<ReferenceEquilibrium> equilibria = read_equilibria();
  return equilibria;
}

const std::vector<ReferenceWhirl>& reference_friction_whirls() {
  static const std::vector<ReferenceWhirl> whirls = read_whirls();
  return whirls;
}

const ReferencePath& reference_friction_path() {
  static const ReferencePath path = read_path();
  return path;
}

}  // namespace bumpfoil
