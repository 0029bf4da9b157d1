#include "output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"

namespace bumpfoil {
namespace {

/// Number of similar messages that are printed.
constexpr std::size_t most_messages = 5;

bool print(std::FILE* stream, const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
}

}  // namespace

void hold_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Takes the lowest free descriptor. Opened for reading, so that printing still fails.
    if (::fcntl(stream, F_GETFD) == -1) static_cast<void>(::open("/dev/null", O_RDONLY));
  }
}

void print_output(std::string_view text) {
  if (!print(stdout, printable_lines(text))) {
    throw Error(ErrorKind::file,
                {{"standard output", 0, "", "", "cannot be written: " + std::generic_category().message(errno), ""}});
  }
}

void print_message(std::string_view line) noexcept {
  try {
    print(stderr, printable_lines(line) + '\n');
  } catch (const std::exception&) {
    // Out of memory for a copy: nothing can be reported.
  }
}

void print_some(std::string_view prefix, const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < std::min(lines.size(), most_messages); ++i) {
    print_message(fmt::format("{}{}", prefix, lines[i]));
  }
  if (lines.size() > most_messages) {
    print_message(fmt::format("{}and {} more, all in summary.json", prefix, lines.size() - most_messages));
  }
}

}  // namespace bumpfoil
