#pragma once

#include <filesystem>
#include <string>

namespace bumpfoil {

/// All bytes of a file, whatever they are.
/// @throws Error (file) if it cannot be read, is not a regular file, or is larger than the memory that is to be had
std::string read_binary_file(const std::filesystem::path& path);

}  // namespace bumpfoil
