#pragma once

#include <string>
#include <string_view>

namespace bumpfoil {

/// Maximum size of case files and tables, bytes.
inline constexpr std::size_t largest_text_file = 10'000'000;

/// The name for standard input.
inline constexpr std::string_view standard_input = "-";

/// The content of a text file or of the standard input, without a leading byte order mark.
/// @throws Error (file) if it cannot be read or is a folder; Error (input) if it is larger than `largest_text_file`, or
///   not text.
std::string read_text_file(const std::string& path);

/// Whether a text is empty except for spaces and line ends.
inline bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace bumpfoil
