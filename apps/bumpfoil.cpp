#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "bumpfoil/core/error.hpp"
#include "command_line.hpp"
#include "output.hpp"
#include "ranks.hpp"
#include "shared_runs.hpp"

namespace bumpfoil {
namespace {

/// Ends the program after a failure without the exit handler of HDF5, which crashes when out of memory.
[[noreturn]] void leave(ExitCode code) {
  std::fflush(nullptr);
  std::_Exit(static_cast<int>(code));
}

}  // namespace
}  // namespace bumpfoil

int main(int argc, char** argv) {
  using namespace bumpfoil;
  hold_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // at a file-size limit, writing then fails and is reported
  try {
    const Ranks ranks;
    if (ranks.rank() > 0) {
      help(ranks, shared_commands());
      return static_cast<int>(ExitCode::done);
    }
    const Dismissal dismissal(ranks);
    return static_cast<int>(run_command_line(argc, argv, ranks));
  } catch (const Error& error) {
    print_message(error.what());
    leave(error.kind() == ErrorKind::file ? ExitCode::file_error : ExitCode::wrong_input);
  } catch (const std::bad_alloc&) {
    print_message("bumpfoil: not enough memory for this case");
    leave(ExitCode::wrong_input);
  } catch (const std::exception& error) {
    print_message(std::string("bumpfoil: ") + error.what());
    leave(ExitCode::file_error);
  }
}
