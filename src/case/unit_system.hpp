#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace bumpfoil {

/// Units that all others are made of, in the order of the powers of a unit.
inline constexpr std::array<std::string_view, 8> base_units{"kg", "m", "s", "A", "K", "mol", "cd", "rad"};

/// Powers of base_units.
using UnitPowers = std::array<int, base_units.size()>;

/// What a unit measures, and how large it is.
struct UnitMeaning {
  UnitPowers powers{};
  std::optional<double> scale{};  ///< one of it in base units; none if it is shifted or logarithmic ("degC")

  bool operator==(const UnitMeaning&) const = default;
};

/// Reads a unit of UDUNITS-2, such as "MN/m", "uPa s" or "deg"; nothing where it is none.
///
/// The program asks UDUNITS-2 itself. Where that is not to be had, in a browser, the table that was made of its
/// database answers, see unit_table.hpp.
///
/// Not thread-safe.
/// @throws Error (file) if the units database of UDUNITS-2 cannot be read.
std::optional<UnitMeaning> read_unit(std::string_view text);

}  // namespace bumpfoil
