// Files of a run that is killed, interrupted, started twice or out of space: always a complete set of one run.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "bumpfoil/experiments/experiments.hpp"
#include "cli/run_in_shell.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;
using test_support::RunInShell;
using test_support::running_commands;
using test_support::small_run_of;

constexpr const char* set = "cycle.csv result.nc summary.json ";
const std::string cycle = "$bumpfoil cycle case.toml --quiet --set cycle.steps=4 ";

TEST_F(RunInShell, TakesEveryNameOfAFolder) {
  for (const std::string name : {" x", "back\\slash", "C:/x", "http://x"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(run(cycle + "-o '" + name + "'"), 0) << log();
    EXPECT_EQ(listing(name), set);
  }
}

TEST_F(RunInShell, ALimitOfFileSizesIsAnErrorOfTheFile) {
  for (const std::string before : {"", "trap '' XFSZ; "}) {
    EXPECT_EQ(run(before + "ulimit -f 100; $bumpfoil cycle case.toml -o full"), 4) << log();
    EXPECT_NE(log().find("full/cycle.csv: cannot be written: File too large"), std::string::npos) << log();
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "full"));
  }
  // Existing files are kept.
  EXPECT_EQ(run(cycle + "-o full"), 0);
  const json before = consistent_summary("full");
  EXPECT_EQ(run("ulimit -f 100; $bumpfoil cycle case.toml -o full --force"), 4);
  EXPECT_EQ(consistent_summary("full"), before);
  EXPECT_EQ(listing("full"), set);
}

/// All commands that write, without the name of their output.
std::vector<std::string> writing_commands() {
  std::vector<std::string> commands = running_commands();
  for (const std::string command : {"init", "reproduce --figure 16", "export base --to vtk"}) {
    commands.push_back("$bumpfoil " + command);
  }
  if (BUMPFOIL_HAS_DESIGNER) commands.emplace_back("$bumpfoil designer");
  if (BUMPFOIL_HAS_REPORT) commands.emplace_back("$bumpfoil report base");
  return commands;
}

/// Without home, terminal or input, in a locale with decimal commas or without a locale, and with names that contain
/// blanks and non-ASCII letters, all works as usual. Existing files are kept; if nothing can be written, the message
/// says so and no files remain.
TEST_F(RunInShell, EveryCommandThatWritesReportsTheErrorsOfItsMachine) {
  ASSERT_EQ(run(cycle + "-o base"), 0);
  for (const std::string& command : writing_commands()) {
    SCOPED_TRACE(command);
    const std::string whole = "env -i LC_ALL=de_DE.UTF-8 " + command + " --quiet -o 'a b \xc3\xa4' < /dev/null";
    EXPECT_EQ(run(whole), 0) << log();
    const std::filesystem::path written = folder_.path() / "a b \xc3\xa4";
    EXPECT_TRUE(std::filesystem::exists(written));
    EXPECT_EQ(run(whole), 4);
    EXPECT_NE(log().find("already"), std::string::npos) << log();
    std::filesystem::remove_all(written);

    for (const std::string place : {"case.toml/x", "/proc/x"}) {
      EXPECT_EQ(run(command + " --quiet -o " + place), 4);
      EXPECT_TRUE(log().starts_with(place) && log().find("cannot be written") != std::string::npos) << log();
    }
    EXPECT_EQ(run("ulimit -f 1; " + command + " --quiet -o full"), 4);
    EXPECT_EQ(log().find("full"), 0U) << log();
    EXPECT_TRUE(log().find("File too large") != std::string::npos || log().find("ulimit -f") != std::string::npos)
        << log();
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "full/summary.json"));
    std::filesystem::remove_all(folder_.path() / "full");
  }
}

TEST_F(RunInShell, EveryRunWithoutTimesWritesTheSameBytesAgain) {
  std::vector<std::string> commands = running_commands();
  commands.emplace_back("$bumpfoil reproduce --figure 16");
  for (const std::string& command : commands) {
    SCOPED_TRACE(command);
    for (const std::string folder : {"one", "two"}) {
      EXPECT_EQ(run(command + " --no-times --quiet -o " + folder), 0) << log();
    }
    EXPECT_EQ(run("diff -r one two"), 0) << log();
    EXPECT_EQ(run("grep -rq 'date_created\\|wall_time\\|command_line' one"), 1);
    EXPECT_EQ(run(command + " --quiet -o timed && grep -rq date_created timed && rm -r one two timed"), 0) << log();
  }
}

/// Mounts in a separate name space: a full disk, and a read-only one.
TEST_F(RunInShell, EveryCommandThatWritesTellsOfAFullAndOfAReadOnlyDisk) {
  if (run("unshare -r -m true") != 0) GTEST_SKIP() << "name spaces of users are not permitted here";
  ASSERT_EQ(run(cycle + "-o base && mkdir full shut && cp -r base shut"), 0);
  for (const std::string& command : writing_commands()) {
    SCOPED_TRACE(command);
    folder_.write("script", "mount -t tmpfs -o size=4k none full && " + command + " --quiet -o full/new");
    EXPECT_EQ(run("unshare -r -m sh script"), 4) << log();
    EXPECT_TRUE(log().starts_with("full/new") && (log().find("No space left on device") != std::string::npos ||
                                                  log().find("the free space of the disk is") != std::string::npos))
        << log();
    const std::string shut = "mount --bind shut shut && mount -o remount,bind,ro shut && " + command + " --quiet -o ";
    folder_.write("script", shut + "shut/new");
    EXPECT_EQ(run("unshare -r -m sh script"), 4) << log();
    EXPECT_TRUE(log().starts_with("shut/new: cannot be written: Read-only file system")) << log();
    folder_.write("script", shut + "shut/base --force");
    EXPECT_EQ(run("unshare -r -m sh script"), 4) << log();
  }
  EXPECT_EQ(listing("shut"), "base ");
  EXPECT_EQ(run("diff -r base shut/base"), 0);
}

/// A closed output pipe does not end a run before its results are written, and a second run into the folder is refused.
/// The first one is stopped meanwhile, so that it takes no time of the others.
TEST_F(RunInShell, EveryRunKeepsItsResultsToItself) {
  ASSERT_EQ(run("mkdir busy; $bumpfoil cycle case.toml -o busy --set cycle.steps=80000 --quiet &\n"
                "echo $! > writer; while ! [ -e busy/.bumpfoil/claim ]; do sleep 0.01; done; kill -STOP $!"),
            0);
  for (const std::string& command : running_commands()) {
    SCOPED_TRACE(command);
    EXPECT_EQ(run(command + " -o busy --force"), 4);
    EXPECT_NE(log().find("busy: another run writes to this folder"), std::string::npos) << log();
    EXPECT_EQ(run("{ " + command + " -o piped; echo $? > code; } | true; [ $(cat code) = 141 ]"), 0);
    EXPECT_EQ(consistent_summary("piped").at("status"), "complete");
    std::filesystem::remove_all(folder_.path() / "piped");
  }
  EXPECT_EQ(run("kill -9 $(cat writer)"), 0);
}

TEST_F(RunInShell, EveryRunThatIsEndedFlagsItsResults) {
  bool any = false;
  for (const std::string& command : running_commands()) {
    SCOPED_TRACE(command);
    // As soon as it has its folder; the shortest are done before the signal comes.
    const int code = run(command +
                         " -o ended --quiet &\nwhile ! [ -e ended/.bumpfoil/claim ] && kill -0 $!; do :; done\n"
                         "kill -TERM $!; wait $!");
    EXPECT_TRUE(code == 0 || code == 130) << code << log();
    EXPECT_EQ(consistent_summary("ended").at("status"), code == 0 ? "complete" : "interrupted");
    any |= code == 130;
    std::filesystem::remove_all(folder_.path() / "ended");
  }
  EXPECT_TRUE(any);
}

/// The case of an earlier fit could be mistaken for the result of an interrupted one.
TEST_F(RunInShell, AFitThatIsEndedLeavesNoCaseOfTheOneBefore) {
  const std::string fit = small_run_of(experiment_named("fit")) + " -o fitted --quiet";
  ASSERT_EQ(run(fit), 0) << log();
  ASSERT_EQ(listing("fitted"), "case.toml fit.csv fit.nc summary.json ");
  // Loops that take long enough for the signal to come before the first minimum.
  EXPECT_EQ(run(fit + " --force --set solver.name=newton cycle.steps=20000 &\n"
                      "while ! [ -e fitted/.bumpfoil/claim ]; do :; done; kill -TERM $!; wait $!"),
            130)
      << log();
  EXPECT_EQ(consistent_summary("fitted").at("status"), "interrupted");
  EXPECT_EQ(listing("fitted"), "fit.csv fit.nc summary.json ");
}

TEST_F(RunInShell, AFitDoesNotReplaceTheCaseThatItIsOf) {
  const std::string before = folder_.read("case.toml");
  EXPECT_EQ(run(small_run_of(experiment_named("fit")) + " -o . --force"), 4);
  EXPECT_NE(log().find("case.toml: is the case of this run"), std::string::npos) << log();
  EXPECT_TRUE(folder_.read("case.toml") == before);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "summary.json"));
}

TEST_F(RunInShell, AFolderThatIsRemovedDuringTheRunIsTold) {
  // Renamed first: rm alone would race with the files of the run.
  EXPECT_EQ(run("$bumpfoil cycle case.toml -o gone --quiet --set cycle.steps=2000 &\n"
                "until [ -e gone/.bumpfoil/staged-* ]; do sleep 0.01; done; mv gone gone.old; rm -r gone.old; wait $!"),
            4);
  EXPECT_NE(log().find("gone/cycle.csv: cannot be written: No such file or directory"), std::string::npos) << log();
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "gone"));
}

TEST_F(RunInShell, OfTwoRunsIntoOneFolderOneWinsAndTheOtherSaysWhy) {
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(run("rm -rf twice; " + cycle + "-o twice 2> a & first=$!\n" + cycle +
                  "-o twice 2> b; second=$?\nwait $first; echo $? $second > codes"),
              0);
    const std::string codes = folder_.read("codes");
    ASSERT_TRUE(codes == "0 4\n" || codes == "4 0\n") << codes;
    const std::string reason = folder_.read(codes == "4 0\n" ? "a" : "b");
    EXPECT_TRUE(reason.find("another run writes to this folder") != std::string::npos ||
                reason.find("already contains results") != std::string::npos)
        << reason;
    consistent_summary("twice");
    EXPECT_EQ(listing("twice"), set);
  }
}

TEST_F(RunInShell, KilledAtAnyTimeItLeavesTheOldSetOrTheNewOne) {
  ASSERT_EQ(run(cycle + "-o killed"), 0);
  std::mt19937 random(1);
  // The complete run takes about 50 ms; some kills come too late, on purpose.
  std::uniform_real_distribution<double> moment(0.0, 0.1);
  for (int i = 0; i < 100; ++i) {
    const std::string delay = std::to_string(moment(random));
    SCOPED_TRACE(delay);
    static_cast<void>(run(cycle + "-o killed --force & sleep " + delay + "; kill -9 $!; wait"));
    consistent_summary("killed");
  }
  EXPECT_EQ(run(cycle + "-o killed --force"), 0) << log();
  EXPECT_EQ(listing("killed"), set);
}

TEST_F(RunInShell, SignalsOfBatchSystemsAreInterruptions) {
  for (const std::string signal : {"INT", "TERM", "HUP", "XCPU"}) {
    SCOPED_TRACE(signal);
    // A shell without job control starts what runs in the background with SIGINT ignored; env gives it back.
    EXPECT_EQ(run("env --default-signal=INT $bumpfoil cycle case.toml -o long --force --set cycle.steps=20000 &\n"
                  "while ! [ -e long/.bumpfoil/claim ]; do sleep 0.01; done; sleep 0.1\n"
                  "kill -" +
                  signal + " $!; wait $!"),
              130);
    EXPECT_NE(log().find("interrupted: the results in long are partial"), std::string::npos) << log();
    EXPECT_EQ(consistent_summary("long").at("status"), "interrupted");
    EXPECT_EQ(listing("long"), set);
  }
}

TEST_F(RunInShell, ASecondInterruptionEndsItAtOnceAndTheNextRunCleansUp) {
  EXPECT_EQ(run("env --default-signal=INT $bumpfoil cycle case.toml -o twice --set cycle.steps=80000 &\n"
                "while ! [ -e twice/.bumpfoil/claim ]; do sleep 0.01; done; sleep 0.5\n"
                "kill -INT $!; sleep 0.02; kill -INT $!; wait $!"),
            130);
  EXPECT_NE(log().find("interrupted twice: results not yet written are lost"), std::string::npos) << log();
  EXPECT_EQ(run(cycle + "-o twice"), 0) << log();
  EXPECT_EQ(listing("twice"), set);
}

TEST_F(RunInShell, WhatWasIgnoredStaysIgnored) {
  // nohup ignores SIGHUP; a shell without job control ignores SIGINT for what runs in the background.
  EXPECT_EQ(run("trap '' HUP\n$bumpfoil cycle case.toml -o kept --set cycle.steps=1000 --quiet &\n"
                "while ! [ -e kept/.bumpfoil/claim ]; do sleep 0.01; done\nkill -HUP $!; kill -INT $!; wait $!"),
            0)
      << log();
  EXPECT_EQ(consistent_summary("kept").at("status"), "complete");
}

TEST_F(RunInShell, AFolderInThePlaceOfAResultIsRefused) {
  EXPECT_EQ(run("mkdir -p way/result.nc && echo old > way/summary.json && " + cycle + "-o way --force"), 4);
  EXPECT_NE(log().find("way/result.nc: is a folder"), std::string::npos) << log();
  EXPECT_EQ(listing("way"), "result.nc summary.json ");
}

TEST_F(RunInShell, ReproduceReplacesNothingUnlessForced) {
  for (const std::string name : {"contacts.csv", "picture.gp", "scatter20-bearing4/case.toml"}) {
    SCOPED_TRACE(name);
    const std::filesystem::path path = std::filesystem::path("paper/figure16") / name;
    folder_.write(path.string(), "mine");
    EXPECT_EQ(run("$bumpfoil reproduce -o paper --figure 16"), 4) << log();
    EXPECT_NE(log().find("already contains results (" + path.filename().string() + ")"), std::string::npos) << log();
    EXPECT_EQ(folder_.read(path.string()), "mine");
    std::filesystem::remove_all(folder_.path() / "paper");
  }
}

TEST_F(RunInShell, AFailedReproductionLeavesNoFolders) {
  EXPECT_EQ(run("ulimit -f 1; $bumpfoil reproduce -o new/paper --figure 10 --figure 16"), 4) << log();
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "new"));
}

#if BUMPFOIL_HAS_REPORT
TEST_F(RunInShell, AReportDoesNotReplaceWhatItIsMadeFrom) {
  ASSERT_EQ(run(cycle + "-o base && ln -s base link"), 0);
  const json before = consistent_summary("base");
  for (const std::string output : {"base/result.nc", "link/summary.json", "base/cycle.csv"}) {
    EXPECT_EQ(run("$bumpfoil report base -o " + output + " --force"), 4);
    EXPECT_NE(log().find("is one of the results that this report reads"), std::string::npos) << log();
  }
  EXPECT_EQ(consistent_summary("base"), before);
}
#endif

}  // namespace
}  // namespace bumpfoil
