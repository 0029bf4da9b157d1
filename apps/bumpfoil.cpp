#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/nearest_name.hpp"
#include "bumpfoil/core/printable.hpp"
#include "commands.hpp"
#include "ensemble_ranks.hpp"
#include "output.hpp"
#include "ranks.hpp"

namespace bumpfoil {

namespace {

/// Prints the help that was asked for, or what is wrong with the command line.
ExitCode answer(const CLI::App& program, const CLI::ParseError& error) {
  std::ostringstream output;
  std::ostringstream errors;
  const int code = program.exit(error, output, errors);
  print_output(output.str());
  std::string message = errors.str();
  while (message.ends_with('\n')) message.pop_back();
  if (!message.empty()) print_message(message);
  return code == 0 ? ExitCode::done : ExitCode::wrong_input;
}

/// Whether a word changes a key of a table: --set takes as many as follow one another, and no names of files.
bool is_override(std::string_view word) {
  const std::string_view key = word.substr(0, word.find('='));
  return key.size() < word.size() && key.find('.') != std::string_view::npos &&
         std::all_of(key.begin(), key.end(),
                     [](char c) { return std::islower(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; });
}

/// The words of the command line as the parser takes them: one --set for each change, and --help for help.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i - 2] == "--set" && is_override(words[i - 1]) && is_override(words[i])) {
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i), "--set");
      ++i;
    }
  }
  return words;
}

/// One word for a POSIX shell.
std::string quoted(std::string_view word) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_./=+,:@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return std::string(word);
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + '\'';
}

std::string command_line(int argc, char** argv) {
  std::string out = "bumpfoil";
  for (int i = 1; i < argc; ++i) out += ' ' + quoted(argv[i]);
  return out;
}

/// The only command that several ranks have work for.
constexpr const char* command_for_ranks = "montecarlo";

ExitCode run(int argc, char** argv, const Ranks& ranks) {
  Session session{.ranks = ranks, .command_line = command_line(argc, argv)};
  CLI::App program;
  describe_program(program, session);
  program.parse_complete_callback([&] {
    if (ranks.size() == 1 || program.got_subcommand(command_for_ranks)) return;
    throw Error(ErrorKind::input, {{"", 0, "mpirun -n", std::to_string(ranks.size()),
                                    fmt::format("only '{}' has work for several ranks", command_for_ranks),
                                    "start this command without mpirun"}});
  });
  try {
    std::vector<std::string> words = words_of(argc, argv);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    program.parse(std::move(words));
  } catch (const CLI::RequiredError& error) {
    if (program.get_subcommands().empty() && program.remaining_size() > 0) {
      const std::string word = program.remaining().front();
      std::vector<std::string> names;
      for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
      const std::optional<std::string> nearest = nearest_name(word, names);
      print_message(fmt::format("bumpfoil: '{}' is no command; {}'bumpfoil --help' lists them", printable(word),
                                nearest ? fmt::format("did you mean '{}'? ", *nearest) : ""));
      return ExitCode::wrong_input;
    }
    return answer(program, error);
  } catch (const CLI::ParseError& error) {
    return answer(program, error);
  }
  return session.exit_code;
}

/// Ends the program after a failure, without the exit handler of HDF5: it crashes where the memory did not suffice.
[[noreturn]] void leave(ExitCode code) {
  std::fflush(nullptr);
  std::_Exit(static_cast<int>(code));
}

}  // namespace
}  // namespace bumpfoil

int main(int argc, char** argv) {
  using namespace bumpfoil;
  hold_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit of file sizes fails the write, which is told
  try {
    const Ranks ranks;
    if (ranks.rank() > 0) {
      help(ranks);
      return static_cast<int>(ExitCode::done);
    }
    const Dismissal dismissal(ranks);
    return static_cast<int>(run(argc, argv, ranks));
  } catch (const Error& error) {
    print_message(error.what());
    leave(error.kind() == ErrorKind::file ? ExitCode::file_error : ExitCode::wrong_input);
  } catch (const std::bad_alloc&) {
    print_message("bumpfoil: the memory does not suffice for this case");
    leave(ExitCode::wrong_input);
  } catch (const std::exception& error) {
    print_message(std::string("bumpfoil: ") + error.what());
    leave(ExitCode::file_error);
  }
}
