#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bumpfoil {

/// XXH3 of 128 bits (https://xxhash.com) in its canonical form, 32 hexadecimal digits: what `xxhsum -H2` prints. It
/// detects damage, not forgery.
std::string xxh3_128(std::string_view bytes);

/// The same of a file, read piece by piece. @throws Error (file) if it cannot be read
std::string xxh3_128_of_file(const std::filesystem::path& path);

/// What a text that is to vouch for itself has in the place of its checksum.
inline constexpr std::string_view blank_checksum = "00000000000000000000000000000000";

/// The text with its checksum in place of the first `blank_checksum`, which it must have.
std::string sealed(std::string text);

/// Whether a text is what `sealed` made with this checksum.
bool is_sealed(std::string text, std::string_view checksum);

}  // namespace bumpfoil
