#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "case/unit_system.hpp"

namespace bumpfoil {

/// A unit of the database of UDUNITS-2.
struct TableUnit {
  std::string_view name;
  bool is_symbol;  ///< which capitals tell apart
  UnitMeaning meaning;
};

/// A prefix of it.
struct TablePrefix {
  std::string_view name;
  bool is_symbol;
  double value;
};

/// The units and prefixes of UDUNITS-2, for where it is not to be had.
struct UnitTable {
  std::span<const TableUnit> units;
  std::span<const TablePrefix> prefixes;
};

/// The table that make_unit_table.cpp writes, when the program is built, out of the database of UDUNITS-2.
UnitTable unit_table();

/// Reads a unit by the grammar of UDUNITS-2: products ("N m", "N.m", "N*m"), quotients ("N/m", "N per m"), powers
/// ("m2", "s-1", "m^2", "m**2"), brackets, and prefixes. Shifted units ("K from 273") and logarithms, which no case
/// file has a use for, are not read; nor are numbers, but for a 1 at the beginning ("1/s").
std::optional<UnitMeaning> read_unit(std::string_view text, const UnitTable& table);

}  // namespace bumpfoil
