#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {
namespace {

/// Minimum surface speed in asperity friction, m/s: regularises slower rubbing as creep.
constexpr double creep_speed = 1e-3;

/// Force of the excess over a pressure of `outside`, at nodes where it is positive.
JournalVector pad_force(const FilmModel& film, const FilmPad& pad, const Matrix& pressure, double outside) {
  const FilmMesh& mesh = pad.foil.mesh;
  const Matrix excess = pressure(Eigen::all, pad.columns()).array() - outside;
  const auto sum = [&](const Vector& of_rows) -> Eigen::Vector2d {
    return film.column_normals(Eigen::all, pad.columns()) * mesh.weights.cwiseProduct(excess.transpose() * of_rows);
  };
  Vector of_rows(mesh.rows + 1);
  for (int j = 0; j <= mesh.rows; ++j) of_rows[j] = mesh.row_weight(j);
  JournalVector force(film.motions());
  force.head<2>() = sum(of_rows);
  if (film.tilts()) {
    for (int j = 0; j <= mesh.rows; ++j) of_rows[j] *= pad.zeta(j);  // lever arm
    force.tail<2>() = sum(of_rows);
  }
  return mesh.copies() * film.scales.force() * mesh.dtheta * mesh.dzeta * force;
}

}  // namespace

JournalVector film_force(const FilmModel& film, const Matrix& pressure) {
  JournalVector force = JournalVector::Zero(film.motions());
  for (const FilmPad& pad : film.pads) force += pad_force(film, pad, pressure, 1.0);
  return force;
}

Matrix asperity_pressures(const FilmModel& film, const Matrix& thickness) {
  Matrix pressures(thickness.rows(), film.columns());
  for (const FilmPad& pad : film.pads) {
    pressures(Eigen::all, pad.columns()) = asperity_pressures(pad.foil, part_of(pad, thickness));
  }
  return pressures;
}

namespace {

/// Integral of p_c over a pad, N.
double pressed(const FilmModel& film, const FilmPad& pad, const Matrix& pressures) {
  const FilmMesh& mesh = pad.foil.mesh;
  double sum = 0.0;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      sum += mesh.column_weight(k) * mesh.row_weight(j) * pressures(j, pad.first_column + k);
    }
  }
  return mesh.copies() * film.scales.force() * mesh.dtheta * mesh.dzeta * sum;
}

JournalVector pad_asperity_force(const FilmModel& film, const FilmPad& pad, const Matrix& pressures, double friction) {
  JournalVector force = pad_force(film, pad, pressures, 0.0);
  for (Eigen::Index i = 0; i < force.size(); i += 2) {
    force.segment<2>(i) += friction * Eigen::Vector2d(-force[i + 1], force[i]);
  }
  return force;
}

}  // namespace

JournalVector asperity_force(const FilmModel& film, const Matrix& pressures, double friction) {
  JournalVector force = JournalVector::Zero(film.motions());
  for (const FilmPad& pad : film.pads) force += pad_asperity_force(film, pad, pressures, friction);
  return force;
}

double sliding_friction(const FilmModel& film, double speed) {
  const std::optional<Asperities>& rough = film.surroundings.asperities;
  return rough ? rough->friction * std::tanh(speed * film.scales.radius / creep_speed) : 0.0;
}

JournalVector journal_force(const FilmModel& film, const FoilFilmState& state, double speed) {
  JournalVector force = film_force(film, state.pressure);
  if (film.surroundings.asperities) {
    force += asperity_force(film, asperity_pressures(film, state.thickness), sliding_friction(film, speed));
  }
  return force;
}

namespace {

/// Integral of (P - 1) dU/dtheta over the whole width; U is the outward deviation of the wall from a circle.
double pressing_slope(const FilmMesh& mesh, const Matrix& pressure, const Matrix& wall) {
  double sum = 0.0;
  for (int k = 0; k < mesh.columns; ++k) {
    const int next = mesh.next(k);
    for (int j = 0; j <= mesh.rows; ++j) {
      const double excess = 0.5 * (pressure(j, k) + pressure(j, next)) - 1.0;
      sum += mesh.copies() * mesh.row_weight(j) * mesh.dzeta * excess * (wall(j, next) - wall(j, k));
    }
  }
  return sum;
}

/// Angle wrapped to (-pi, pi].
double wrapped(double angle) {
  return angle - 2.0 * std::numbers::pi * std::ceil(angle / (2.0 * std::numbers::pi) - 0.5);
}

/// Forces of film and asperities on the bearing, and asperity friction.
/// @return the film force
JournalVector find_forces(const FilmModel& film, const BearingState& state, FilmBearingOutcome& outcome) {
  const Matrix pressures = asperity_pressures(film, state.film.thickness);
  const double friction = sliding_friction(film, state.speed);
  const JournalVector of_asperities = asperity_force(film, pressures, friction);
  JournalVector of_film = film_force(film, state.film.pressure);
  outcome.asperity_force = of_asperities.head<2>();
  outcome.force = of_film.head<2>() + outcome.asperity_force;
  if (film.tilts()) outcome.moment = film.half_width() * (of_film + of_asperities).tail<2>();
  outcome.max_asperity_pressure = pressures.maxCoeff();
  const bool several = film.pads.size() > 1;
  if (several) outcome.pad_forces.resize(2, std::ssize(film.pads));
  for (std::size_t k = 0; k < film.pads.size(); ++k) {
    const FilmPad& pad = film.pads[k];
    if (several) {
      outcome.pad_forces.col(static_cast<Eigen::Index>(k)) =
          (pad_force(film, pad, state.film.pressure, 1.0) + pad_asperity_force(film, pad, pressures, friction))
              .head<2>();
    }
    outcome.asperity_torque += friction * film.scales.radius * pressed(film, pad, pressures);
  }
  return of_film;
}

/// Sum over all pads of drag, flow and dissipation. @param of_film  force of the film on the journal
void find_drag(const BearingModel& bearing, const BearingState& state, const JournalVector& of_film,
               FilmBearingOutcome& outcome) {
  const FilmModel& film = *bearing.film;
  const FilmScales& scales = film.scales;
  // Includes the increase of the sleeve radius.
  Matrix wall = state.film.thickness - undeformed_thickness(bearing, film.journal_of(state), state.clearance_offset);
  wall.rowwise() += film.sleeve.transpose() / scales.thickness;
  const double couette = scales.couette_torque(state.speed * scales.radius);
  double poiseuille_torque = 0.0;
  double pressure_dissipation = 0.0;
  double slope = 0.0;
  FoilFilmState part;
  Matrix residual;
  for (const FilmPad& pad : film.pads) {
    read_part(pad, state.film, part);
    const ReynoldsEquation equation = film_equation(film, pad, state.speed);
    const FilmIntegrals sums = film_integrals(equation, part);
    outcome.couette_torque += couette * sums.couette;
    poiseuille_torque += pad.wrap_sign * scales.poiseuille_torque() * sums.poiseuille;
    pressure_dissipation += scales.gas.ambient_pressure * scales.flow() * sums.dissipation;
    slope += pad.wrap_sign * scales.force() * scales.thickness *
             pressing_slope(pad.foil.mesh, part.pressure, part_of(pad, wall));
    reynolds_residual(equation, part, residual);
    const FilmFlows flows = film_flows(pad.foil.mesh, residual);
    outcome.flows.start += scales.flow() * flows.start;
    outcome.flows.end += scales.flow() * flows.end;
    outcome.flows.sides += scales.flow() * flows.sides;
    const double left_side = flows.sides - flows.right_side;
    if (pad.at_side[1]) outcome.flows.right_side += scales.flow() * flows.right_side;
    outcome.slit_flow +=
        scales.flow() * ((pad.at_side[0] ? 0.0 : left_side) + (pad.at_side[1] ? 0.0 : flows.right_side));
  }
  outcome.torque = outcome.couette_torque + outcome.asperity_torque + poiseuille_torque;
  outcome.power = outcome.torque * state.speed;
  outcome.couette_dissipation = outcome.couette_torque * state.speed;
  outcome.dissipation = outcome.couette_dissipation + pressure_dissipation + outcome.asperity_torque * state.speed;
  // Asperity contact acts normal to the journal surface with friction along it: it does not contribute to the rest.
  const JournalVector journal = film.journal_of(state);
  double lever = 0.0;
  for (Eigen::Index i = 0; i < journal.size(); i += 2) {
    lever += journal[i] * of_film[i + 1] - journal[i + 1] * of_film[i];
  }
  outcome.torque_of_moments = outcome.couette_torque + outcome.asperity_torque - 0.5 * (lever + slope);
}

void find_thinnest(const FilmModel& film, const Matrix& H, FilmBearingOutcome& outcome) {
  outcome.thinnest.thickness = outcome.thinnest_crest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < film.pads.size(); ++k) {
    const FilmPad& pad = film.pads[k];
    const ThinnestPlace place = thinnest_place(pad.foil.mesh, part_of(pad, H));
    if (place.thickness < outcome.thinnest.thickness) {
      outcome.thinnest = place;
      outcome.thinnest_pad = static_cast<int>(k);
    }
    for (const int crest : pad.foil.supports) {
      outcome.thinnest_crest = std::min(outcome.thinnest_crest, H.col(pad.first_column + crest).minCoeff());
    }
  }
}

void find_loaded_bumps(const BearingModel& bearing, const BearingState& state, FilmBearingOutcome& outcome) {
  const Vector loads = bump_loads(bearing, state);
  for (int b = 0; b < loads.size(); ++b) {
    if (loads[b] <= 0.0) continue;
    ++outcome.loaded_bumps;
    if (outcome.first_loaded < 0) outcome.first_loaded = b;
    outcome.last_loaded = b;
  }
}

}  // namespace

FilmBearingOutcome film_bearing_outcome(const BearingModel& bearing, const BearingState& state) {
  FilmBearingOutcome outcome;
  const JournalVector of_film = find_forces(*bearing.film, state, outcome);
  outcome.eccentricity = state.position.norm() / std::abs(bearing.clearance);
  const double turned =
      std::atan2(state.position.y(), state.position.x()) - std::atan2(outcome.force.y(), outcome.force.x());
  outcome.attitude_angle = wrapped(state.speed < 0.0 ? -turned : turned);
  find_drag(bearing, state, of_film, outcome);
  find_thinnest(*bearing.film, state.film.thickness, outcome);
  outcome.max_pressure = state.film.pressure.maxCoeff();
  outcome.min_pressure = state.film.pressure.minCoeff();
  find_loaded_bumps(bearing, state, outcome);
  return outcome;
}

}  // namespace bumpfoil
