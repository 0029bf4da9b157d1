#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

/// Cycles of the journal along each direction, each from the unstressed foils. One-sided cycles go from the centre to
/// full displacement or load and back. About a preload, or with `swing`, they are fully reversed: to the same distance
/// on the other side, and back.
struct CycleSettings {
  static constexpr std::string_view table = "cycle";

  std::vector<double> directions;  ///< rad, from the X axis towards Y
  Target amplitude;
  std::optional<PlaneTarget> preload{};  ///< that cycles go about
  bool swing{};
  int cycles{1};                                    ///< at most, until the loop has settled
  int steps{100};                                   ///< equal increments from the start to full displacement or load
  std::vector<double> clearance_forces{5.0, 10.0};  ///< N, see Clearance

  bool operator==(const CycleSettings&) const = default;

  [[nodiscard]] bool is_fully_reversed() const { return swing || preload.has_value(); }
};

}  // namespace bumpfoil
