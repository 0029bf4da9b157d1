#include "bumpfoil/structure/foil_structure.hpp"

#include <algorithm>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/structure/frame.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "bumpfoil/structure/truss.hpp"

namespace bumpfoil {
namespace {

/// Adds the top foil in its moment form, the unknown moments being M / moment_scale.
/// @param first  block of the first crest
void assemble_top_foil(const TopFoilMoments& form, double moment_scale, const BumpDofs& dofs, int first,
                       BlockTridiagonal& K) {
  const int u = dofs.top_u;
  const int m = dofs.top_moment;
  const double compliance_scale = moment_scale * moment_scale;
  const int n = K.blocks() - first;
  const auto block = [first](int crest) { return first + crest - 1; };
  // The moment at a free end is zero: its unknown remains, uncoupled.
  for (int j = 1; j <= n; ++j) {
    K.add(block(j), m, block(j), m, -compliance_scale * form.compliance_diagonal[std::min(j, n - 1)]);
  }
  const int first_moment = form.welded ? 1 : 2;
  for (int j = first_moment; j < n; ++j) {
    if (j > 1) K.add(block(j - 1), u, block(j), m, moment_scale * form.inverse_sine[j - 1]);
    K.add(block(j), u, block(j), m, moment_scale * form.load_diagonal(j));
    K.add(block(j), m, block(j + 1), u, moment_scale * form.inverse_sine[j]);
    if (j + 1 < n) K.add(block(j), m, block(j + 1), m, -compliance_scale * form.compliance_off[j]);
  }
  if (!form.welded) {
    for (int j = 1; j <= n; ++j) K.add(block(j), u, block(j), u, loose_hold);
    return;
  }

  // Weld: M_0 = (u_1 / (R sin d_0) - T_01 M_1) / T_00.
  const double weld = form.inverse_sine[0];
  const double pivot = form.compliance_diagonal[0];
  K.add(first, u, first, u, weld * weld / pivot);
  if (n > 1) {
    const double off = form.compliance_off[0];
    K.add(first, u, first, m, -moment_scale * weld * off / pivot);
    K.add(first, m, first, m, compliance_scale * off * off / pivot);
  }
}

/// Adds the forming of the top foil to the right-hand side of K x.
/// @param rotations  forming_rotations()
void add_forming(const TopFoilMoments& form, double moment_scale, const Vector& rotations, FoilStructure& structure) {
  const Eigen::Index size = structure.dofs.size;
  const Eigen::Index first = structure.first_bump * size;
  for (Eigen::Index j = 1; j < rotations.size(); ++j) {
    structure.forming[first + (j - 1) * size + structure.dofs.top_moment] += moment_scale * rotations[j];
  }
  // Weld: M_0 = (u_1 / (R sin d_0) - T_01 M_1 - r_0) / T_00.
  const double moment = rotations[0] / form.compliance_diagonal[0];
  structure.forming[first + structure.dofs.top_u] += form.inverse_sine[0] * moment;
  if (rotations.size() > 1) {
    structure.forming[first + structure.dofs.top_moment] -= moment_scale * form.compliance_off[0] * moment;
  }
  structure.forming_energy += 0.5 * rotations[0] * moment;
}

/// Fixes unused unknowns, which are uncoupled.
void hold_unused(const FoilStructure& structure, double stiffness, BlockTridiagonal& K) {
  const BumpDofs& dofs = structure.dofs;
  for (int b = 0; b < K.blocks(); ++b) {
    for (int i = 0; i < dofs.size; ++i) {
      const bool is_foot = i == dofs.foot_u.back() || i == dofs.foot_v.back();
      const bool before_bump_1 = b < structure.first_bump && !is_foot;
      if (before_bump_1 || i >= dofs.size - dofs.unused) K.add(b, i, b, i, stiffness);
    }
  }
}

/// Prevents rigid motion of a bump foil without a weld.
void hold_feet(const BumpDofs& dofs, BlockTridiagonal& K) {
  for (int b = 0; b < K.blocks(); ++b) {
    for (const int u : dofs.foot_u) K.add(b, u, b, u, loose_hold);
    for (const int v : dofs.foot_v) K.add(b, v, b, v, loose_hold);
  }
}

/// `x` with compatible moments: the moment rows of K solved for them.
Vector with_compatible_moments(const FoilStructure& structure, Vector x) {
  const Eigen::Index m = structure.dofs.top_moment;
  if (m < 0) return x;
  const Eigen::Index size = structure.dofs.size;
  const Eigen::Index blocks = structure.K.blocks();
  const auto moments = Eigen::seqN(m, blocks, size);
  x(moments).setZero();
  Vector kinks = -structure.forming(moments);
  Vector diagonal(blocks);
  Vector off(blocks - 1);
  for (Eigen::Index b = 0; b < blocks; ++b) {
    const Matrix& own = structure.K.diagonal[static_cast<std::size_t>(b)];
    kinks[b] += own.col(m).dot(x.segment(b * size, size));
    if (b > 0) {
      kinks[b] += structure.K.upper[static_cast<std::size_t>(b - 1)].col(m).dot(x.segment((b - 1) * size, size));
    }
    diagonal[b] = -own(m, m);
    if (b + 1 == blocks) continue;
    const Matrix& upper = structure.K.upper[static_cast<std::size_t>(b)];
    kinks[b] += upper.row(m).dot(x.segment((b + 1) * size, size));
    off[b] = -upper(m, m);
  }
  x(moments) = solve_tridiagonal(diagonal, off, kinks);
  return x;
}

/// Forces and energy of the linear part, from displacements alone: compatible moments make the moment rows zero.
ElasticResponse linear_response(const FoilStructure& structure, const Vector& x) {
  const BlockTridiagonal& K = structure.large_displacements ? structure.large_displacements->rest : structure.K;
  const Vector compatible = with_compatible_moments(structure, x);
  ElasticResponse response{.forces = K.multiply(compatible) - structure.forming, .energy = 0.0};
  if (const Eigen::Index m = structure.dofs.top_moment; m >= 0) {
    response.forces(Eigen::seqN(m, Eigen::Index{structure.K.blocks()}, Eigen::Index{structure.dofs.size})).setZero();
  }
  response.energy = 0.5 * x.dot(response.forces) + (structure.forming_energy - 0.5 * compatible.dot(structure.forming));
  return response;
}

}  // namespace

BumpDofs make_bump_dofs(const FoilDesign& foils) {
  if (foils.model == BumpFoilModel::former) {
    return {.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};
  }
  BumpDofs dofs = frame_dofs();
  if (foils.model == BumpFoilModel::truss) {
    dofs = {.size = 6, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}, .top_u = 4, .top_moment = 5};
  }
  if (!foils.top_foil) {
    dofs.top_u = dofs.top_moment = -1;
    dofs.unused = 2;
  }
  return dofs;
}

int block_of_bump_1(const FoilDesign& foils) {
  return foils.model == BumpFoilModel::frame || foils.welded ? 0 : 1;
}

FoilStructure make_foil_structure(const FoilDesign& foils) {
  FoilStructure structure;
  structure.dofs = make_bump_dofs(foils);
  structure.first_bump = block_of_bump_1(foils);
  structure.K = BlockTridiagonal(structure.first_bump + static_cast<int>(foils.bumps.size()), structure.dofs.size);
  structure.forming.setZero(structure.K.rows());
  if (foils.top_foil) {
    const TopFoilMoments form = make_top_foil_moments(foils);
    const double moment_scale = top_moment_scale(foils);
    assemble_top_foil(form, moment_scale, structure.dofs, structure.first_bump, structure.K);
    if (foils.radius) {
      add_forming(form, moment_scale, forming_rotations(make_top_foil_beam(foils), make_forming(foils)), structure);
    }
  }
  if (!foils.welded) hold_feet(structure.dofs, structure.K);
  const Section section = make_bump_section(foils, foils.bumps.front());
  hold_unused(structure, section.axial_stiffness / foils.reference_length(), structure.K);
  if (foils.model == BumpFoilModel::frame) {
    const FrameModel frame = make_frame_model(foils);
    if (foils.geometry == Geometry::nonlinear) {
      structure.large_displacements = {.bump_foils = {place_elements(frame, structure.dofs.size)}, .rest = structure.K};
      hold_covered_node(frame, structure.large_displacements->rest);
    }
    assemble_frame(frame, structure.K);
  } else {
    assemble_springs(make_truss_springs(make_truss_constants(foils), structure.dofs, foils.welded), structure.K);
  }
  return structure;
}

PadBlocks FoilStructure::blocks_of(int pad) const {
  const auto k = static_cast<std::size_t>(pad);
  const int end = k + 1 < pads.size() ? pads[k + 1] : K.blocks();
  return {.first = pads[k], .count = end - pads[k]};
}

void append(const FoilStructure& pad, FoilStructure& foils) {
  BUMPFOIL_ASSERT(pad.first_bump == 0 && foils.first_bump == 0 && pad.pads.size() == 1);
  foils.pads.push_back(foils.K.blocks());
  if (foils.large_displacements) {
    ElementChain& chain =
        foils.large_displacements->bump_foils.emplace_back(pad.large_displacements->bump_foils.front());
    for (PlacedElement& placed : chain.elements) {
      if (placed.start >= 0) placed.start += foils.K.rows();
      placed.end += foils.K.rows();
    }
    foils.large_displacements->rest.append(pad.large_displacements->rest);
  }
  foils.K.append(pad.K);
  const Eigen::Index before = foils.forming.size();
  foils.forming.conservativeResize(before + pad.forming.size());
  foils.forming.tail(pad.forming.size()) = pad.forming;
  foils.forming_energy += pad.forming_energy;
}

Vector internal_forces(const FoilStructure& structure, const Vector& x) {
  if (!structure.large_displacements) return structure.K.multiply(x);
  Vector forces = structure.large_displacements->rest.multiply(x);
  for (const ElementChain& chain : structure.large_displacements->bump_foils) add_corotational_forces(chain, x, forces);
  return forces;
}

BlockTridiagonal tangent_stiffness(const FoilStructure& structure, const Vector& x) {
  if (!structure.large_displacements) return structure.K;
  BlockTridiagonal K = structure.large_displacements->rest;
  for (const ElementChain& chain : structure.large_displacements->bump_foils) add_corotational_tangent(chain, x, K);
  return K;
}

BlockTridiagonal stable_tangent_stiffness(const FoilStructure& structure, const Vector& x) {
  if (!structure.large_displacements) return structure.K;
  BlockTridiagonal K = structure.large_displacements->rest;
  for (const ElementChain& chain : structure.large_displacements->bump_foils) add_stable_tangent(chain, x, K);
  return K;
}

ElasticResponse elastic_response(const FoilStructure& structure, const Vector& x) {
  ElasticResponse response = linear_response(structure, x);
  if (structure.large_displacements) {
    for (const ElementChain& chain : structure.large_displacements->bump_foils) {
      response.energy += add_corotational_forces(chain, x, response.forces);
    }
  }
  return response;
}

}  // namespace bumpfoil
