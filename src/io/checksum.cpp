#include "bumpfoil/io/checksum.hpp"

#include <fmt/format.h>

// All of the library is in its header this way: whoever links ours needs no other.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace bumpfoil {

std::string xxh3_128(std::string_view bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  std::string text;
  for (const unsigned char byte : canonical.digest) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace bumpfoil
