#include "support/film_cases.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "support/json_data.hpp"

namespace bumpfoil {
namespace {

/// Half the axial length over the radius of all films of the file.
constexpr double half_width = 1.0;
/// Eccentricity at which P = 1 is close enough to the film for Newton's method, with any foundation.
constexpr double first_eps = 0.3;

ReferenceFilm::Values read_values(const nlohmann::json& entry) {
  ReferenceFilm::Values values{.cosine = entry.at("c"), .sine = entry.at("s"), .max_pressure = entry.at("Pmax")};
  values.torque = entry.value("tau", 0.0);
  if (entry.contains("mesh")) {
    values.columns = entry.at("mesh").at(0);
    values.rows = entry.at("mesh").at(1);
  }
  return values;
}

FoundationKind read_kind(const std::string& name) {
  if (name == "pointwise") return FoundationKind::pointwise;
  return name == "axial_mean" ? FoundationKind::axial_mean : FoundationKind::rigid;
}

std::vector<ReferenceFilm> read_films() {
  const auto document = json_data("film_rigid_and_winkler.json");
  std::vector<ReferenceFilm> films;
  for (const nlohmann::json& entry : document.at("films")) {
    ReferenceFilm film{.bearing_number = entry.at("Lam"),
                       .eps = entry.at("eps"),
                       .attitude = entry.at("attitude_of_hmax_deg").get<double>() * degree,
                       .closed = entry.at("closed")};
    film.theta_end = entry.value("theta_end", 0.0);
    film.foundation = {read_kind(entry.at("foundation")), entry.at("compliance")};
    for (const nlohmann::json& level : entry.at("levels")) film.levels.push_back(read_values(level));
    film.extrapolated = read_values(entry.at("extrapolated"));
    films.push_back(std::move(film));
  }
  return films;
}

/// The same from a computed film. The load is the reaction on the journal, which reverses the angle.
std::complex<double> computed_load(double Lam, double l, int columns, int rows) {
  constexpr double eps = 1e-4;  // higher orders are its square
  const FilmMesh mesh = make_closed_mesh(columns, rows, l);
  const SolvedFilm solved = solve_rigid_film({.mesh = mesh, .bearing_number = Lam}, eccentric_thickness(mesh, eps));
  const FilmIntegrals sums = film_integrals(solved.equation, solved.film);
  return std::complex<double>(-sums.cosine, sums.sine) / (4.0 * l * eps);
}

}  // namespace

std::complex<double> load_of_small_eccentricity(double bearing_number, double l) {
  const std::complex<double> i(0.0, 1.0);
  const std::complex<double> g = std::sqrt(1.0 + i * bearing_number);
  return 0.5 * std::numbers::pi * i * bearing_number / (1.0 + i * bearing_number) * (1.0 - std::tanh(g * l) / (g * l));
}

SmallEccentricityCheck check_small_eccentricity(double bearing_number, double l, int columns, int rows) {
  const std::complex<double> exact = load_of_small_eccentricity(bearing_number, l);
  const std::complex<double> coarse = computed_load(bearing_number, l, columns, rows);
  const std::complex<double> fine = computed_load(bearing_number, l, 2 * columns, 2 * rows);
  return {.load_defect = std::abs(richardson(std::abs(coarse), std::abs(fine)) / std::abs(exact) - 1.0),
          .attitude_defect = std::abs(richardson(std::arg(coarse), std::arg(fine)) - std::arg(exact)),
          .ratio = (std::abs(coarse) - std::abs(exact)) / (std::abs(fine) - std::abs(exact))};
}

Matrix eccentric_thickness(const FilmMesh& mesh, double eps, double attitude) {
  Matrix H = mesh.field(1.0);
  H.rowwise() += (eps * (mesh.angles().array() - attitude).cos()).matrix().transpose();
  return H;
}

FilmMesh ReferenceFilm::mesh(int columns, int rows) const {
  return closed ? make_closed_mesh(columns, rows, half_width) : make_slotted_mesh(columns, rows, half_width, theta_end);
}

std::string ReferenceFilm::name() const {
  return fmt::format("{} Lam {:.4g}, eps {}, attitude {:.3g}, foundation {} {}", closed ? "closed" : "slotted",
                     bearing_number, eps, attitude, static_cast<int>(foundation.kind), foundation.compliance);
}

const std::vector<ReferenceFilm>& reference_films() {
  static const std::vector<ReferenceFilm> films = read_films();
  return films;
}

SolvedFilm solve_reference_film(const ReferenceFilm& reference, int columns, int rows) {
  const FilmMesh mesh = reference.mesh(columns, rows);
  SolvedFilm solved{.equation = {.mesh = mesh, .bearing_number = reference.bearing_number}};
  const Matrix target = eccentric_thickness(mesh, reference.eps, reference.attitude);
  if (reference.foundation.kind == FoundationKind::rigid) return solve_rigid_film(solved.equation, target);
  FilmSolver solver(mesh, reference.foundation);
  const Matrix start = eccentric_thickness(mesh, first_eps, reference.attitude);
  solved.film = {mesh.field(1.0), start};
  solved.report = solver.solve(solved.equation, start, solved.film);
  if (solved.report.status == Status::converged) {
    solved.report = solver.follow(solved.equation, start, target, solved.film);
  }
  return solved;
}

SolvedFilm solve_rigid_film(const ReynoldsEquation& equation, const Matrix& thickness) {
  SolvedFilm solved{.equation = equation, .film = {equation.mesh.field(1.0), thickness}};
  FilmSolver solver(equation.mesh, {});
  solved.report = solver.solve(equation, thickness, solved.film);
  return solved;
}

}  // namespace bumpfoil
