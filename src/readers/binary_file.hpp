#pragma once

#include <filesystem>
#include <string>

namespace bumpfoil {

/// All bytes of a file.
/// @throws Error (file) if it cannot be read, is not a regular file, or exceeds memory
std::string read_binary_file(const std::filesystem::path& path);

}  // namespace bumpfoil
