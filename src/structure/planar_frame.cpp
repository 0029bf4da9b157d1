#include "structure/planar_frame.hpp"

#include <array>

#include "core/linear_algebra.hpp"

namespace bumpfoil {

PlanarFrame::PlanarFrame(int nodes) : K_(Matrix::Zero(3 * Eigen::Index{nodes}, 3 * Eigen::Index{nodes})) {}

void PlanarFrame::add(int start_node, int end_node, const Section& section, const FrameElement& element) {
  const Eigen::Index a = 3 * Eigen::Index{start_node};
  const Eigen::Index b = 3 * Eigen::Index{end_node};
  const std::array<Eigen::Index, 6> place{a, a + 1, a + 2, b, b + 1, b + 2};
  K_(place, place) += frame_element_stiffness(section, element);
}

Matrix PlanarFrame::condense(const Unknowns& kept, const Unknowns& fixed) const {
  std::vector<bool> is_free(static_cast<std::size_t>(K_.rows()), true);
  for (const Unknowns& others : {kept, fixed}) {
    for (const Eigen::Index unknown : others) is_free[static_cast<std::size_t>(unknown)] = false;
  }
  Unknowns free;
  for (std::size_t unknown = 0; unknown < is_free.size(); ++unknown) {
    if (is_free[unknown]) free.push_back(static_cast<Eigen::Index>(unknown));
  }
  const Matrix coupling = K_(free, kept);
  return K_(kept, kept) - transposed_product(coupling, solve_symmetric(K_(free, free), coupling));
}

}  // namespace bumpfoil
