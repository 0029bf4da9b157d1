#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bumpfoil {

/// Base64 of numbers rounded to binary32, little-endian; those that are not finite become NaN.
std::string base64_of(const std::vector<double>& numbers);

std::string base64_of(const std::vector<std::uint8_t>& bytes);

/// Base64 of signed bytes.
std::string base64_of(const std::vector<signed char>& flags);

}  // namespace bumpfoil
