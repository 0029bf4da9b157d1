#include "bumpfoil/results/checksum.hpp"

#include <fmt/format.h>

#include <fstream>
#include <ios>
#include <memory>
#include <new>
#include <vector>

// Header-only use of the library, so that dependents need not link it.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

std::string hexadecimal(XXH128_hash_t hash) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, hash);
  std::string text;
  for (const unsigned char byte : canonical.digest) text += fmt::format("{:02x}", byte);
  return text;
}

}  // namespace

std::string xxh3_128(std::string_view bytes) {
  return hexadecimal(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string xxh3_128_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), &XXH3_freeState);
  if (!state) throw std::bad_alloc();
  XXH3_128bits_reset(state.get());
  std::vector<char> piece(std::size_t{1} << 20U);
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    XXH3_128bits_update(state.get(), piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) throw Error(ErrorKind::file, {{path.string(), 0, "", "", "cannot be read", ""}});
  return hexadecimal(XXH3_128bits_digest(state.get()));
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
