#include "bumpfoil/structure/identification.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

TrussConstants make_truss_constants(const Case& input) {
  const TrussOverrides& given = input.bump_foil.truss;
  BUMPFOIL_ASSERT(given.k1 && given.k2 && given.k3 && given.k4 && given.theta_d);
  return {*given.k1, *given.k2, *given.k3, *given.k4, *given.theta_d};
}

}  // namespace bumpfoil
