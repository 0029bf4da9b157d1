#pragma once

#include <string>

#include "fuzz/draws_of_bytes.hpp"

namespace bumpfoil {

/// A case file, and the command that is to run it.
struct DrawnCase {
  std::string command;
  std::string text;
};

/// A bearing of any family at the edges of what is accepted, and what is done to it: 1 to 500 bumps on 1 to 6 pads,
/// clearances from the height of a bump below zero to a tenth of the radius, foils of 5 um to 2 mm, Young's moduli over
/// eight decades, friction 0 to 1, height errors up to the rise, speeds to +-200,000 rpm. Few increments and coarse
/// films. Most are valid; what is not is for the reader of cases to refuse.
DrawnCase draw_case(DrawsOfBytes draws);

}  // namespace bumpfoil
