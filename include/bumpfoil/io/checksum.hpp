#pragma once

#include <string>
#include <string_view>

namespace bumpfoil {

/// XXH3 of 128 bits (https://xxhash.com) in its canonical form, 32 hexadecimal digits: what `xxhsum -H2` prints. It
/// tells damage, not forgery.
std::string xxh3_128(std::string_view bytes);

}  // namespace bumpfoil
