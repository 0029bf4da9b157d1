#pragma once

#include "bumpfoil/structure/truss.hpp"

namespace bumpfoil {

/// Constants of the truss model: those that the case gives.
TrussConstants make_truss_constants(const Case& input);

}  // namespace bumpfoil
