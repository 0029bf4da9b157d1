#include "bumpfoil/structure/bump_sheet.hpp"

#include <cstddef>

#include "bumpfoil/structure/membrane.hpp"

namespace bumpfoil {
namespace {

/// A tangential degree of freedom of the bump foil, and the piece before it.
struct SheetNode {
  int bump{};            ///< index from 0
  int unknown{-1};       ///< index in BumpDofs; -1: clamped
  double length{};       ///< X, m
  double developed{};    ///< S, m
  double flexibility{};  ///< S/t
};

/// Nodes from the weld on.
std::vector<SheetNode> nodes_of(const FoilDesign& foils, const BumpDofs& dofs) {
  std::vector<SheetNode> nodes(1);
  double flat_before = 0.0;  // half flat behind the previous bump
  double thickness_before = foils.bumps.front().thickness;
  for (std::size_t n = 0; n < foils.bumps.size(); ++n) {
    const double thickness = foils.bumps[n].thickness;
    const BumpArc arc = make_bump_arc(foils.bumps[n]);
    const double half_arc = arc.radius * arc.half_angle;
    const double half_flat = 0.5 * arc.flat;
    const auto add = [&](int unknown, double length, double developed, double flexibility) {
      nodes.push_back({static_cast<int>(n), unknown, length, developed, flexibility});
    };
    if (dofs.feet() == 1) {
      const double half = half_arc + half_flat;
      add(dofs.crest_u, arc.half_length + half_flat, half, half / thickness);
      add(dofs.foot_u.front(), arc.half_length + half_flat, half, half / thickness);
      continue;
    }
    if (n > 0 || foils.weld_at == WeldPosition::mid_flat) {
      const double flat = flat_before + half_flat;
      add(dofs.foot_u.front(), flat, flat, flat_before / thickness_before + half_flat / thickness);
    }
    add(dofs.crest_u, arc.half_length, half_arc, half_arc / thickness);
    add(dofs.foot_u.back(), arc.half_length, half_arc, half_arc / thickness);
    flat_before = half_flat;
    thickness_before = thickness;
  }
  return nodes;
}

}  // namespace

BlockTridiagonal bump_sheet_stiffness(const FoilDesign& foils, const std::vector<int>& orders) {
  const BumpDofs dofs = make_bump_dofs(foils);
  const auto modes = static_cast<int>(orders.size());
  const StressFunctionIntegrals integrals = stress_function_integrals(orders, 0.5 * foils.axial_length);
  const double thickness = foils.bumps.front().thickness;
  const double sigma = foils.youngs_modulus * thickness;
  const Vector per_load = integrals.G.cwiseInverse();
  const Matrix by_bow = sigma * thickness * per_load.asDiagonal() * integrals.A * per_load.asDiagonal();
  const Matrix by_slope = 2.0 * (1.0 + foils.poisson_ratio) * sigma * thickness * per_load.asDiagonal() * integrals.B *
                          per_load.asDiagonal();

  const std::vector<SheetNode> nodes = nodes_of(foils, dofs);
  const std::size_t end = nodes.size() - 1;  // where f = 0
  const int first = modes * dofs.size;
  BlockTridiagonal K(static_cast<int>(foils.bumps.size()), first + modes * sheet_nodes(dofs));
  // f of a node is an unknown in the block of the next node.
  std::vector<int> place(end);  // of the first mode
  std::vector<int> begun(foils.bumps.size(), 0);
  for (std::size_t i = 0; i < end; ++i) place[i] = first + modes * begun[static_cast<std::size_t>(nodes[i + 1].bump)]++;
  for (std::size_t b = 0; b < begun.size(); ++b) {
    for (int i = first + modes * begun[b]; i < K.block_size(); ++i) K.diagonal[b](i, i) = -sigma;
  }
  const auto add = [&](std::size_t i, std::size_t j, double factor, const Matrix& compliance) {
    if (j >= end) return;
    for (int k = 0; k < modes; ++k) {
      for (int l = i == j ? k : 0; l < modes; ++l) {
        K.add(nodes[i + 1].bump, place[i] + k, nodes[j + 1].bump, place[j] + l, -factor * compliance(k, l));
      }
    }
  };
  for (std::size_t i = 0; i < end; ++i) {
    const SheetNode& here = nodes[i + 1];  // end of the piece from node i
    const double slope = here.flexibility / (here.length * here.length);
    add(i, i, slope, by_slope);
    add(i, i + 1, -slope, by_slope);
    add(i + 1, i + 1, slope, by_slope);

    const SheetNode next = i + 1 < end ? nodes[i + 2] : SheetNode{};
    const double s = 0.5 * (here.developed + next.developed);
    const double bow = 0.5 * (here.flexibility + next.flexibility) / (s * s);
    const double before = 1.0 / here.length;
    const double after = i + 1 < end ? 1.0 / next.length : 0.0;
    add(i, i, bow * before * before, by_bow);
    add(i, i + 1, -bow * before * (before + after), by_bow);
    add(i, i + 2, bow * before * after, by_bow);
    add(i + 1, i + 1, bow * (before + after) * (before + after), by_bow);
    add(i + 1, i + 2, -bow * (before + after) * after, by_bow);
    add(i + 2, i + 2, bow * after * after, by_bow);

    for (const SheetNode& node : {nodes[i], here}) {
      if (node.unknown < 0) continue;
      for (int k = 0; k < modes; ++k) {
        const int u = k * dofs.size + node.unknown;
        K.add(node.bump, u, here.bump, place[i] + k, -0.5 * sigma);
        if (i + 1 < end) K.add(node.bump, u, next.bump, place[i + 1] + k, 0.5 * sigma);
      }
    }
  }
  return K;
}

}  // namespace bumpfoil
