#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// A number on which limits can be set.
struct LimitedQuantity {
  std::string name;
  std::string unit;  ///< SI, in UDUNITS spelling; "1" if dimensionless
};

/// A limit on a quantity.
struct QuantityLimit {
  std::size_t quantity{};  ///< its index
  bool above{};            ///< it must be above the bound, else below
  double bound{};          ///< SI
};

/// Texts for messages about limits.
struct LimitWords {
  std::string key;      ///< key of the case, or option
  std::string whole;    ///< owner of the quantities, "the ensemble"
  std::string listing;  ///< where quantity names are listed
  std::string example;  ///< an example limit
};

/// Index of the quantity of this name. @throws Error (input) with the nearest name
std::size_t parse_quantity_name(const std::string& name, const std::vector<LimitedQuantity>& quantities,
                                const LimitWords& words);

/// Reads a limit such as "clearance_5N > 20 um" or "max_force < 900": quantity, > or <, and a number with a unit or in
/// SI. @throws Error (input)
QuantityLimit parse_quantity_limit(const std::string& text, const std::vector<LimitedQuantity>& quantities,
                                   const LimitWords& words);

}  // namespace bumpfoil
