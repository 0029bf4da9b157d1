#pragma once

#include <Eigen/Core>
#include <optional>

namespace bumpfoil {

/// Tangent stiffnesses d(F.n)/ds at a state, N/m; absent where the closed contacts leave the foils loose.
struct TangentStiffnesses {
  std::optional<double> loading;    ///< slipping contacts go on slipping
  std::optional<double> unloading;  ///< all closed contacts stick
};

/// The same for motion in any direction: dF/d(x, y), entry (i, j) = dF_i/dx_j, N/m. Slipping contacts go on slipping
/// only for directions near the last one: the loading tangent holds there, the unloading one for a reversal.
struct TangentMatrices {
  std::optional<Eigen::Matrix2d> loading;
  std::optional<Eigen::Matrix2d> unloading;

  /// n . K n for the unit vector n.
  [[nodiscard]] TangentStiffnesses along(const Eigen::Vector2d& direction) const;
};

}  // namespace bumpfoil
