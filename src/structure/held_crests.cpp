#include "bumpfoil/structure/held_crests.hpp"

#include <algorithm>
#include <vector>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Indices in a block of unknowns that are neither displacement nor moment: rotations of the frame.
std::vector<int> rotations(const BumpDofs& dofs) {
  std::vector<int> places;
  for (int i = 0; i < dofs.size - dofs.unused; ++i) {
    const auto is_foot = [i](const std::vector<int>& feet) {
      return std::find(feet.begin(), feet.end(), i) != feet.end();
    };
    if (i == dofs.crest_u || i == dofs.crest_v || i == dofs.top_u || i == dofs.top_moment) continue;
    if (!is_foot(dofs.foot_u) && !is_foot(dofs.foot_v)) places.push_back(i);
  }
  return places;
}

}  // namespace

Matrix held_crest_stiffness(const FoilStructure& structure, int pad) {
  const auto [first, count] = structure.blocks_of(pad);
  const std::vector<int> turning = rotations(structure.dofs);
  const auto n = static_cast<Eigen::Index>(turning.size());
  Matrix crests = Matrix::Zero(count, count);
  Matrix mixed = Matrix::Zero(n * count, count);
  Matrix turned = Matrix::Zero(n * count, n * count);
  const int v = structure.dofs.crest_v;
  const auto add = [&](const Matrix& block, Eigen::Index i, Eigen::Index j) {
    crests(i, j) = block(v, v);
    mixed.block(n * i, j, n, 1) = block(turning, v);
    turned.block(n * i, n * j, n, n) = block(turning, turning);
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(first + i);
    add(structure.K.diagonal[at], i, i);
    if (i + 1 == count) continue;
    add(structure.K.upper[at], i, i + 1);
    add(structure.K.upper[at].transpose(), i + 1, i);
  }
  if (n == 0) return crests;
  const Matrix released = solve_symmetric(turned, mixed);
  return crests - transposed_product(mixed, released);
}

}  // namespace bumpfoil
