#include "bumpfoil/analysis/film_bearing.hpp"

#include <cmath>

#include "bumpfoil/analysis/foils.hpp"
#include "bumpfoil/core/assert.hpp"
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
  const BumpFoil& bumps = input.bump_foil;
  const int m = resolution.columns_per_pitch;
  BUMPFOIL_ASSERT(m >= 4 && m % 2 == 0);
  std::vector<int> crests;
  crests.reserve(static_cast<std::size_t>(bumps.bumps));
  for (int i = 0; i < bumps.bumps; ++i) crests.push_back(m / 2 + i * m);
  const double R = input.bearing.radius;
  const FilmMesh mesh = make_slotted_mesh(bumps.bumps * m, resolution.rows, 0.5 * input.bearing.axial_length / R,
                                          bumps.bumps * bumps.pitch / R);
  return make_foil_film(mesh, scales, make_top_foil_section(make_bearing_design(input)).bending_stiffness, bumps.pitch,
                        std::move(crests));
}

}  // namespace

Matrix FilmBearing::undeformed_thickness(const Eigen::Vector2d& position) const {
  Matrix H = foil.mesh.field(clearance / scales.thickness);
  H.rowwise() -= (position / scales.thickness).transpose() * normals;
  return H;
}

FilmBearing make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution) {
  const SharedFoils shared = make_bearing_foils(input);
  const Foils& foils = *shared;
  FilmBearing bearing;
  const double clearance = foils.clearance;
  bearing.scales = {gas, input.bearing.radius, clearance != 0.0 ? std::abs(clearance) : smallest_scale};
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
  bearing.normals = outward_normals(polar_angles(input.bearing, bearing.foil.mesh.angles()));
  return bearing;
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

Eigen::Vector2d plane_force(const FilmBearing& bearing, const FilmIntegrals& sums) {
  // The direction of theta = 0 and that of theta = 90 degrees.
  const Eigen::Vector2d n = unit_vector(bearing.weld_angle);
  const Eigen::Vector2d t = bearing.wrap_sign * Eigen::Vector2d(-n.y(), n.x());
  return bearing.scales.force() * (sums.cosine * n + sums.sine * t);
}

FilmBearingOutcome film_bearing_outcome(const FilmBearing& bearing, const FilmBearingState& state) {
  const FilmMesh& mesh = bearing.foil.mesh;
  const FilmScales& scales = bearing.scales;
  const ReynoldsEquation equation = film_equation(bearing, state.speed);
  const FilmIntegrals sums = film_integrals(equation, state.foil.film);
  FilmBearingOutcome outcome;
  outcome.force = plane_force(bearing, sums);
  const double surface = state.speed * scales.radius;
  outcome.torque =
      scales.couette_torque(surface) * sums.couette + bearing.wrap_sign * scales.poiseuille_torque() * sums.poiseuille;
  outcome.power = outcome.torque * state.speed;
  outcome.dissipation = scales.couette_torque(surface) * state.speed * sums.couette +
                        scales.gas.ambient_pressure * scales.flow() * sums.dissipation;
  Matrix residual;
  reynolds_residual(equation, state.foil.film, residual);
  outcome.flows = film_flows(mesh, residual);
  for (double* flow : {&outcome.flows.start, &outcome.flows.end, &outcome.flows.sides}) *flow *= scales.flow();
  outcome.thinnest = thinnest_place(mesh, state.foil.film.thickness);
  outcome.max_pressure = state.foil.film.pressure.maxCoeff();
  outcome.min_pressure = state.foil.film.pressure.minCoeff();
  const auto pairs = static_cast<Eigen::Index>(bearing.problem.pairs.size());
  const auto bumps = static_cast<Eigen::Index>(bearing.foil.supports.size());
  outcome.loaded_bumps =
      static_cast<int>((state.contact.normal_force(Eigen::seqN(0, bumps, pairs)).array() > 0.0).count());
  return outcome;
}

}  // namespace bumpfoil
