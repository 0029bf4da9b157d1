#include "bumpfoil/analysis/film_bearing.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "bumpfoil/analysis/foils.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/top_foil.hpp"

namespace bumpfoil {
namespace {

/// c of a bearing without clearance, m.
constexpr double smallest_scale = 10e-6;

/// Takes the bump foil out of K of all foils: the top foil has nodes at all columns instead.
BlockTridiagonal bump_foil_alone(const FoilStructure& structure, int rows) {
  const BumpDofs& dofs = structure.dofs;
  const int bumps = structure.K.blocks();
  BlockTridiagonal K(bumps + 1, dofs.size + rows);
  const auto is_bump = [&](int i) { return i != dofs.top_u && i != dofs.top_moment; };
  double largest = 0.0;
  for (int b = 0; b < bumps; ++b) {
    const auto block = static_cast<std::size_t>(b);
    for (int i = 0; i < dofs.size; ++i) {
      for (int j = 0; j < dofs.size; ++j) {
        if (!is_bump(i) || !is_bump(j)) continue;
        K.diagonal[block](i, j) = structure.K.diagonal[block](i, j);
        if (b + 1 < bumps) K.upper[block](i, j) = structure.K.upper[block](i, j);
        largest = std::max(largest, K.diagonal[block](i, j));
      }
    }
  }
  // What means nothing at the free end is held, the displacement there is not.
  Matrix& last = K.diagonal.back();
  last.diagonal().setConstant(largest);
  last(dofs.size, dofs.size) = 0.0;
  return K;
}

FoilFilm make_foil(const Case& input, const FilmScales& scales, const FilmResolution& resolution) {
  const int bumps = input.bump_foil.bumps;
  const double pitch = nominal_bump(input.bump_foil).pitch;  // of all, in a valid case
  const int m = resolution.columns_per_pitch;
  BUMPFOIL_ASSERT(m >= 4 && m % 2 == 0);
  std::vector<int> crests;
  crests.reserve(static_cast<std::size_t>(bumps));
  for (int i = 0; i < bumps; ++i) crests.push_back(m / 2 + i * m);
  const double R = input.bearing.radius;
  const FilmMesh mesh =
      make_slotted_mesh(bumps * m, resolution.rows, 0.5 * input.bearing.axial_length / R, bumps * pitch / R);
  return make_foil_film(mesh, scales, make_top_foil_section(make_bearing_design(input)).bending_stiffness, pitch,
                        std::move(crests));
}

}  // namespace

Gas gas_of(const GasSettings& settings) {
  return {.viscosity = settings.viscosity.value_or(viscosity(settings.preset, settings.temperature)),
          .ambient_pressure = settings.ambient_pressure,
          .mean_free_path = settings.mean_free_path};
}

double film_thickness_scale(double clearance) {
  return clearance != 0.0 ? std::abs(clearance) : smallest_scale;
}

Matrix FilmBearing::undeformed_thickness(const Eigen::Vector2d& position) const {
  Matrix H = foil.mesh.field(clearance / scales.thickness);
  H.rowwise() += (sleeve.transpose() - position.transpose() * normals) / scales.thickness;
  return H;
}

void require_film_geometry(const Case& input) {
  if (!input.pads.empty()) {
    throw Error(
        ErrorKind::input,
        {{"", 0, "pad", "", "are parts of the sleeve: the gas film knows one foil all around only", "remove them"}});
  }
  if (input.bearing.journal == RadiusProfile{}) return;
  throw Error(ErrorKind::input,
              {{"", 0, "bearing", "", "has a journal that is not round, under which no film is steady once it turns",
                "remove journal_waviness and journal_profile"}});
}

FilmBearing make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution) {
  require_film_geometry(input);
  const SharedFoils shared = make_bearing_foils(input);
  const Foils& foils = *shared;
  FilmBearing bearing;
  const double clearance = foils.clearance;
  bearing.scales = {gas, input.bearing.radius, film_thickness_scale(clearance)};
  bearing.foil = make_foil(input, bearing.scales, resolution);
  bearing.dofs = foils.structure.dofs;
  bearing.problem.K = bump_foil_alone(foils.structure, resolution.rows);
  bearing.problem.force_scale = foils.problem.force_scale;
  bearing.problem.pairs.assign(foils.problem.pairs.begin() + foils.top_bump(), foils.problem.pairs.end());

  // Gaps of the last block stay open.
  bearing.initial_gap.setConstant(bearing.problem.contacts(), bearing.scales.thickness);
  const Eigen::Index pairs = std::ssize(bearing.problem.pairs);
  for (Eigen::Index b = 0; b < foils.bumps(); ++b) {
    bearing.initial_gap.segment(b * pairs, pairs) =
        foils.assembled_gap.segment(b * foils.contacts_per_block() + foils.top_bump(), pairs);
  }
  bearing.clearance = clearance;
  bearing.weld_angle = input.bearing.weld_angle;
  bearing.wrap_sign = input.bearing.wrap == Wrap::clockwise ? -1.0 : 1.0;
  const Vector angles = bearing.foil.mesh.angles();
  bearing.normals = outward_normals(polar_angles(input.bearing, angles));
  bearing.sleeve = sleeve_deviations(input, angles);
  return bearing;
}

FilmBearing make_film_bearing(const Case& input) {
  return make_film_bearing(input, gas_of(input.gas),
                           {.columns_per_pitch = input.film.columns_per_pitch, .rows = input.film.rows});
}

FilmBearingState resting(const FilmBearing& bearing, const Eigen::Vector2d& position, double speed) {
  FilmBearingState state{.position = position,
                         .speed = speed,
                         .foil = undeformed(bearing.foil, bearing.undeformed_thickness(position)),
                         .contact = ContactState::unstressed(bearing.problem)};
  state.contact.gap = bearing.initial_gap;
  return state;
}

ReynoldsEquation film_equation(const FilmBearing& bearing, double speed) {
  return {.mesh = bearing.foil.mesh,
          .bearing_number = bearing.scales.bearing_number(bearing.surface_speed(speed)),
          .knudsen = bearing.scales.knudsen()};
}

Eigen::Vector2d film_force(const FilmBearing& bearing, const Matrix& pressure) {
  const FilmMesh& mesh = bearing.foil.mesh;
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  for (int k = 0; k < mesh.nodes(); ++k) {
    double excess = 0.0;
    for (int j = 0; j <= mesh.rows; ++j) excess += mesh.row_weight(j) * (pressure(j, k) - 1.0);
    force += mesh.column_weight(k) * excess * bearing.normals.col(k);
  }
  return 2.0 * bearing.scales.force() * mesh.dtheta * mesh.dzeta * force;
}

namespace {

/// Integral of (P - 1) dU/dtheta over the whole width, U how far the wall stands back from a circle.
double pressing_slope(const FilmMesh& mesh, const Matrix& pressure, const Matrix& wall) {
  double sum = 0.0;
  for (int k = 0; k < mesh.columns; ++k) {
    const int next = mesh.next(k);
    for (int j = 0; j < mesh.rows; ++j) {
      const double excess = 0.5 * (pressure(j, k) + pressure(j, next)) - 1.0;
      sum += 2.0 * mesh.row_weight(j) * mesh.dzeta * excess * (wall(j, next) - wall(j, k));
    }
  }
  return sum;
}

/// In (-pi, pi].
double wrapped(double angle) {
  return angle - 2.0 * std::numbers::pi * std::ceil(angle / (2.0 * std::numbers::pi) - 0.5);
}

void find_drag(const FilmBearing& bearing, const FilmBearingState& state, const FilmIntegrals& sums,
               FilmBearingOutcome& outcome) {
  const FilmScales& scales = bearing.scales;
  const double couette = scales.couette_torque(state.speed * scales.radius);
  outcome.couette_torque = couette * sums.couette;
  outcome.torque = outcome.couette_torque + bearing.wrap_sign * scales.poiseuille_torque() * sums.poiseuille;
  outcome.power = outcome.torque * state.speed;
  outcome.couette_dissipation = outcome.couette_torque * state.speed;
  outcome.dissipation = outcome.couette_dissipation + scales.gas.ambient_pressure * scales.flow() * sums.dissipation;
  const double lever = state.position.x() * outcome.force.y() - state.position.y() * outcome.force.x();
  // What the sleeve is wider, too.
  Matrix wall = state.foil.film.thickness - bearing.undeformed_thickness(state.position);
  wall.rowwise() += bearing.sleeve.transpose() / scales.thickness;
  const double slope =
      scales.force() * scales.thickness * pressing_slope(bearing.foil.mesh, state.foil.film.pressure, wall);
  outcome.torque_of_moments = outcome.couette_torque - 0.5 * (lever + bearing.wrap_sign * slope);
}

void find_loaded_bumps(const FilmBearing& bearing, const FilmBearingState& state, FilmBearingOutcome& outcome) {
  const auto pairs = static_cast<Eigen::Index>(bearing.problem.pairs.size());
  for (int b = 0; b < std::ssize(bearing.foil.supports); ++b) {
    if (state.contact.normal_force[b * pairs] <= 0.0) continue;
    ++outcome.loaded_bumps;
    if (outcome.first_loaded < 0) outcome.first_loaded = b;
    outcome.last_loaded = b;
  }
}

}  // namespace

FilmBearingOutcome film_bearing_outcome(const FilmBearing& bearing, const FilmBearingState& state) {
  const FilmMesh& mesh = bearing.foil.mesh;
  const FilmScales& scales = bearing.scales;
  const ReynoldsEquation equation = film_equation(bearing, state.speed);
  FilmBearingOutcome outcome;
  outcome.force = film_force(bearing, state.foil.film.pressure);
  outcome.eccentricity = state.position.norm() / std::abs(bearing.clearance);
  const double turned =
      std::atan2(state.position.y(), state.position.x()) - std::atan2(outcome.force.y(), outcome.force.x());
  outcome.attitude_angle = wrapped(state.speed < 0.0 ? -turned : turned);
  find_drag(bearing, state, film_integrals(equation, state.foil.film), outcome);
  Matrix residual;
  reynolds_residual(equation, state.foil.film, residual);
  outcome.flows = film_flows(mesh, residual);
  for (double* flow : {&outcome.flows.start, &outcome.flows.end, &outcome.flows.sides}) *flow *= scales.flow();
  const Matrix& H = state.foil.film.thickness;
  outcome.thinnest = thinnest_place(mesh, H);
  outcome.thinnest_crest = std::numeric_limits<double>::infinity();
  for (const int crest : bearing.foil.supports) {
    outcome.thinnest_crest = std::min(outcome.thinnest_crest, H.col(crest).minCoeff());
  }
  outcome.max_pressure = state.foil.film.pressure.maxCoeff();
  outcome.min_pressure = state.foil.film.pressure.minCoeff();
  find_loaded_bumps(bearing, state, outcome);
  return outcome;
}

}  // namespace bumpfoil
