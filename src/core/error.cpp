#include "bumpfoil/core/error.hpp"

#include <fmt/format.h>

#include <utility>

#include "bumpfoil/core/printable.hpp"

namespace bumpfoil {
namespace {

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
  out += printable(fault.what, fault.what.size());
  if (!fault.advice.empty()) out += "; " + printable(fault.advice, fault.advice.size());
  return out;
}

}  // namespace bumpfoil
