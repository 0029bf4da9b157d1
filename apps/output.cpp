#include "output.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

void print_output(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) {
    throw Error(ErrorKind::file,
                {{"standard output", 0, "", "", "cannot be written: " + std::generic_category().message(errno), ""}});
  }
}

}  // namespace bumpfoil
