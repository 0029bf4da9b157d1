#pragma once

#include <string>

#include "fuzz/draws_of_bytes.hpp"

namespace bumpfoil {

/// A case file, and the command that is to run it.
struct DrawnCase {
  std::string command;
  std::string text;
};

/// A bearing of any family at the limits of valid input, and its loading: 1 to 500 bumps on 1 to 6 pads, clearances
/// from minus a bump height to a tenth of the radius, foils of 5 um to 2 mm, Young's moduli over eight decades,
/// friction 0 to 1, height errors up to the rise, speeds to +-200,000 rpm. Few increments and coarse films. Most are
/// valid; the case reader must reject the others.
DrawnCase draw_case(DrawsOfBytes draws);

}  // namespace bumpfoil
