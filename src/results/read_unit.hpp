#pragma once

#include <numbers>
#include <string>

namespace bumpfoil {

/// A unit for display.
struct ReadUnit {
  std::string name;
  double size{1.0};  ///< SI
};

/// The display unit of keys with a given SI unit, "1" if dimensionless.
inline ReadUnit read_unit_of(const std::string& unit) {
  if (unit == "m") return {"um", 1e-6};
  if (unit == "rad") return {"deg", std::numbers::pi / 180.0};
  if (unit == "N/m") return {"MN/m", 1e6};
  if (unit == "N m") return {"N mm", 1e-3};
  if (unit == "Pa") return {"GPa", 1e9};
  return {unit == "1" ? "" : unit, 1.0};
}

}  // namespace bumpfoil
