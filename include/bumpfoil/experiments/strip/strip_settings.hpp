#pragma once

#include <optional>
#include <string_view>

#include "bumpfoil/model/bearing_design.hpp"
#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

/// Cycles of a flat strip of the foils between a rigid base and a rigid plate. Without a preload each goes from zero to
/// `amplitude` and back; with one, from the preload up by `amplitude`, down by twice as much, and back.
struct StripSettings {
  static constexpr std::string_view table = "strip";

  int bumps{};  ///< the first bumps of the foil
  StripWeld weld{StripWeld::one_end};
  bool top_foil{true};  ///< there is one between plate and bumps
  Target amplitude;     ///< of the plate, from where it touches nominal foils, towards the base
  std::optional<Target> preload{};
  int cycles{1};   ///< one after the other, with friction carried over
  int steps{100};  ///< equal increments from the start of a cycle to its full amplitude

  bool operator==(const StripSettings&) const = default;
};

}  // namespace bumpfoil
