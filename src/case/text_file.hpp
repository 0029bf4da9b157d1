#pragma once

#include <string>
#include <string_view>

namespace bumpfoil {

/// Case files and tables of users are smaller than this.
inline constexpr std::size_t largest_text_file = 10'000'000;

/// The name that stands for the standard input.
inline constexpr std::string_view standard_input = "-";

/// The whole of a text file or of the standard input, without the byte order mark that some editors put first.
/// @throws Error (file) if it cannot be read or is a folder; Error (input) if it is larger than `largest_text_file`, or
/// no text.
std::string read_text_file(const std::string& path);

/// Whether a text has nothing but spaces and line ends.
inline bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace bumpfoil
