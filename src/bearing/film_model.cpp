#include "bumpfoil/bearing/film_model.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/bearing/bearing_state.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Lower bound of the thickness scale c, for small clearances or interference, m.
constexpr double least_scale = 10e-6;

}  // namespace

Gas gas_of(const GasSettings& settings) {
  return {.viscosity = settings.viscosity.value_or(viscosity(settings.preset, settings.temperature)),
          .ambient_pressure = settings.ambient_pressure,
          .mean_free_path = settings.mean_free_path};
}

Asperities asperities_of(const AsperitySettings& settings, const TopFoil& top_foil) {
  Asperities rough{.roughness = settings.sigma, .friction = settings.friction};
  const double own = top_foil.youngs_modulus / (2.0 * (1.0 - top_foil.poisson_ratio * top_foil.poisson_ratio));
  rough.pressure_factor = settings.pressure_factor
                              ? *settings.pressure_factor
                              : asperity_pressure_factor(settings.sigma, *settings.density, *settings.radius,
                                                         settings.modulus.value_or(own));
  return rough;
}

double film_thickness_scale(double clearance) {
  return std::max(std::abs(clearance), least_scale);
}

int FilmModel::columns() const {
  return pads.empty() ? 0 : pads.back().first_column + pads.back().foil.mesh.nodes();
}

Matrix FilmModel::field(double value) const {
  return Matrix::Constant(pads.front().foil.mesh.rows + 1, columns(), value);
}

Matrix FilmModel::over_the_width(const Matrix& deflection) const {
  return product(pads.front().foil.shapes, deflection);
}

Matrix FilmModel::resting_pressure() const {
  Matrix pressure = field(1.0);
  for (const FilmPad& pad : pads) {
    const FilmMesh& mesh = pad.foil.mesh;
    const auto inside = Eigen::seqN(pad.first_column + mesh.first_unknown(), mesh.unknown_columns());
    for (int j = 0; j <= mesh.rows; ++j) {
      const std::size_t side = mesh.zeta(j) < 0.0 ? 0 : 1;
      if (mesh.is_side(j) && pad.at_side[side]) {
        pressure(j, inside).setConstant(surroundings.side_pressure[static_cast<Eigen::Index>(side)]);
      }
    }
    if (mesh.closed) continue;
    pressure.col(pad.first_column + mesh.columns)
        .segment(mesh.first_unknown_row(), mesh.unknown_rows())
        .setConstant(surroundings.inlet_pressure);
  }
  return pressure;
}

JournalVector FilmModel::journal_of(const BearingState& state) const {
  JournalVector journal(motions());
  journal.head<2>() = state.position;
  if (tilts()) journal.tail<2>() = state.tilt;
  return journal;
}

void FilmModel::place_journal(const JournalVector& journal, BearingState& state) {
  state.position = journal.head<2>();
  if (journal.size() > 2) state.tilt = journal.tail<2>();
}

Matrix FilmModel::thickness_change(const JournalVector& displacement) const {
  Matrix H = (displacement.head<2>().transpose() * column_normals / -scales.thickness)
                 .replicate(pads.front().foil.mesh.rows + 1, 1);
  add_tilt(displacement, H);
  return H;
}

void FilmModel::add_tilt(const JournalVector& displacement, Matrix& H) const {
  if (displacement.size() == 2) return;
  const Eigen::RowVectorXd at_side = displacement.tail<2>().transpose() * column_normals / -scales.thickness;
  for (const FilmPad& pad : pads) {
    for (int j = 0; j <= pad.foil.mesh.rows; ++j) H(j, pad.columns()) += pad.zeta(j) * at_side(pad.columns());
  }
}

Matrix part_of(const FilmPad& pad, const Matrix& field) {
  return field(Eigen::all, pad.columns());
}

void read_part(const FilmPad& pad, const FoilFilmState& all, FoilFilmState& part) {
  part.pressure = all.pressure(Eigen::all, pad.columns());
  part.thickness = all.thickness(Eigen::all, pad.columns());
  part.deflection = all.deflection(Eigen::all, pad.columns());
  part.moment = all.moment(Eigen::all, pad.columns());
  part.membrane = all.membrane(Eigen::all, pad.columns());
}

void write_part(const FilmPad& pad, const FoilFilmState& part, FoilFilmState& all) {
  all.pressure(Eigen::all, pad.columns()) = part.pressure;
  all.thickness(Eigen::all, pad.columns()) = part.thickness;
  all.deflection(Eigen::all, pad.columns()) = part.deflection;
  all.moment(Eigen::all, pad.columns()) = part.moment;
  all.membrane(Eigen::all, pad.columns()) = part.membrane;
}

ReynoldsEquation film_equation(const FilmModel& film, const FilmPad& pad, double speed) {
  return {.mesh = pad.foil.mesh,
          .bearing_number = film.scales.bearing_number(film.surface_speed(pad, speed)),
          .knudsen = film.scales.knudsen()};
}

FilmEquations film_equations(const FilmModel& film, double speed) {
  FilmEquations equations;
  equations.reserve(film.pads.size());
  for (const FilmPad& pad : film.pads) equations.push_back(film_equation(film, pad, speed));
  return equations;
}

void squeeze(const FilmModel& film, double squeeze_rate, const Matrix& content, FilmEquations& equations) {
  for (std::size_t k = 0; k < equations.size(); ++k) {
    equations[k].squeeze_rate = squeeze_rate;
    equations[k].previous_content = part_of(film.pads[k], content);
  }
}

}  // namespace bumpfoil
