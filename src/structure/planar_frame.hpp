#pragma once

#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/structure/frame_element.hpp"

namespace bumpfoil {

/// Small plane frame as a dense matrix: unknown 3 * node + {0, 1, 2} is u (m), v (m), rotation (rad).
class PlanarFrame {
 public:
  using Unknowns = std::vector<Eigen::Index>;

  explicit PlanarFrame(int nodes);

  void add(int start_node, int end_node, const Section& section, const FrameElement& element);

  /// Stiffness at the unknowns `kept`, in their order; `fixed` ones are zero, all others free.
  [[nodiscard]] Matrix condense(const Unknowns& kept, const Unknowns& fixed) const;

 private:
  Matrix K_;
};

}  // namespace bumpfoil
