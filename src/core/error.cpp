#include "bumpfoil/core/error.hpp"

#include <fmt/format.h>

#include <utility>

#include "bumpfoil/core/printable.hpp"

namespace bumpfoil {
namespace {

std::string join(const std::vector<InputError>& errors) {
  std::string out;
  for (const InputError& error : errors) {
    if (!out.empty()) out += '\n';
    out += format_error(error);
  }
  return out;
}

}  // namespace

Error::Error(ErrorKind kind, std::vector<InputError> errors)
    : std::runtime_error(join(errors)), kind_(kind), errors_(std::move(errors)) {}

std::string format_error(const InputError& error) {
  std::string out;
  if (!error.file.empty()) {
    out += printable(error.file, longest_path);
    if (error.line > 0) out += fmt::format(":{}", error.line);
    out += ": ";
  }
  if (!error.key.empty()) {
    out += printable(error.key);
    if (!error.value.empty()) out += " = " + printable(error.value);
    out += ": ";
  }
  out += printable(error.what, error.what.size());
  if (!error.advice.empty()) out += "; " + printable(error.advice, error.advice.size());
  return out;
}

}  // namespace bumpfoil
