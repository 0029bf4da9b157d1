#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace bumpfoil {

/// Powers of kg, m, s, K and rad that make up the units of case files.
using UnitPowers = std::array<int, 5>;

/// Dimension and size of a unit.
struct UnitMeaning {
  UnitPowers powers{};
  std::optional<double> scale{};  ///< SI value of one unit; none if it has an offset ("degC")
};

/// A known unit.
struct KnownUnit {
  std::string_view symbols;  ///< separated by blanks; case-sensitive
  std::string_view names;    ///< separated by blanks, in lower case: matched without case, and with a plural "s"
  UnitMeaning meaning;
};

/// Prefixes; a unit takes at most one.
struct UnitPrefix {
  std::string_view symbol;
  std::string_view name;
  double value;
};

/// All known units: the common ones. A test compares each with UDUNITS-2.
std::span<const KnownUnit> known_units();
std::span<const UnitPrefix> unit_prefixes();

/// Reads units with their prefixes, as products ("Pa s", "N.m", "N*m", "N-m"), quotients from the left ("kg/m/s2",
/// "kg/(m s2)", "1/s") and powers of one digit ("m2", "s-1", "m^2", "m**2", "m²"); nothing if the text is not a unit.
std::optional<UnitMeaning> read_unit(std::string_view text);

}  // namespace bumpfoil
