#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// A number that limits can be on.
struct LimitedQuantity {
  std::string name;
  std::string unit;  ///< SI, as UDUNITS spells it; "1" where there is none
};

/// A limit on a quantity.
struct QuantityLimit {
  std::size_t quantity{};  ///< number of it
  bool above{};            ///< it must be above the bound, else below
  double bound{};          ///< SI
};

/// Advice in messages about limits.
struct LimitWords {
  std::string key;      ///< of the case, or option
  std::string whole;    ///< "the ensemble", whose quantities they are
  std::string listing;  ///< where names of quantities are found
  std::string example;  ///< of a limit
};

/// Number of the quantity of this name. @throws Error (input) with the nearest name
std::size_t parse_quantity_name(const std::string& name, const std::vector<LimitedQuantity>& quantities,
                                const LimitWords& words);

/// Reads a limit such as "clearance_5N > 20 um" or "max_force < 900": quantity, > or <, and a number with a unit or in
/// SI. @throws Error (input)
QuantityLimit parse_quantity_limit(const std::string& text, const std::vector<LimitedQuantity>& quantities,
                                   const LimitWords& words);

}  // namespace bumpfoil
