#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bumpfoil {

/// Longest path that the systems we run on accept: a shortened one could not be opened by a click.
inline constexpr std::size_t longest_path = 4096;

/// Whether a text is UTF-8, as all texts in files of results must be.
bool is_utf8(std::string_view text);

/// Text of unknown origin (file names, titles, attributes, what a user typed) made safe to print: what would steer a
/// terminal or disguise what stands around it is written as `\xNN`, byte for byte. That is
///
/// * control characters of ASCII, among them line ends, and of Latin-1 (C1), some of which start escape sequences;
/// * characters that turn the direction of writing (U+061C, U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069), line
///   and paragraph separators (U+2028, U+2029), and one that is never seen (U+FEFF);
/// * bytes that are no UTF-8.
///
/// @param limit  in bytes; longer text is cut there, between two characters, and its size is said
std::string printable(std::string_view text, std::size_t limit = 80);

/// The same for text of several lines, such as a whole table: line ends stay, and nothing is cut.
std::string printable_lines(std::string_view text);

/// The same for JSON: such characters become `\uNNNN`, which means the same in its texts, the only place where they can
/// be. Line ends stay. @param json  valid UTF-8
std::string printable_json(std::string_view json);

}  // namespace bumpfoil
