#include "case/udunits.hpp"
#include "case/unit_system.hpp"

namespace bumpfoil {

std::optional<UnitMeaning> read_unit(std::string_view text) {
  static const Udunits udunits;
  return udunits.read(text);
}

}  // namespace bumpfoil
