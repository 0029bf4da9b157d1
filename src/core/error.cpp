#include "bumpfoil/core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace bumpfoil {
namespace {

/// Longest path that the systems we run on accept: a shortened one could not be opened by a click.
constexpr std::size_t longest_path = 4096;

/// C0 and C1 control characters (the latter are two bytes in UTF-8) and delete.
bool starts_control(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return true;
  return byte(0) == 0xc2 && text.size() > 1 && byte(1) >= 0x80 && byte(1) < 0xa0;
}

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

std::string join(const std::vector<Fault>& faults) {
  std::string out;
  for (const Fault& fault : faults) {
    if (!out.empty()) out += '\n';
    out += format_fault(fault);
  }
  return out;
}

}  // namespace

Error::Error(ErrorKind kind, std::vector<Fault> faults)
    : std::runtime_error(join(faults)), kind_(kind), faults_(std::move(faults)) {}

std::string format_fault(const Fault& fault) {
  std::string out;
  if (!fault.file.empty()) {
    out += printable(fault.file, longest_path);
    if (fault.line > 0) out += fmt::format(":{}", fault.line);
    out += ": ";
  }
  if (!fault.key.empty()) {
    out += printable(fault.key);
    if (!fault.value.empty()) out += " = " + printable(fault.value);
    out += ": ";
  }
  out += fault.what;
  if (!fault.advice.empty()) out += "; " + fault.advice;
  return out;
}

std::string printable(std::string_view text, std::size_t limit) {
  std::string out;
  bool escape = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!continues_character(text[i])) {
      if (i >= limit) return out + fmt::format("... ({} characters)", text.size());
      escape = starts_control(text.substr(i));
    }
    if (escape) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
    } else {
      out += text[i];
    }
    if (i >= limit + 4) return out + fmt::format("... ({} characters)", text.size());  // no valid UTF-8
  }
  return out;
}

}  // namespace bumpfoil
