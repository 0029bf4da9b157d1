#include "bumpfoil/ensemble/draws.hpp"

#include <Random123/philox.h>

namespace bumpfoil {
namespace {

constexpr std::uint32_t low(std::uint64_t number) {
  return static_cast<std::uint32_t>(number);
}
constexpr std::uint32_t high(std::uint64_t number) {
  return static_cast<std::uint32_t>(number >> 32U);
}

}  // namespace

double uniform_draw(const DrawPlace& place) {
  const r123::Philox4x32::ctr_type counter{{low(place.sample), high(place.sample), place.variable, place.element}};
  const r123::Philox4x32::key_type key{{low(place.seed), high(place.seed)}};
  const auto words = r123::Philox4x32()(counter, key);
  const std::uint64_t bits = (std::uint64_t{words[0]} << 32U | words[1]) >> 12U;
  // The midpoint of one of 2^52 equal intervals, exactly representable.
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

}  // namespace bumpfoil
