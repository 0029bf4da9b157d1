#include "bumpfoil/io/checksum.hpp"

#include <fmt/format.h>

// All of the library is in its header this way: whoever links ours needs no other.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

std::string xxh3_128(std::string_view bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  std::string text;
  for (const unsigned char byte : canonical.digest) text += fmt::format("{:02x}", byte);
  return text;
}

std::string sealed(std::string text) {
  const std::size_t place = text.find(blank_checksum);
  BUMPFOIL_ASSERT(place != std::string::npos);
  return text.replace(place, blank_checksum.size(), xxh3_128(text));
}

bool is_sealed(std::string text, std::string_view checksum) {
  const std::size_t place = text.find(checksum);
  if (place == std::string::npos || checksum.size() != blank_checksum.size()) return false;
  return xxh3_128(text.replace(place, checksum.size(), blank_checksum)) == checksum;
}

}  // namespace bumpfoil
