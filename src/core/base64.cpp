#include "core/base64.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace bumpfoil {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

/// Written in place: pages contain megabytes of it, and appending single characters took as long as solving four
/// cycles.
std::string base64_of(const std::vector<std::uint8_t>& bytes) {
  std::string out((bytes.size() + 2) / 3 * 4, '=');
  auto letter = out.begin();
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16;
    if (count > 1) group |= static_cast<std::uint32_t>(bytes[i + 1]) << 8;
    if (count > 2) group |= bytes[i + 2];
    for (std::size_t k = 0; k <= count; ++k)
      letter[static_cast<std::ptrdiff_t>(k)] = alphabet[group >> (18 - 6 * k) & 63U];
    letter += 4;
  }
  return out;
}

std::string base64_of(const std::vector<double>& numbers) {
  std::vector<std::uint8_t> bytes(4 * numbers.size());
  auto byte = bytes.begin();
  for (const double number : numbers) {
    const bool known = std::abs(number) <= std::numeric_limits<float>::max();
    const float single = known ? static_cast<float>(number) : std::numeric_limits<float>::quiet_NaN();
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);  // std::bit_cast is missing in the library of Emscripten
    for (const unsigned shift : {0U, 8U, 16U, 24U}) *byte++ = static_cast<std::uint8_t>(bits >> shift);
  }
  return base64_of(bytes);
}

std::string base64_of(const std::vector<signed char>& flags) {
  return base64_of(std::vector<std::uint8_t>(flags.begin(), flags.end()));
}

}  // namespace bumpfoil
