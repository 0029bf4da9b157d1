#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/experiments/optimise/optimise_settings.hpp"

namespace bumpfoil {

/// Values of the chosen keys, SI, in the order of the settings.
using KeyValues = std::vector<double>;

/// The box of the searches: every key scaled from its lower to its upper bound, logarithmically if requested.
class KeyBox {
 public:
  explicit KeyBox(const std::vector<OptimisedKey>& keys) : keys_(keys) {}

  [[nodiscard]] Eigen::Index dimensions() const { return std::ssize(keys_); }
  [[nodiscard]] Eigen::VectorXd place_of(const KeyValues& values) const;
  [[nodiscard]] KeyValues values_at(const Eigen::VectorXd& place) const;
  /// Rounded to few enough digits that conversion to the box and back is exact, so that they are found again.
  [[nodiscard]] KeyValues short_values(const KeyValues& values) const;

 private:
  std::vector<OptimisedKey> keys_;
};

}  // namespace bumpfoil
