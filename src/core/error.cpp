#include "bumpfoil/core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace bumpfoil {
namespace {

/// Longest part of a user's value that is echoed.
constexpr std::size_t echo_limit = 80;

std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i >= echo_limit) {
      out += fmt::format("... ({} characters)", text.size());
      break;
    }
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += text[i];
    }
  }
  return out;
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
    out += printable(fault.file);
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

}  // namespace bumpfoil
