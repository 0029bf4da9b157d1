#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace bumpfoil {

/// Powers of kg, m, s, K and rad, which the units of case files are made of.
using UnitPowers = std::array<int, 5>;

/// What a unit measures, and how large it is.
struct UnitMeaning {
  UnitPowers powers{};
  std::optional<double> scale{};  ///< one of it in SI; none if it is shifted ("degC")
};

/// A unit that is known.
struct KnownUnit {
  std::string_view symbols;  ///< set off by blanks; capitals tell them apart
  std::string_view names;  ///< set off by blanks, in small letters: capitals and an "s" behind them make no difference
  UnitMeaning meaning;
};

/// What may stand before any of them, once.
struct UnitPrefix {
  std::string_view symbol;
  std::string_view name;
  double value;
};

/// All that are known: those that people write. A test compares each of them with UDUNITS-2.
std::span<const KnownUnit> known_units();
std::span<const UnitPrefix> unit_prefixes();

/// Reads units with their prefixes, as products ("Pa s", "N.m", "N*m", "N-m"), quotients from the left ("kg/m/s2",
/// "kg/(m s2)", "1/s") and powers of one digit ("m2", "s-1", "m^2", "m**2", "m²"); nothing where it is none.
std::optional<UnitMeaning> read_unit(std::string_view text);

}  // namespace bumpfoil
