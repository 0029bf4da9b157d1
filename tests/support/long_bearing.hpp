#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The bearing with more bumps on a radius that grows with them, so that the foils still go round once.
inline Case with_bumps(Case input, int bumps) {
  input.bearing.radius *= static_cast<double>(bumps) / input.bump_foil.bumps;
  input.bump_foil.bumps = bumps;
  return input;
}

}  // namespace bumpfoil
