#pragma once

#include <cstdint>

namespace bumpfoil {

/// What a random number is drawn for. Every place has a number of its own, whatever else is drawn, and when.
struct DrawPlace {
  std::uint64_t seed{};
  std::uint64_t sample{};
  std::uint32_t variable{};  ///< what is drawn
  std::uint32_t element{};   ///< which of several alike
};

/// A number between 0 and 1, bounds excluded, uniform on a grid of 2^52 values: from the counter-based generator
/// Philox4x32-10 [Salmon2011] with the seed for its key and the rest of the place for its counter.
double uniform_draw(const DrawPlace& place);

}  // namespace bumpfoil
