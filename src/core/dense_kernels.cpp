#include "bumpfoil/core/dense_kernels.hpp"

namespace bumpfoil {

void add_rows(double sign, const double* factors, Eigen::Index step, Eigen::Index count, const double* rows,
              Eigen::Index columns, double* row) {
  with_widest_vectors([=](auto /*lanes*/) BUMPFOIL_ALWAYS_INLINE {
    for (Eigen::Index k = 0; k < count; ++k) {
      const double factor = sign * factors[k * step];
      if (factor == 0.0) continue;
      const double* other = rows + k * columns;
      for (Eigen::Index c = 0; c < columns; ++c) row[c] += factor * other[c];
    }
  });
}

}  // namespace bumpfoil
