// Messages of the program about invalid command lines.

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "cli/running_program.hpp"

namespace bumpfoil {
namespace {

void expect_says(const std::vector<std::string>& arguments, const std::string& words) {
  const ProgramOutcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
}

TEST_F(Program, BlamesTheOptionThatWasTyped) {
  const ProgramOutcome outcome = run(cycle_ + std::vector<std::string>{"--solver", "newtn"});
  EXPECT_NE(outcome.errors.find("--solver"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("newton"), std::string::npos);
  EXPECT_EQ(outcome.errors.find("--set"), std::string::npos);
}

TEST_F(Program, NamesTheWordThatIsNoCommand) {
  const ProgramOutcome outcome = run({"cyle", "case.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("unknown command 'cyle'; did you mean 'cycle'?"), std::string::npos) << outcome.errors;
  EXPECT_EQ(run({"frobnicate"}).errors.find("did you mean"), std::string::npos);
}

TEST_F(Program, NamesTheOptionThatIsNone) {
  expect_says({"cycle", case_path_, "-o", results_, "--sovler", "newton"},
              "bumpfoil: unknown option '--sovler' of 'cycle'; did you mean '--solver'?");
  expect_says({"cycle", case_path_, "-o", results_, "--forse"}, "did you mean '--force'?");
  // A missing argument may be a misspelt one.
  expect_says({"cycle", case_path_, "--ouput=y"}, "unknown option '--ouput' of 'cycle'; did you mean '--output'?");
  expect_says({"--versoin"}, "unknown option '--versoin'; did you mean '--version'? 'bumpfoil --help' lists them");
  expect_says({"-v"}, "unknown option '-v'; did you mean '-V/--version'? 'bumpfoil --help' lists them");
  expect_says({"-x"}, "unknown option '-x'; 'bumpfoil --help' lists them");
  expect_says({"---"}, "unknown option '---'; 'bumpfoil --help' lists them");
  expect_says({"check", case_path_, "b"}, "unexpected argument 'b' of 'check'");
}

TEST_F(Program, GuessesOptionsFromTheirBeginning) {
  const auto cycle = [&](const std::string& option) { return std::vector<std::string>{"cycle", case_path_, option}; };
  expect_says(cycle("-O"), "unknown option '-O' of 'cycle'; did you mean '-o/--output'?");
  expect_says(cycle("-q"), "did you mean '--quiet'?");
  expect_says(cycle("-H"), "did you mean '-h/--help'?");
  expect_says(cycle("--s=newton"), "unknown option '--s' of 'cycle'; did you mean '--sample', '--set' or '--solver'?");
  expect_says({"montecarlo", case_path_, "--thr", "2"}, "did you mean '--threads'?");
  expect_says({"cycle", case_path_, "-output", results_}, "-output: unknown option; did you mean -o or --output?");
}

/// Names of the options that a text of help lists, "--output".
std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> names;
  const std::regex name("\n +(?:-[A-Za-z],)?(--[a-z-]+)");
  for (std::sregex_iterator found(help.begin(), help.end(), name), end; found != end; ++found) {
    names.insert((*found)[1]);
  }
  return names;
}

TEST_F(Program, KnowsTheSlipsOfAllOptionsOfAllCommands) {
  const std::string help = run({"--help"}).output;
  const std::size_t list = help.find("Subcommands:");
  const std::string commands = help.substr(list, help.find("\n\n", list) - list);
  const std::regex name("\n  ([a-z]+)");
  std::size_t options = 0;
  for (std::sregex_iterator found(commands.begin(), commands.end(), name), end; found != end; ++found) {
    const std::string command = (*found)[1];
    for (const std::string& option : options_in(run({command, "--help"}).output)) {
      SCOPED_TRACE(command);
      std::string slip = option;
      if (slip.size() > 4) std::swap(slip[3], slip[4]);
      if (slip == option) slip.append(1, slip.back());
      expect_says({command, slip},
                  "unknown option '" + slip + "' of '" + command + "'; did you mean '" + option + "'?");
      ++options;
    }
  }
  EXPECT_GE(options, 60U);
}

TEST_F(Program, TakesASolverWhereverCasesAreRun) {
  const std::vector<std::string> swept{
      "sweep", case_path_,      "-o",       results_, "--over", "friction.coefficient=[0.1]",
      "--set", "cycle.steps=2", "--solver", "events"};
  EXPECT_EQ(run(swept).exit_code, 0);
  EXPECT_EQ(summary()["solver"], "events");
  expect_says({"montecarlo", case_path_, "-o", results_, "--solver", "newtn"}, "did you mean 'newton'?");
}

TEST_F(Program, SaysWhatIsMissingInOneLine) {
  expect_says({}, "bumpfoil: a command is missing; see 'bumpfoil --help'\n");
  expect_says({"cycle", case_path_}, "bumpfoil: --output is missing; see 'bumpfoil cycle --help'\n");
  expect_says({"check"}, "bumpfoil: CASE is missing; see 'bumpfoil check --help'\n");
  expect_says({"cycle", case_path_, "-o"}, "bumpfoil: --output is missing its value, DIR; see 'bumpfoil cycle --help'");
  expect_says({"cycle", case_path_, "-o", results_, "--set", "friction.coefficient", "=", "0.2"},
              "bumpfoil: '=' is incomplete; write --set KEY=VALUE without spaces");
}

TEST_F(Program, NamesTheWordsThatAValueMayBe) {
  expect_says({"init", "--preset", "gen3"},
              "--preset: unknown value 'gen3'; did you mean 'gen3-three-pad'? see 'bumpfoil");
  expect_says({"init", "--preset", "gne1"}, "did you mean 'gen1'?");
  expect_says({"cycle", case_path_, "-o", results_, "--solver", "secant"},
              "--solver: 'secant' is not one of newton, uzawa, events; see 'bumpfoil cycle --help'");
  expect_says({"reproduce", "-o", results_, "--figure", "9"}, "--figure: '9' is not one of 10, 11, 12, 13, 14, 15, 16");
}

TEST_F(Program, HelpsWithCommandsThatThereAre) {
  expect_says({"help", "cylce"}, "unknown command 'cylce'; did you mean 'cycle'?");
  expect_says({"cylce", "--help"}, "unknown command 'cylce'");
  expect_says({"help", "cycle", "extra"}, "help = extra: is an unexpected argument; ask about one command");
}

TEST_F(Program, BlamesTheShorthandNotTheKeyBehindIt) {
  const auto montecarlo = [&](const std::vector<std::string>& options) {
    return std::vector<std::string>{"montecarlo", case_path_, "-o", results_} + options;
  };
  expect_says(montecarlo({"--samples", "0"}), "--samples = 0: is not a valid number of samples");
  expect_says(montecarlo({"--samples", "abc"}), "--samples = abc: is not a whole number");
  expect_says(montecarlo({"--seed", "-1"}), "--seed = -1: must not be negative");
  expect_says(montecarlo({"--target-error", "0"}), "--target-error: must be a positive number, not '0'");
  // The file lacks it, whatever else was said of the ensemble.
  expect_says(montecarlo({"--samples", "5"}), case_path_ + ": montecarlo: nothing scatters");
}

}  // namespace
}  // namespace bumpfoil
