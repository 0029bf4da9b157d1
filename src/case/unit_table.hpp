#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace bumpfoil {

/// Powers of kg, m, s, K and rad, of which the units of case files are composed.
using UnitPowers = std::array<int, 5>;

/// Dimension and size of a unit.
struct UnitMeaning {
  UnitPowers powers{};
  std::optional<double> scale{};  ///< one of it in SI; none if it is shifted ("degC")
};

/// A known unit.
struct KnownUnit {
  std::string_view symbols;  ///< set off by blanks; capitals tell them apart
  std::string_view names;  ///< set off by blanks, in small letters: capitals and an "s" behind them make no difference
  UnitMeaning meaning;
};

/// Prefixes, one per unit.
struct UnitPrefix {
  std::string_view symbol;
  std::string_view name;
  double value;
};

/// All known units: those in common use. A test compares each of them with UDUNITS-2.
std::span<const KnownUnit> known_units();
std::span<const UnitPrefix> unit_prefixes();

/// Reads units with their prefixes, as products ("Pa s", "N.m", "N*m", "N-m"), quotients from the left ("kg/m/s2",
/// "kg/(m s2)", "1/s") and powers of one digit ("m2", "s-1", "m^2", "m**2", "m²"); nothing where it is none.
std::optional<UnitMeaning> read_unit(std::string_view text);

}  // namespace bumpfoil
