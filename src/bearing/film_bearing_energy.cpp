#include "bumpfoil/bearing/film_bearing_energy.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// 1/2 M^T T M of the top foil of a pad on each of its lines, J.
double bending_energy(const FilmModel& film, const FoilFilm& foil, const Matrix& moments) {
  const TopFoilMoments& form = foil.top_foil;
  const Eigen::Index n = form.size();
  double energy = 0.0;
  for (Eigen::Index line = 0; line < moments.rows(); ++line) {
    const Vector M = foil.stiffness * foil.pitch * film.scales.thickness * moments.row(line).head(n).transpose();
    energy += (0.5 * form.compliance_diagonal.dot(M.cwiseAbs2()) +
               form.compliance_off.dot(M.head(n - 1).cwiseProduct(M.tail(n - 1)))) /
              foil.lines.weight[line];
  }
  return energy;
}

/// Half the membrane load of a top foil times its displacement, J.
double membrane_energy(const FilmModel& film, const FoilFilm& foil, const FoilFilmState& part) {
  const Matrix stretching = product(foil.stretching, part.deflection);
  double twice = 0.0;
  for (std::size_t k = 0; k < foil.membrane.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    twice += foil.membrane[k].length * part.membrane.col(column).head(stretching.rows()).dot(stretching.col(column));
  }
  return 0.5 * foil.stiffness * film.scales.thickness * film.scales.thickness * twice;
}

/// Energy of the asperities of a pad, J.
double asperity_energy(const FilmPad& pad, const Matrix& thickness) {
  const FoilFilm& foil = pad.foil;
  if (!foil.asperities) return 0.0;
  const FilmMesh& mesh = foil.mesh;
  double energy = 0.0;
  for (int k = 0; k < mesh.nodes(); ++k) {
    const auto H = thickness.col(pad.first_column + k);
    double of_place = 0.0;
    for (int j = 0; j <= mesh.rows; ++j) {
      if (j == 0 || H[j] != H[j - 1]) of_place = foil.asperities->energy(H[j]);  // once for rows of equal H
      energy += mesh.column_weight(k) * mesh.row_weight(j) * of_place;
    }
  }
  return mesh.copies() * mesh.dtheta * mesh.dzeta * energy;
}

}  // namespace

BearingEnergy bearing_energy(const BearingModel& bearing, const BearingState& state) {
  const FilmModel& film = *bearing.film;
  const double unit = film.scales.force() * film.scales.thickness;
  BearingEnergy energy{.foils = 0.5 * state.contacts.x.dot(bearing.problem.K.multiply(state.contacts.x))};
  for (const FilmPad& pad : film.pads) {
    FoilFilmState part;
    read_part(pad, state.film, part);
    energy.gas += unit * free_energy(pad.foil.mesh, part);
    energy.foils += bending_energy(film, pad.foil, part.moment) + membrane_energy(film, pad.foil, part);
    energy.asperities += unit * asperity_energy(pad, state.film.thickness);
  }
  return energy;
}

FilmPowers film_powers(const FilmModel& film, const BearingState& state) {
  const FilmScales& scales = film.scales;
  const double unit = scales.gas.ambient_pressure * scales.flow();
  FilmPowers sum;
  for (const FilmPad& pad : film.pads) {
    FoilFilmState part;
    read_part(pad, state.film, part);
    const FilmPowers powers = film_powers(film_equation(film, pad, state.speed), part);
    sum.entrained += unit * powers.entrained;
    sum.dissipated += unit * powers.dissipated;
    sum.supplied += unit * powers.supplied;
  }
  return sum;
}

}  // namespace bumpfoil
