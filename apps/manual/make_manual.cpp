// Generates files from the description of the command line: bumpfoil.1 for man, and completions for bash.
// Usage: make_manual FOLDER

#include <exception>
#include <filesystem>

#include "bumpfoil/results/write_file.hpp"
#include "commands.hpp"
#include "manual/manual.hpp"
#include "output.hpp"

int main(int argc, char** argv) {
  using namespace bumpfoil;
  if (argc != 2) return static_cast<int>(ExitCode::wrong_input);
  try {
    const Ranks ranks;
    Session session{.ranks = ranks, .command_line = {}};
    CLI::App program;
    describe_program(program, session);
    const std::filesystem::path folder(argv[1]);
    write_file(folder / "bumpfoil.1", man_page(program), Existing::replace);
    write_file(folder / "bumpfoil.bash", bash_completion(program), Existing::replace);
    return static_cast<int>(ExitCode::done);
  } catch (const std::exception& error) {
    print_message(error.what());
    return static_cast<int>(ExitCode::file_error);
  }
}
