#pragma once

#include <complex>
#include <string>
#include <vector>

#include "bumpfoil/film/film_integrals.hpp"
#include "bumpfoil/film/film_solver.hpp"

namespace bumpfoil {

/// H = 1 + eps cos(theta - attitude) at all nodes.
Matrix eccentric_thickness(const FilmMesh& mesh, double eps, double attitude = 0.0);

/// A film of tests/data/film_rigid_and_winkler.json, L/D = 1.
struct ReferenceFilm {
  /// Values on one mesh, or extrapolated from several.
  struct Values {
    int columns{}, rows{};
    double cosine{}, sine{}, max_pressure{};
    double torque{};  ///< 0 where the file has none
  };
  double bearing_number{}, eps{}, attitude{};
  bool closed{};
  double theta_end{};
  Foundation foundation{};
  std::vector<Values> levels{};
  Values extrapolated{};

  [[nodiscard]] FilmMesh mesh(int columns, int rows) const;
  [[nodiscard]] std::string name() const;
};

const std::vector<ReferenceFilm>& reference_films();

/// The film of a case on a mesh: by continuation in the eccentricity for a compliant foundation.
struct SolvedFilm {
  ReynoldsEquation equation;
  FilmState film{};
  FilmReport report{};
};
SolvedFilm solve_reference_film(const ReferenceFilm& reference, int columns, int rows);

/// The film without a foundation, starting from P = 1.
SolvedFilm solve_rigid_film(const ReynoldsEquation& equation, const Matrix& thickness);

/// Load and attitude angle of a closed bearing at a vanishing eccentricity, by perturbation: with
/// z = i Lam / (1 + i Lam) (1 - tanh(g l) / (g l)), g^2 = 1 + i Lam, l = L/D, the load per pa L D eps is (pi/2) abs(z),
/// the angle arg(z).
/// @return (pi/2) z
std::complex<double> load_of_small_eccentricity(double bearing_number, double l);

/// Results from a mesh and one of half its spacing.
struct SmallEccentricityCheck {
  double load_defect{};      ///< of the extrapolated load, relative
  double attitude_defect{};  ///< of the extrapolated attitude angle, rad
  double ratio{};            ///< of the load errors of the two meshes: 4 for second order
};
SmallEccentricityCheck check_small_eccentricity(double bearing_number, double l, int columns, int rows);

/// Second-order extrapolation of values on a mesh and on one of half its spacing.
inline double richardson(double coarse, double fine) {
  return fine + (fine - coarse) / 3.0;
}

}  // namespace bumpfoil
