#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/experiments/optimise/optimise_settings.hpp"

namespace bumpfoil {

/// Values of the keys that are chosen, SI, in the order of the settings.
using KeyValues = std::vector<double>;

/// The box that searches run in: every key in parts of the way from its lower to its upper bound, of logarithms where
/// the key asks for them.
class KeyBox {
 public:
  explicit KeyBox(const std::vector<OptimisedKey>& keys) : keys_(keys) {}

  [[nodiscard]] Eigen::Index dimensions() const { return std::ssize(keys_); }
  [[nodiscard]] Eigen::VectorXd place_of(const KeyValues& values) const;
  [[nodiscard]] KeyValues values_at(const Eigen::VectorXd& place) const;
  /// With so few digits that they come back from their place in the box the same, and are found again.
  [[nodiscard]] KeyValues short_values(const KeyValues& values) const;

 private:
  std::vector<OptimisedKey> keys_;
};

}  // namespace bumpfoil
