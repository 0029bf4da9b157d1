#include "bumpfoil/structure/identification.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "structure/planar_frame.hpp"

namespace bumpfoil {
namespace {

/// Stiffness of half a bump between crest and mid-flat against rotation, with both displacements held.
struct HalfBump {
  double at_crest{};       ///< moment at the crest per rotation there, N m
  double at_flat{};        ///< moment at mid-flat per rotation there, N m
  double crest_to_flat{};  ///< moment at one end per rotation of the other, N m
  double pull_on_crest{};  ///< moment at the crest per its displacement u, N
  double pull_on_flat{};   ///< moment at mid-flat per displacement u of the crest, N
};

/// Equal from crest to mid-flat and back: reflection changes the sign of u and of rotations.
HalfBump make_half_bump(const BumpArc& arc, const Section& section) {
  PlanarFrame half(3);
  half.add(0, 1, section, falling_half(arc));
  half.add(1, 2, section, flat_element(0.5 * arc.flat));
  const Matrix K = half.condense({0, 2, 8}, {1, 6, 7});
  return {.at_crest = K(1, 1),
          .at_flat = K(2, 2),
          .crest_to_flat = K(1, 2),
          .pull_on_crest = K(0, 1),
          .pull_on_flat = K(0, 2)};
}

/// Coupling of u between neighbouring crests of a row of equal bumps. The effect of the ends decays by a factor of
/// seven per bump: to 1e-7 with five on either side.
double crest_to_crest(const HalfBump& own) {
  constexpr Eigen::Index row = 5;
  // Rotations in sequence: first mid-flat, first crest, next mid-flat, ...; their u and v are held.
  constexpr Eigen::Index last = 4 * row;
  Vector diagonal = Vector::Zero(last + 1);
  const Vector off = Vector::Constant(last, own.crest_to_flat);
  for (Eigen::Index half = 0; half < last; ++half) {
    const bool rises = half % 2 == 0;
    diagonal[half] += rises ? own.at_flat : own.at_crest;
    diagonal[half + 1] += rises ? own.at_crest : own.at_flat;
  }
  // Moments to be balanced by the rotations if one crest moves along the foil, around the mid-flat at 2 * row.
  const auto pulled = [&own](Eigen::Index crest) {
    Vector moments = Vector::Zero(last + 1);
    moments.segment<3>(crest - 1) << own.pull_on_flat, 2.0 * own.pull_on_crest, own.pull_on_flat;
    return moments;
  };
  return pulled(2 * row - 1).dot(solve_tridiagonal(diagonal, off, pulled(2 * row + 1)));
}

/// Stiffness of the first crest of the frame: clamped at mid-flat, arc ends on the sleeve, slope zero at the next
/// mid-flat.
double first_crest_stiffness(const BumpArc& arc, const Section& section) {
  PlanarFrame bump(5);
  bump.add(0, 1, section, flat_element(0.5 * arc.flat));
  bump.add(1, 2, section, rising_half(arc));
  bump.add(2, 3, section, falling_half(arc));
  bump.add(3, 4, section, flat_element(0.5 * arc.flat));
  return bump.condense({7}, {0, 1, 2, 4, 10, 14})(0, 0);
}

/// k4 that gives the truss of one bump with a sliding foot the stiffness `target` at its crest.
double weld_stiffness(const TrussConstants& constants, double target) {
  const double c = std::cos(constants.theta_d);
  const double s = std::sin(constants.theta_d);
  // Order u_c, u_f, v_c; excludes k4.
  const Eigen::RowVector3d front(c, 0.0, -s);
  const Eigen::RowVector3d back(-c, c, -s);
  Eigen::Matrix3d K = constants.k1 * (front.transpose() * front + back.transpose() * back);
  K(1, 1) += constants.k2;
  // A spring k4 on u_c reduces the compliance S_vv by k4 S_uv^2 / (1 + k4 S_uu).
  const Eigen::Matrix3d S = K.inverse();
  const double excess = S(2, 2) - 1.0 / target;
  return excess / (S(0, 2) * S(0, 2) - excess * S(0, 0));
}

/// Constants of each bump in a uniform row of its shape. Neighbours of equal shape share the result.
std::vector<TrussConstants> constants_of_shapes(const FoilDesign& foils) {
  std::vector<TrussConstants> shapes;
  shapes.reserve(foils.bumps.size());
  const BumpShape* before = nullptr;
  for (const BumpShape& bump : foils.bumps) {
    const bool same = before && bump == *before;
    shapes.push_back(same ? shapes.back()
                          : identify_truss_constants(make_bump_arc(bump), make_bump_section(foils, bump)));
    before = &bump;
  }
  return shapes;
}

/// Constants of each bump among its neighbours; a missing neighbour counts as one of the same shape.
std::vector<TrussConstants> identified_constants(const FoilDesign& foils) {
  const std::vector<TrussConstants> shapes = constants_of_shapes(foils);
  std::vector<TrussConstants> constants = shapes;
  for (std::size_t n = 0; n < shapes.size(); ++n) {
    const double own = shapes[n].k3;
    const double before = n > 0 ? 0.5 * (shapes[n - 1].k3 + own) : own;
    const double after = n + 1 < shapes.size() ? 0.5 * (own + shapes[n + 1].k3) : own;
    constants[n].k3 = before;
    constants[n].k2 -= 0.5 * (before + after) - own;  // keeps the sum over the cell
  }
  return constants;
}

std::vector<TrussConstants> given_or_identified(const FoilDesign& foils) {
  const TrussOverrides& given = foils.truss;
  if (given.k1 && given.k2 && given.k3 && given.k4 && given.theta_d) {
    return std::vector<TrussConstants>(foils.bumps.size(),
                                       {*given.k1, *given.k2, *given.k3, *given.k4, *given.theta_d});
  }
  std::vector<TrussConstants> constants = identified_constants(foils);
  for (TrussConstants& own : constants) {
    own = {.k1 = given.k1.value_or(own.k1),
           .k2 = given.k2.value_or(own.k2),
           .k3 = given.k3.value_or(own.k3),
           .k4 = given.k4.value_or(own.k4),
           .theta_d = given.theta_d.value_or(own.theta_d)};
  }
  return constants;
}

std::vector<InputError> errors_of(const FoilDesign& foils, const std::vector<TrussConstants>& constants) {
  std::vector<InputError> errors;
  const auto check = [&](const char* name, double TrussConstants::*value, std::size_t bumps) {
    const auto end = constants.begin() + static_cast<std::ptrdiff_t>(bumps);
    const auto worst =
        std::find_if(constants.begin(), end, [&](const TrussConstants& own) { return own.*value < 0.0; });
    if (worst == end) return;
    const bool uniform = std::equal(foils.bumps.begin() + 1, foils.bumps.end(), foils.bumps.begin());
    InputError error;
    error.key = fmt::format("bump_foil.truss.{}", name);
    error.what = fmt::format("is identified as {:.4g} N/m for {}: the truss would be unstable", (*worst).*value,
                             uniform ? std::string("this shape of bump")
                                     : fmt::format("bump {} among its neighbours", worst - constants.begin() + 1));
    error.advice = "give a positive value, or set bump_foil.model = \"frame\"";
    // The sum determines the stiffness of a bump: an increase of k2 alone would stiffen it.
    const double sum = (*worst).k2 + (*worst).k3;
    if (value == &TrussConstants::k2 && !foils.truss.k3 && sum > 0.0) {
      error.advice =
          fmt::format("set bump_foil.model = \"frame\", or give k2, k3 and k4, with k2 + k3 = {:.4g} N/m", sum);
    }
    errors.push_back(error);
  };
  check("k1", &TrussConstants::k1, constants.size());
  check("k2", &TrussConstants::k2, constants.size());
  check("k3", &TrussConstants::k3, constants.size());
  check("k4", &TrussConstants::k4, 1);  // other bumps have no weld before them
  return errors;
}

}  // namespace

BumpCell make_bump_cell(const BumpArc& arc, const Section& section) {
  // Half bump from crest (0) via the end of the arc (1) to mid-flat (2), where u is half the growth of the pitch.
  PlanarFrame half(3);
  half.add(0, 1, section, falling_half(arc));
  half.add(1, 2, section, flat_element(0.5 * arc.flat));
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
  constants.k3 = crest_to_crest(make_half_bump(arc, section));
  constants.k2 = cell.d - 0.5 * constants.k1 * c * c - constants.k3;
  constants.k4 = weld_stiffness(constants, first_crest_stiffness(arc, section));
  return constants;
}

std::vector<InputError> find_truss_errors(const FoilDesign& foils) {
  return errors_of(foils, given_or_identified(foils));
}

std::vector<TrussConstants> make_truss_constants(const FoilDesign& foils) {
  std::vector<TrussConstants> constants = given_or_identified(foils);
  if (std::vector<InputError> errors = errors_of(foils, constants); !errors.empty()) {
    throw Error(ErrorKind::input, std::move(errors));
  }
  return constants;
}

}  // namespace bumpfoil
