// Output of the program: on closed or full streams, and for texts with terminal control sequences.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::TemporaryFolder;

struct ShellOutcome {
  int exit_code{};  ///< 128 and the signal where one ended the program
  std::string output, errors;
};

/// A folder with a case file, in which a shell runs scripts; `$bumpfoil` in them is the program.
class Output : public ::testing::Test {
 protected:
  Output() {
    setenv("bumpfoil", std::filesystem::absolute(BUMPFOIL_PROGRAM).c_str(), 1);
    EXPECT_EQ(run("$bumpfoil init -o case.toml").exit_code, 0);
  }

  [[nodiscard]] ShellOutcome run(const std::string& script) const {
    const std::string command = "cd '" + folder_.path().string() + "' && { " + script + "; } > output 2> errors";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), folder_.read("output"), folder_.read("errors")};
  }

  TemporaryFolder folder_;
};

TEST_F(Output, AnUnwritableStandardErrorChangesNoExitCode) {
  for (const std::string closed : {" 2>&-", " 2> /dev/full"}) {
    SCOPED_TRACE(closed);
    EXPECT_EQ(run("$bumpfoil check missing.toml" + closed).exit_code, 4);
    EXPECT_EQ(run("$bumpfoil bogus" + closed).exit_code, 2);
    EXPECT_EQ(run("$bumpfoil cycle" + closed).exit_code, 2);
    EXPECT_EQ(run("$bumpfoil check case.toml --set friction.coefficient=-1" + closed).exit_code, 2);
    // Done, with warnings.
    const std::string yields = "$bumpfoil strip case.toml --force -o r --set strip.bumps=3 --set strip.steps=4";
    EXPECT_EQ(run(yields + " --set 'strip.load=50 N' --set 'bump_foil.yield_stress=1 MPa'" + closed).exit_code, 0);
    EXPECT_EQ(run(yields + " --set 'strip.load=1 MN'" + closed).exit_code, 3);
  }
}

TEST_F(Output, AnUnwritableStandardOutputIsTold) {
  for (const std::string closed : {" >&-", " > /dev/full"}) {
    for (const std::string command : {"--help", "--version", "cycle --help", "init", "check case.toml",
                                      "properties case.toml", "cycle case.toml -o r --force --set cycle.steps=2"}) {
      SCOPED_TRACE(command + closed);
      const ShellOutcome outcome = run("$bumpfoil " + command + closed);
      EXPECT_EQ(outcome.exit_code, 4);
      EXPECT_NE(outcome.errors.find("standard output: cannot be written"), std::string::npos) << outcome.errors;
      EXPECT_EQ(run("$bumpfoil " + command + closed + " 2>&-").exit_code, 4);
    }
  }
  EXPECT_EQ(run("$bumpfoil check case.toml --quiet > /dev/full").exit_code, 0);
}

TEST_F(Output, NothingIsPrintedIntoAResult) {
  // The first opened file must not become the standard error.
  EXPECT_EQ(run("$bumpfoil strip case.toml -o r --set strip.bumps=3 --set strip.steps=4 --set 'strip.load=50 N' "
                "--set 'bump_foil.yield_stress=1 MPa' <&- >&- 2>&-")
                .exit_code,
            4);
  EXPECT_TRUE(nlohmann::json::accept(folder_.read("r/summary.json")));
  EXPECT_TRUE(folder_.read("r/strip.csv").starts_with("cycle,increment,"));
}

/// Whether a terminal shows the text literally: no control characters except line ends, no C1, no change of direction,
/// no invalid UTF-8. Independent of the program's own function.
bool is_tame(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte < 0x20 && byte != '\n') || byte == 0x7f || byte == 0xff) return false;
    if (byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0) return false;
  }
  return text.find("\xe2\x80\xae") == std::string_view::npos;
}

TEST_F(Output, TextsOfOthersDoNotSteerTheTerminal) {
  const std::string hostile = "x\x1b]0;owned\x07\x1b[2J\x9b 31m\xc2\x9b 31m\xe2\x80\xae\x7f\n\xff";
  setenv("hostile", hostile.c_str(), 1);
  setenv("utf8", "x\x1b]0;owned\x07\x1b[2J\xc2\x9b 31m\xe2\x80\xae\x7f\n", 1);
  // TOML holds valid UTF-8, and control characters by their numbers alone.
  folder_.write("title.toml", "title = \"x\\u001b[2J \\u009b31m \\u202e \xc2\x9b \xe2\x80\xae\"\n" +
                                  folder_.read("case.toml").substr(folder_.read("case.toml").find("\n[bearing]")));
  folder_.write("key.toml", folder_.read("case.toml") + "\n\"\\u001b[2J\xe2\x80\xae\" = 1\n");
  folder_.write("unit.toml", folder_.read("case.toml") + "\n[bump_foil.truss]\nk1 = \"1 \xc2\x9b[2J\"\n");
  folder_.write("bytes.toml", "title = \"\x1b[2J\xff\"\n");
  const std::string quick = " --set cycle.steps=2 --set 'cycle.directions=[0.0]'";
  struct Script {
    std::string text;
    int exit_code;
  };
  for (const auto& [text, exit_code] : std::vector<Script>{
           {"$bumpfoil check title.toml", 0},
           {"$bumpfoil properties title.toml", 0},
           {"$bumpfoil properties title.toml --json", 0},
           {"$bumpfoil cycle title.toml -o \"$hostile\"" + quick, 0},
           {"$bumpfoil cycle title.toml -o \"$hostile\"" + quick, 4},  // contains results
           {"$bumpfoil init -o \"$hostile.toml\"", 0},
           {"$bumpfoil init -o \"$hostile.toml\"", 4},
           {"$bumpfoil init --preset \"$hostile\"", 2},
           {"$bumpfoil check \"$hostile.toml\" --set \"$hostile\"", 2},
           {"$bumpfoil check \"no$hostile\"", 4},
           {"$bumpfoil check key.toml", 2},
           {"$bumpfoil check unit.toml", 2},
           {"$bumpfoil check bytes.toml", 2},
           {"$bumpfoil check case.toml --set \"$hostile=1\"", 2},
           {"$bumpfoil check case.toml --set \"friction.$hostile=1\"", 2},
           {"$bumpfoil check case.toml --set \"bearing.radius=$hostile\"", 2},
           {"$bumpfoil check case.toml --set \"bearing.radius=1 $hostile\"", 2},
           {"$bumpfoil check case.toml --set \"bearing.radius=1 mm$hostile\"", 2},
           {"$bumpfoil check case.toml --set \"solver.name=$hostile\"", 2},
           {"$bumpfoil check case.toml --set \"cycle.directions=['$hostile']\"", 2},
           {"$bumpfoil check case.toml --set \"title.$hostile=1\"", 2},
           {"$bumpfoil check case.toml --set \"bump_foil.height_errors_file=$hostile.csv\"", 2},
           {"$bumpfoil check case.toml --set \"bump_foil.height_errors_file=$utf8.csv\"", 4},
           {"printf 'bump,height_error_m\\n1,%s\\n' \"$hostile\" > \"$utf8.csv\";"
            "$bumpfoil check case.toml --set \"bump_foil.height_errors_file=$utf8.csv\"",
            2},
           {"$bumpfoil \"$hostile\"", 2},
           {"$bumpfoil check case.toml \"--$hostile\"", 2},
           {"$bumpfoil check case.toml \"$hostile\"", 2},
           {"$bumpfoil reproduce -o r --study \"$hostile\"", 2},
           {"$bumpfoil reproduce -o r --figure \"$hostile\"", 2},
           {"$bumpfoil report \"no$hostile\"", 4},
       }) {
    SCOPED_TRACE(text);
    const ShellOutcome outcome = run(text);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.errors;
    EXPECT_TRUE(is_tame(outcome.output)) << outcome.output;
    EXPECT_TRUE(is_tame(outcome.errors)) << outcome.errors;
  }
  // What `check` prints is still a case with the same title.
  const ShellOutcome check = run("$bumpfoil check title.toml");
  folder_.write("again.toml", check.output);
  EXPECT_NE(check.output.find("title = \"x\\u001b[2J \\u009b31m \\u202e \\u009b \\u202e\""), std::string::npos)
      << check.output.substr(0, 200);
  EXPECT_EQ(run("$bumpfoil check again.toml").output, check.output);
}

#if BUMPFOIL_HAS_REPORT
TEST_F(Output, DamagedResultsAreToldUnlessTheyAreWanted) {
  ASSERT_EQ(run("$bumpfoil cycle case.toml -o r --set cycle.steps=2 --quiet").exit_code, 0);
  ASSERT_EQ(run("sed -i 's/\"bytes\": /&1/' r/summary.json").exit_code, 0);
  const ShellOutcome report = run("$bumpfoil report r");
  EXPECT_EQ(report.exit_code, 4);
  EXPECT_EQ(report.errors.find("r/summary.json: is damaged: "), 0U) << report.errors;
  EXPECT_EQ(run("$bumpfoil report r --unchecked").exit_code, 0);
  ASSERT_EQ(run("echo null > r/summary.json").exit_code, 0);
  EXPECT_EQ(run("$bumpfoil report r --unchecked --force").exit_code, 4);
}
#endif

}  // namespace
}  // namespace bumpfoil
