#include "bumpfoil/structure/foil_structure.hpp"

#include "bumpfoil/structure/frame.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "bumpfoil/structure/truss.hpp"

namespace bumpfoil {
namespace {

/// Adds the top foil in its moment form, the unknown moments being M / moment_scale.
void assemble_top_foil(const TopFoilMoments& form, double moment_scale, const BumpDofs& dofs, BlockTridiagonal& K) {
  const int u = dofs.top_u;
  const int m = dofs.top_moment;
  const double compliance_scale = moment_scale * moment_scale;
  const int n = K.blocks();
  // Crest j = 1..n is block j - 1.
  for (int j = 1; j < n; ++j) {
    K.add(j - 1, u, j - 1, m, moment_scale * form.load_diagonal(j));
    K.add(j - 1, m, j, u, moment_scale * form.inverse_sine[j]);
    K.add(j - 1, m, j - 1, m, -compliance_scale * form.compliance_diagonal[j]);
    if (j + 1 < n) {
      K.add(j - 1, u, j, m, moment_scale * form.inverse_sine[j]);
      K.add(j - 1, m, j, m, -compliance_scale * form.compliance_off[j]);
    }
  }
  K.add(n - 1, m, n - 1, m, -compliance_scale * form.compliance_diagonal[n - 1]);

  // Weld: M_0 = (u_1 / (R sin d_0) - T_01 M_1) / T_00.
  const double weld = form.inverse_sine[0];
  const double pivot = form.compliance_diagonal[0];
  K.add(0, u, 0, u, weld * weld / pivot);
  if (n > 1) {
    const double off = form.compliance_off[0];
    K.add(0, u, 0, m, -moment_scale * weld * off / pivot);
    K.add(0, m, 0, m, compliance_scale * off * off / pivot);
  }
}

/// `x` with the moments that belong to its displacements: the rows of moments of K solved for them.
Vector with_compatible_moments(const FoilStructure& structure, Vector x) {
  const Eigen::Index m = structure.dofs.top_moment;
  if (m < 0) return x;
  const Eigen::Index size = structure.dofs.size;
  const auto moments = Eigen::seqN(m, Eigen::Index{structure.bumps()}, size);
  x(moments).setZero();
  const Vector kinks = structure.K.multiply(x)(moments);
  Vector diagonal(structure.bumps());
  Vector off(structure.bumps() - 1);
  for (Eigen::Index b = 0; b < diagonal.size(); ++b) {
    diagonal[b] = -structure.K.diagonal[static_cast<std::size_t>(b)](m, m);
    if (b < off.size()) off[b] = -structure.K.upper[static_cast<std::size_t>(b)](m, m);
  }
  x(moments) = solve_tridiagonal(diagonal, off, kinks);
  return x;
}

/// Forces of all that is linear on the displacements alone: with compatible moments, whose rows are zero then.
Vector linear_forces(const FoilStructure& structure, const Vector& x) {
  const BlockTridiagonal& K = structure.large_displacements ? structure.large_displacements->rest : structure.K;
  Vector forces = K.multiply(with_compatible_moments(structure, x));
  if (const Eigen::Index m = structure.dofs.top_moment; m >= 0) {
    forces(Eigen::seqN(m, Eigen::Index{structure.bumps()}, Eigen::Index{structure.dofs.size})).setZero();
  }
  return forces;
}

}  // namespace

BumpDofs make_bump_dofs(BumpFoilModel model) {
  if (model == BumpFoilModel::frame) return frame_dofs();
  BumpDofs dofs{.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};
  if (model == BumpFoilModel::truss) {
    dofs.size = 6;
    dofs.top_u = 4;
    dofs.top_moment = 5;
  }
  return dofs;
}

FoilStructure make_foil_structure(const Case& input) {
  const BumpFoil& foil = input.bump_foil;
  const bool is_frame = foil.model == BumpFoilModel::frame;
  FoilStructure structure;
  structure.dofs = make_bump_dofs(foil.model);
  structure.K = BlockTridiagonal(foil.bumps, structure.dofs.size);
  if (structure.dofs.top_u >= 0) {
    assemble_top_foil(make_top_foil_moments(make_top_foil_beam(input)), top_moment_scale(input), structure.dofs,
                      structure.K);
  }
  if (is_frame) {
    const FrameModel frame = make_frame_model(input);
    if (foil.geometry == Geometry::nonlinear) {
      structure.large_displacements = {.bump_foil = place_elements(frame, structure.dofs.size), .rest = structure.K};
      hold_covered_node(frame, structure.large_displacements->rest);
    }
    assemble_frame(frame, structure.K);
  } else {
    assemble_springs(make_truss_springs(make_truss_constants(input), structure.dofs, foil.bumps), structure.K);
  }
  return structure;
}

Vector internal_forces(const FoilStructure& structure, const Vector& x) {
  if (!structure.large_displacements) return structure.K.multiply(x);
  Vector forces = structure.large_displacements->rest.multiply(x);
  add_corotational_forces(structure.large_displacements->bump_foil, x, forces);
  return forces;
}

BlockTridiagonal tangent_stiffness(const FoilStructure& structure, const Vector& x) {
  if (!structure.large_displacements) return structure.K;
  BlockTridiagonal K = structure.large_displacements->rest;
  add_corotational_tangent(structure.large_displacements->bump_foil, x, K);
  return K;
}

BlockTridiagonal stable_tangent_stiffness(const FoilStructure& structure, const Vector& x) {
  if (!structure.large_displacements) return structure.K;
  BlockTridiagonal K = structure.large_displacements->rest;
  add_stable_tangent(structure.large_displacements->bump_foil, x, K);
  return K;
}

Vector elastic_forces(const FoilStructure& structure, const Vector& x) {
  Vector forces = linear_forces(structure, x);
  if (structure.large_displacements) add_corotational_forces(structure.large_displacements->bump_foil, x, forces);
  return forces;
}

double elastic_energy(const FoilStructure& structure, const Vector& x) {
  const double linear = 0.5 * x.dot(linear_forces(structure, x));
  if (!structure.large_displacements) return linear;
  return linear + corotational_energy(structure.large_displacements->bump_foil, x);
}

}  // namespace bumpfoil
