#include "bumpfoil/bearing/tangents.hpp"

namespace bumpfoil {

TangentStiffnesses TangentMatrices::along(const Eigen::Vector2d& direction) const {
  const auto quadratic_form = [&](const std::optional<Eigen::Matrix2d>& K) {
    return K ? std::optional(direction.dot(*K * direction)) : std::nullopt;
  };
  return {.loading = quadratic_form(loading), .unloading = quadratic_form(unloading)};
}

}  // namespace bumpfoil
