#include "command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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
#include "output.hpp"
#include "ranks.hpp"

namespace bumpfoil {

namespace {

/// A parser message, reworded like our other messages.
std::string in_our_words(std::string_view message) {
  constexpr std::string_view required = " is required";
  constexpr std::string_view one = ": 1 required ";
  constexpr std::string_view missing = " missing";
  if (message == "A subcommand is required") return "a command is missing";
  if (message.ends_with(required)) {
    message.remove_suffix(required.size());
    return fmt::format("{} is missing", message);
  }
  const std::size_t at = message.find(one);
  if (at == std::string_view::npos || !message.ends_with(missing)) return std::string(message);
  message.remove_suffix(missing.size());
  return fmt::format("{} is missing its value, {}", message.substr(0, at), message.substr(at + one.size()));
}

/// Prints the requested help, or the error in the command line.
ExitCode answer(const CLI::App& program, const CLI::ParseError& error) {
  std::ostringstream output;
  std::ostringstream errors;
  if (program.exit(error, output, errors) == 0) {
    print_output(output.str());
    return ExitCode::done;
  }
  const std::string message = in_our_words(error.what());
  const auto commands = program.get_subcommands();
  print_message(fmt::format("bumpfoil: {}{} see 'bumpfoil {}--help'", message, message.ends_with('?') ? "" : ";",
                            commands.empty() ? "" : commands.front()->get_name() + ' '));
  return ExitCode::wrong_input;
}

/// "did you mean 'a', 'b' or 'c'? " with these names; empty without any.
std::string suggestion(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view between = i == 0 ? "" : i + 1 < names.size() ? ", " : " or ";
    text += fmt::format("{}'{}'", between, names[i]);
  }
  return text.empty() ? text : fmt::format("did you mean {}? ", text);
}

std::vector<std::string> nearest_of(std::string_view word, const std::vector<std::string>& names) {
  const std::optional<std::string> nearest = nearest_name(word, names);
  return nearest ? std::vector{*nearest} : std::vector<std::string>{};
}

/// Options of a command, and those of the program, which all commands accept.
std::vector<const CLI::Option*> options_of(const CLI::App& program, const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  const std::vector<const CLI::Option*> common = program.get_options();
  if (&command != &program) options.insert(options.end(), common.begin(), common.end());
  return options;
}

/// Options similar to an unknown word: the letter in the other case, names with the same start, or the nearest one.
std::vector<std::string> options_like(const std::string& word, const std::vector<const CLI::Option*>& options) {
  const std::string letters = word.substr(std::min(word.find_first_not_of('-'), word.size()));
  if (letters.empty()) return {};
  std::vector<std::string> names;
  std::vector<std::string> longer;
  for (const CLI::Option* option : options) {
    for (const std::string& letter : option->get_snames()) {
      const bool same = letters.size() == 1 && std::tolower(static_cast<unsigned char>(letter.front())) ==
                                                   std::tolower(static_cast<unsigned char>(letters.front()));
      if (same) return {fmt::format("-{}/--{}", letter, option->get_lnames().front())};
    }
    for (const std::string& name : option->get_lnames()) {
      if (std::find(names.begin(), names.end(), "--" + name) != names.end()) continue;  // --help of the program
      names.push_back("--" + name);
      if (name.starts_with(letters)) longer.push_back(names.back());
    }
  }
  return longer.empty() ? nearest_of(word, names) : longer;
}

/// Reports unknown words of the command line: unknown commands or options, and excess arguments.
/// @return whether there are any
bool tell_unknown_words(const CLI::App& program) {
  const std::vector<std::string> words = program.remaining();
  if (words.empty()) return false;
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word.front() == '-' && word != "--"; };
  // A word after an unknown option may be its value.
  if (const auto found = std::find_if(words.begin(), words.end(), is_option); found != words.end()) {
    const auto commands = program.get_subcommands();
    const CLI::App& command = commands.empty() ? program : *commands.front();
    const std::string option = found->substr(0, found->find('='));
    print_message(fmt::format("bumpfoil: unknown option '{}'{}; {}'bumpfoil {}--help' lists them", printable(option),
                              commands.empty() ? "" : fmt::format(" of '{}'", command.get_name()),
                              suggestion(options_like(option, options_of(program, command))),
                              commands.empty() ? "" : command.get_name() + ' '));
  } else if (program.get_subcommands().empty()) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
    print_message(fmt::format("bumpfoil: unknown command '{}'; {}'bumpfoil --help' lists them",
                              printable(words.front()), suggestion(nearest_of(words.front(), names))));
  } else {
    const std::string& command = program.get_subcommands().front()->get_name();
    if (words.front().starts_with('=')) {
      print_message(
          fmt::format("bumpfoil: '{}' is incomplete; write --set KEY=VALUE without spaces around the =, in quotes if "
                      "the value has any",
                      printable(words.front())));
      return true;
    }
    print_message(fmt::format("bumpfoil: unexpected argument '{}' of '{}'; see 'bumpfoil {} --help'",
                              printable(words.front()), command, command));
  }
  return true;
}

/// Whether a word sets a key of a table: --set takes all following words, but not file names.
bool is_override(std::string_view word) {
  const std::string_view key = word.substr(0, word.find('='));
  return key.size() < word.size() && key.find('.') != std::string_view::npos &&
         key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.[]") == std::string_view::npos;
}

/// The words of the command line in parser form: one --set per change, and --help for help.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    if (words.size() > 2) {
      throw Error(ErrorKind::input, {{"", 0, "help", words[2], "is an unexpected argument",
                                      "ask about one command: bumpfoil help " + words[1]}});
    }
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  for (const std::string& word : words) {
    // The parser would read it as -o utput.
    if (word != "-output" && !word.starts_with("-output=")) continue;
    throw Error(ErrorKind::input, {{"", 0, "-output", "", "unknown option", "did you mean -o or --output?"}});
  }
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i - 2] == "--set" && is_override(words[i - 1]) && is_override(words[i])) {
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i), "--set");
      ++i;
    }
  }
  return words;
}

/// Quotes a word for a POSIX shell.
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

}  // namespace

ExitCode run_command_line(int argc, char** argv, const Ranks& ranks) {
  Session session{.ranks = ranks, .command_line = command_line(argc, argv)};
  CLI::App program;
  describe_program(program, session);
  program.parse_complete_callback([&] {
    if (ranks.size() == 1) return;
    std::vector<std::string> names;
    for (const SharedCommand& one : shared_commands()) {
      if (program.got_subcommand(one.name)) return;
      names.push_back(fmt::format("'{}'", one.name));
    }
    throw Error(ErrorKind::input, {{"", 0, "mpirun -n", std::to_string(ranks.size()),
                                    fmt::format("only {} support several ranks", fmt::join(names, " and ")),
                                    "start this command without mpirun"}});
  });
  try {
    std::vector<std::string> words = words_of(argc, argv);
    std::reverse(words.begin(), words.end());  // as required by CLI11
    program.parse(std::move(words));
  } catch (const CLI::CallForHelp& call) {
    // Without a command, the parser would print the help of the program.
    if (program.get_subcommands().empty() && tell_unknown_words(program)) return ExitCode::wrong_input;
    return answer(program, call);
  } catch (const CLI::ParseError& error) {
    // Reported before missing arguments: a typing error may be the cause.
    const bool is_answer = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
    if (!is_answer && tell_unknown_words(program)) return ExitCode::wrong_input;
    return answer(program, error);
  }
  return session.exit_code;
}

}  // namespace bumpfoil
