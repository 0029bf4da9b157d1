#pragma once

#include <numbers>
#include <string>

namespace bumpfoil {

/// A unit that people read numbers in.
struct ReadUnit {
  std::string name;
  double size{1.0};  ///< SI
};

/// That for keys of the case in an SI unit, "1" where they have none.
inline ReadUnit read_unit_of(const std::string& unit) {
  if (unit == "m") return {"um", 1e-6};
  if (unit == "rad") return {"deg", std::numbers::pi / 180.0};
  if (unit == "N/m") return {"MN/m", 1e6};
  if (unit == "N m") return {"N mm", 1e-3};
  if (unit == "Pa") return {"GPa", 1e9};
  return {unit == "1" ? "" : unit, 1.0};
}

}  // namespace bumpfoil
