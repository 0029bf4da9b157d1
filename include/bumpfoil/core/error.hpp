#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/printable.hpp"

namespace bumpfoil {

/// One entry of an Error: where it is, the value found, what to change.
struct InputError {
  std::string file;    ///< empty when the case was built in memory
  std::size_t line{};  ///< 1-based; 0 when unknown
  std::string key;     ///< dotted key of the case file, such as "bump_foil.height"; empty when it has none
  std::string value;   ///< the value found, as written; empty when the key is missing
  std::string what;    ///< what is wrong
  std::string advice;  ///< what to change
};

/// Who can fix it: decides the exit code of the program.
enum class ErrorKind {
  input,  ///< the case or the command line is wrong (exit code 2)
  file,   ///< a file cannot be read or written (exit code 4)
};

/// The one exception type of the library: bad input, files, a model that cannot be built. It lists every error at once.
/// Numerical failures are never thrown; they are reported in results.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::vector<InputError> errors);

  [[nodiscard]] ErrorKind kind() const { return kind_; }
  [[nodiscard]] const std::vector<InputError>& errors() const { return errors_; }

 private:
  ErrorKind kind_;
  std::vector<InputError> errors_;
};

/// One line for one error: `file:line: key = value: what; advice`, leaving out what is unknown. All of it is
/// `printable` and long values are shortened, so that the line is safe to print whatever it quotes.
std::string format_error(const InputError& error);

}  // namespace bumpfoil
