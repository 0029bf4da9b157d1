#include "bumpfoil/structure/identification.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "structure/planar_frame.hpp"

namespace bumpfoil {
namespace {

using Unknowns = PlanarFrame::Unknowns;

/// Nodes of a strip: the mid-flat before a bump, arc start, crest, arc end; after the last bump one more mid-flat.
constexpr int nodes_per_bump = 4;

PlanarFrame make_strip(int bumps, const BumpArc& arc, const Section& section) {
  PlanarFrame strip(nodes_per_bump * bumps + 1, section);
  for (int n = 0; n < bumps; ++n) {
    const int first = nodes_per_bump * n;
    strip.add(first, first + 1, flat_element(0.5 * arc.flat));
    strip.add(first + 1, first + 2, rising_half(arc));
    strip.add(first + 2, first + 3, falling_half(arc));
    strip.add(first + 3, first + 4, flat_element(0.5 * arc.flat));
  }
  return strip;
}

/// Coupling of u between two neighbouring crests. The ends of the strip are felt seven times less with each bump: 1e-7
/// in the middle of ten.
double crest_to_crest(const BumpArc& arc, const Section& section) {
  constexpr int bumps = 10;
  Unknowns kept;
  for (int node = 0; node <= nodes_per_bump * bumps; node += 2) {
    kept.push_back(3 * Eigen::Index{node});
    kept.push_back(3 * Eigen::Index{node} + 1);
  }
  const Matrix K = make_strip(bumps, arc, section).condense(kept, {});
  // Crest n is entry 4 n + 2 of what is kept: u and v of its mid-flat go before.
  constexpr int middle = 4 * (bumps / 2) + 2;
  return -K(middle - 4, middle);
}

/// Stiffness of the first crest of the frame: clamped at mid-flat, arc ends on the sleeve, slope zero at the next
/// mid-flat.
double first_crest_stiffness(const BumpArc& arc, const Section& section) {
  const Unknowns crest_v{7};
  const Unknowns fixed{0, 1, 2, 4, 10, 14};
  return make_strip(1, arc, section).condense(crest_v, fixed)(0, 0);
}

/// k4 such that the truss of one bump, its foot sliding, has the stiffness `target` at its crest.
double weld_stiffness(const TrussConstants& constants, double target) {
  const double c = std::cos(constants.theta_d);
  const double s = std::sin(constants.theta_d);
  // Order u_c, u_f, v_c; without k4.
  const Eigen::RowVector3d front(c, 0.0, -s);
  const Eigen::RowVector3d back(-c, c, -s);
  Eigen::Matrix3d K = constants.k1 * (front.transpose() * front + back.transpose() * back);
  K(1, 1) += constants.k2;
  // A spring k4 on u_c takes k4 S_uv^2 / (1 + k4 S_uu) off the compliance S_vv.
  const Eigen::Matrix3d S = K.inverse();
  const double excess = S(2, 2) - 1.0 / target;
  return excess / (S(0, 2) * S(0, 2) - excess * S(0, 0));
}

/// What the case gives, and the identified constants in its place where it gives none.
TrussConstants given_or_identified(const Case& input) {
  const BumpFoil& foil = input.bump_foil;
  const TrussOverrides& given = foil.truss;
  if (given.k1 && given.k2 && given.k3 && given.k4 && given.theta_d) {
    return {*given.k1, *given.k2, *given.k3, *given.k4, *given.theta_d};
  }
  const Section section =
      make_section(foil.youngs_modulus, foil.poisson_ratio, input.bearing.axial_length, foil.thickness);
  const TrussConstants identified = identify_truss_constants(make_bump_arc(foil), section);
  return {.k1 = given.k1.value_or(identified.k1),
          .k2 = given.k2.value_or(identified.k2),
          .k3 = given.k3.value_or(identified.k3),
          .k4 = given.k4.value_or(identified.k4),
          .theta_d = given.theta_d.value_or(identified.theta_d)};
}

}  // namespace

BumpCell make_bump_cell(const BumpArc& arc, const Section& section) {
  // Half of it from crest (0) over the arc's end (1) to mid-flat (2), where u is half the growth of the pitch.
  PlanarFrame half(3, section);
  half.add(0, 1, falling_half(arc));
  half.add(1, 2, flat_element(0.5 * arc.flat));
  const Matrix K = half.condense({1, 6}, {0, 2, 4, 8});
  return {.a = 2.0 * K(0, 0), .b = -K(0, 1), .d = 0.5 * K(1, 1)};
}

TrussConstants identify_truss_constants(const BumpArc& arc, const Section& section) {
  const BumpCell cell = make_bump_cell(arc, section);
  TrussConstants constants;
  constants.theta_d = std::atan2(cell.a, 2.0 * cell.b);
  const double c = std::cos(constants.theta_d);
  const double s = std::sin(constants.theta_d);
  constants.k1 = cell.a / (2.0 * s * s);
  constants.k3 = crest_to_crest(arc, section);
  constants.k2 = cell.d - 0.5 * constants.k1 * c * c - constants.k3;
  constants.k4 = weld_stiffness(constants, first_crest_stiffness(arc, section));
  return constants;
}

std::vector<Fault> find_truss_faults(const Case& input) {
  const TrussConstants constants = given_or_identified(input);
  std::vector<Fault> faults;
  for (const auto& [name, value] : {std::pair{"k1", constants.k1}, std::pair{"k2", constants.k2},
                                    std::pair{"k3", constants.k3}, std::pair{"k4", constants.k4}}) {
    if (value >= 0.0) continue;
    Fault fault;
    fault.key = fmt::format("bump_foil.truss.{}", name);
    fault.what = fmt::format("comes out as {:.4g} N/m for this shape of bump: the truss would be unstable", value);
    fault.advice = "give a positive value, or set bump_foil.model = \"frame\"";
    faults.push_back(fault);
  }
  return faults;
}

TrussConstants make_truss_constants(const Case& input) {
  if (std::vector<Fault> faults = find_truss_faults(input); !faults.empty()) throw Error(ErrorKind::input, faults);
  return given_or_identified(input);
}

}  // namespace bumpfoil
