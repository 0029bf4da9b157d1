#pragma once

#include <filesystem>
#include <string_view>

namespace bumpfoil {

/// What happens to files that are there already.
enum class Existing { refuse, replace };

/// Writes one file whole or not at all: under a temporary name beside it first, flushed, then renamed. Temporary files
/// of the same name that a process left which was killed are removed.
/// @throws Error (file) if it cannot be written, or exists and must not be replaced.
void write_file(const std::filesystem::path& path, std::string_view contents, Existing existing);

}  // namespace bumpfoil
