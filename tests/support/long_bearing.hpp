#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The bearing with more bumps on a proportionally larger radius, so that the foils still cover one circumference.
inline Case with_bumps(Case input, int bumps) {
  input.bearing.radius *= static_cast<double>(bumps) / input.bump_foil.bumps;
  input.bump_foil.bumps = bumps;
  return input;
}

}  // namespace bumpfoil
