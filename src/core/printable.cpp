#include "bumpfoil/core/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace bumpfoil {
namespace {

struct CodeRange {
  char32_t first, last;

  [[nodiscard]] bool holds(char32_t code) const { return first <= code && code <= last; }
};
constexpr CodeRange surrogates{0xd800, 0xdfff};  // not characters
constexpr CodeRange too_large{0x110000, std::numeric_limits<char32_t>::max()};
constexpr std::array<CodeRange, 9> unprintable{{{0x00, 0x1f},
                                                {0x7f, 0x9f},
                                                {0x61c, 0x61c},
                                                {0x200e, 0x200f},
                                                {0x2028, 0x202e},
                                                {0x2066, 0x2069},
                                                surrogates,
                                                {0xfeff, 0xfeff},
                                                too_large}};

/// The first character of a text: its code, above all valid ones if it is not UTF-8, and its size in bytes.
struct Character {
  char32_t code;
  std::size_t size;

  [[nodiscard]] bool is_printable() const {
    return std::none_of(unprintable.begin(), unprintable.end(),
                        [this](const CodeRange& range) { return range.holds(code); });
  }
};

Character first_character(std::string_view text) {
  constexpr Character invalid{too_large.last, 1};
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return {first, 1};
  const std::size_t size = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  if (size == 0 || text.size() < size) return invalid;
  char32_t code = first & (0x7fU >> size);
  for (const char c : text.substr(1, size - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0U) != 0x80) return invalid;
    code = code << 6U | (byte & 0x3fU);
  }
  // Overlong sequences are invalid: they could hide a shorter one.
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  return code < least[size] ? invalid : Character{code, size};
}

void append_bytes(std::string& out, std::string_view bytes) {
  for (const char c : bytes) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const Character character = first_character(text);
    if (surrogates.holds(character.code) || too_large.holds(character.code)) return false;
    text.remove_prefix(character.size);
  }
  return true;
}

std::string printable(std::string_view text, std::size_t limit) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (i >= limit) return out + fmt::format("... ({} characters)", text.size());
    const Character character = first_character(text.substr(i));
    const std::string_view bytes = text.substr(i, character.size);
    if (character.is_printable()) {
      out += bytes;
    } else {
      append_bytes(out, bytes);
    }
    i += character.size;
  }
  return out;
}

std::string printable_lines(std::string_view text) {
  std::string out;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    out += printable(text.substr(0, end), end) + '\n';
    text.remove_prefix(end + 1);
  }
  return out + printable(text, text.size());
}

std::string printable_json(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (std::size_t i = 0; i < json.size();) {
    const Character character = first_character(json.substr(i));
    if (character.code == '\n' || character.is_printable()) {
      out += json.substr(i, character.size);
    } else {
      out += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character.code));
    }
    i += character.size;
  }
  return out;
}

}  // namespace bumpfoil
