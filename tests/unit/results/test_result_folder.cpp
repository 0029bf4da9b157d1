#include "bumpfoil/results/result_folder.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::TemporaryFolder;

const std::vector<std::string> names{"cycle.csv", "result.nc", "summary.json"};

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

std::string refusal(const std::filesystem::path& path, Existing existing) {
  return message_of([&] { const ResultFolder folder(path, existing, names); });
}

TEST(ResultFolder, PublishesEverythingAtOnce) {
  const TemporaryFolder outer;
  const std::filesystem::path path = outer.path() / "a/b";
  {
    ResultFolder folder(path, Existing::refuse, names);
    folder.stage("summary.json", "{}\n");
    folder.stage("cycle.csv", "x\n");
    EXPECT_FALSE(std::filesystem::exists(path / "summary.json"));
    folder.publish();
  }
  EXPECT_EQ(outer.read("a/b/summary.json"), "{}\n");
  EXPECT_EQ(outer.read("a/b/cycle.csv"), "x\n");
  // No other files are left.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path), {}), 2);
}

/// If a run does not write one of its files, that of an earlier run is removed; other files stay.
TEST(ResultFolder, LeavesNothingOfAnEarlierRun) {
  const TemporaryFolder outer;
  for (const char* name : {"summary.json", "fit.csv", "case.toml", "transient.csv", "notes.txt", "-notes"}) {
    outer.write(name, "old");
  }
  const auto publish = [&outer](std::vector<std::string> of_command) {
    ResultFolder folder(outer.path(), Existing::replace, std::move(of_command));
    folder.stage("summary.json", "new");
    folder.publish();
  };
  // case.toml belongs to the user if the command writes no such file.
  publish({"cycle.csv", "summary.json"});
  EXPECT_EQ(outer.listing(), "-notes case.toml notes.txt summary.json ");
  publish({"case.toml", "fit.csv", "summary.json"});
  EXPECT_EQ(outer.listing(), "-notes notes.txt summary.json ");
  EXPECT_EQ(outer.read("summary.json"), "new");
}

TEST(ResultFolder, TakesBackWhatWasNotPublished) {
  const TemporaryFolder outer;
  {
    ResultFolder folder(outer.path() / "new", Existing::refuse, names);
    folder.stage("summary.json", "half");
  }
  EXPECT_EQ(outer.listing(), "");
  {
    ResultFolder folder(outer.path(), Existing::refuse, names);
    folder.stage("summary.json", "half");
  }
  EXPECT_TRUE(std::filesystem::exists(outer.path()));
  EXPECT_EQ(outer.listing(), "");
}

TEST(ResultFolder, RefusesToReplaceResults) {
  const TemporaryFolder folder;
  folder.write("ensemble.nc", "old");
  const std::string message = refusal(folder.path(), Existing::refuse);
  EXPECT_NE(message.find("already contains results (ensemble.nc)"), std::string::npos);
  EXPECT_NE(message.find("--force"), std::string::npos);
  EXPECT_EQ(folder.read("ensemble.nc"), "old");
}

TEST(ResultFolder, RefusesToReplaceAnyOfItsFiles) {
  const TemporaryFolder folder;
  folder.write("loads.csv", "mine");
  const std::string message = message_of([&] {
    const ResultFolder results(folder.path(), Existing::refuse, {"study.json", "loads.csv"});
  });
  EXPECT_NE(message.find("already contains results (loads.csv)"), std::string::npos);
  // Files created after the start are not replaced either.
  ResultFolder results(folder.path(), Existing::refuse, names);
  results.stage("summary.json", "new");
  folder.write("summary.json", "mine");
  EXPECT_NE(message_of([&] { results.publish(); }).find("already contains results"), std::string::npos);
  EXPECT_EQ(folder.read("summary.json"), "mine");
}

TEST(ResultFolder, LeavesOtherFilesAlone) {
  const TemporaryFolder outer;
  outer.write("case.toml", "mine");
  {
    ResultFolder folder(outer.path(), Existing::refuse, names);
    folder.stage("summary.json", "new");
    folder.publish();
  }
  EXPECT_EQ(outer.listing(), "case.toml summary.json ");
}

TEST(ResultFolder, ReplacesAllResultsOfTheEarlierRun) {
  const TemporaryFolder outer;
  outer.write("summary.json", "old");
  outer.write("result.nc", "old");
  outer.write("case.toml", "mine");
  {
    ResultFolder folder(outer.path(), Existing::replace, names);
    EXPECT_EQ(outer.read("summary.json"), "old");  // until the new files are complete
    folder.stage("summary.json", "new");
    folder.publish();
  }
  EXPECT_EQ(outer.listing(), "case.toml summary.json ");
  EXPECT_EQ(outer.read("summary.json"), "new");
}

TEST(ResultFolder, SaysWhyItCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_NE(refusal(file, Existing::replace).find("cannot be written"), std::string::npos);
  EXPECT_NE(refusal(file + "/below", Existing::refuse).find("cannot be written"), std::string::npos);
  EXPECT_NE(refusal("", Existing::refuse).find("cannot be written"), std::string::npos);
  if (::geteuid() != 0) {  // root can write everywhere
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_NE(refusal(folder.path(), Existing::refuse).find("cannot be written"), std::string::npos);
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  }
}

TEST(ResultFolder, ForgetsWhatIsDiscarded) {
  const TemporaryFolder outer;
  {
    ResultFolder results(outer.path(), Existing::refuse, names);
    const std::filesystem::path staged = results.stage("summary.json", "text");
    EXPECT_TRUE(std::filesystem::exists(staged));
    results.stage("result.nc");  // never written
    results.discard("summary.json");
    results.discard("result.nc");
    EXPECT_FALSE(std::filesystem::exists(staged));
    results.stage("cycle.csv", "text");
    results.publish();
  }
  EXPECT_EQ(outer.listing(), "cycle.csv ");
}

TEST(ResultFolder, IsClaimedByOneAtATime) {
  const TemporaryFolder outer;
  {
    const ResultFolder first(outer.path(), Existing::replace, names);
    const std::string message = refusal(outer.path(), Existing::replace);
    EXPECT_NE(message.find("another run writes to this folder (process " + std::to_string(::getpid())),
              std::string::npos)
        << message;
  }
  const ResultFolder second(outer.path(), Existing::replace, names);
}

TEST(ResultFolder, AClaimThatWasLostIsNoticedBeforeAnythingChanges) {
  const TemporaryFolder outer;
  outer.write("summary.json", "old");
  ResultFolder folder(outer.path(), Existing::replace, names);
  folder.stage("summary.json", "new");
  // As on a file system without locks: another run writes its name into the claim.
  outer.write(".bumpfoil/claim", "process 1 on another");
  EXPECT_NE(message_of([&] { folder.publish(); }).find("another run has meanwhile taken over this folder"),
            std::string::npos);
  EXPECT_EQ(outer.read("summary.json"), "old");
}

TEST(ResultFolder, AFolderInThePlaceOfAFileIsRefusedBeforeAnythingChanges) {
  const TemporaryFolder outer;
  outer.write("result.nc/mine", "text");
  EXPECT_NE(refusal(outer.path(), Existing::replace).find("result.nc: is a folder"), std::string::npos);
  EXPECT_EQ(outer.read("result.nc/mine"), "text");
}

/// A folder with the results of an earlier `cycle` run, and their report.
class Publication : public ::testing::Test {
 protected:
  Publication() {
    for (const char* name : {"summary.json", "cycle.csv", "result.nc", "report.html"}) outer_.write(name, "old");
  }

  void publish_new(const std::function<void()>& before) const {
    ResultFolder folder(outer_.path(), Existing::replace, names);
    for (const std::string& name : names) folder.stage(name, "new");
    folder.publish(before);
  }

  [[nodiscard]] std::string as_readers_see(const std::string& name) const {
    const std::filesystem::path path = published_file(outer_.path(), name);
    return outer_.read(path.lexically_relative(outer_.path()).string());
  }

  /// "old" or "new", the same for all files of the set.
  [[nodiscard]] std::string set_as_readers_see_it() const {
    const std::string set = as_readers_see("summary.json");
    for (const std::string& name : names) {
      EXPECT_EQ(as_readers_see(name), set) << name;
      // Readers that bypass the list also see complete files.
      EXPECT_TRUE(outer_.read(name) == "old" || outer_.read(name) == "new") << name << outer_.read(name);
    }
    return set;
  }

  TemporaryFolder outer_;
};

/// Runs the action in another process. @return whether it completed
bool survives(const std::function<void()>& action) {
  const pid_t process = ::fork();
  if (process == 0) {
    action();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(Publication, KilledBeforeAnyStepIsTheOldSetOrTheNewOne) {
  bool ended = false;
  int old_sets = 0;
  int new_sets = 0;
  for (int last = 1; !ended; ++last) {
    SCOPED_TRACE(last);
    for (const char* name : {"summary.json", "cycle.csv", "result.nc", "report.html"}) outer_.write(name, "old");
    ended = survives([&] {
      int step = 0;
      publish_new([&] {
        if (++step == last) ::raise(SIGKILL);
      });
    });
    const std::string set = set_as_readers_see_it();
    ASSERT_TRUE(set == "old" || set == "new") << set;
    ++(set == "old" ? old_sets : new_sets);
    // The next run that opens the folder leaves only the set.
    { const ResultFolder next(outer_.path(), Existing::replace, names); }
    EXPECT_EQ(set_as_readers_see_it(), set);
    EXPECT_EQ(outer_.read("summary.json"), set);
    EXPECT_EQ(outer_.listing(),
              set == "old" ? "cycle.csv report.html result.nc summary.json " : "cycle.csv result.nc summary.json ");
  }
  // Old sets: killed before the list is written or before the set is published. New sets: killed before a file is
  // removed or moved.
  EXPECT_EQ(old_sets, 2);
  EXPECT_GT(new_sets, 8);
}

TEST_F(Publication, FailedBeforeAnyStepIsTheOldSetOrTheNewOne) {
  bool ended = false;
  for (int last = 1; !ended; ++last) {
    SCOPED_TRACE(last);
    for (const char* name : {"summary.json", "cycle.csv", "result.nc", "report.html"}) outer_.write(name, "old");
    int step = 0;
    try {
      publish_new([&] {
        if (++step == last) throw std::runtime_error("failed");
      });
      ended = true;
    } catch (const std::runtime_error&) {
    }
    const std::string set = set_as_readers_see_it();
    ASSERT_EQ(set, last <= 2 ? "old" : "new");
    // Readers complete the publication, too.
    complete_publication_quietly(outer_.path());
    EXPECT_EQ(outer_.read("result.nc"), set);
    EXPECT_EQ(outer_.listing(),
              set == "old" ? "cycle.csv report.html result.nc summary.json " : "cycle.csv result.nc summary.json ");
  }
}

TEST_F(Publication, WhatComesInTheWayInTheMiddleLeavesTheNewSetToBeCompleted) {
  int step = 0;
  const std::string message = message_of([&] {
    publish_new([&] {
      if (++step != 3) return;
      std::filesystem::remove(outer_.path() / "result.nc");
      outer_.write("result.nc/mine", "text");
    });
  });
  EXPECT_EQ(message.find((outer_.path() / "result.nc: ").string()), 0U) << message;
  for (const std::string& name : names) EXPECT_EQ(as_readers_see(name), "new") << name;
  // While it is in the way, no run can replace the results.
  EXPECT_NE(refusal(outer_.path(), Existing::replace).find("result.nc"), std::string::npos);
  complete_publication_quietly(outer_.path());
  for (const std::string& name : names) EXPECT_EQ(as_readers_see(name), "new") << name;
  std::filesystem::rename(outer_.path() / "result.nc", outer_.path() / "moved");
  complete_publication_quietly(outer_.path());
  EXPECT_EQ(outer_.listing(), "cycle.csv moved result.nc summary.json ");
}

TEST_F(Publication, KilledBeforeItIsUndoneByTheNext) {
  EXPECT_FALSE(survives([&] {
    ResultFolder folder(outer_.path(), Existing::replace, names);
    folder.stage("summary.json", "half");
    ::raise(SIGKILL);
  }));
  EXPECT_EQ(set_as_readers_see_it(), "old");
  EXPECT_NE(outer_.listing().find(".bumpfoil"), std::string::npos);
  refusal(outer_.path(), Existing::refuse);  // tidies up
  EXPECT_EQ(outer_.listing(), "cycle.csv report.html result.nc summary.json ");
}

}  // namespace
}  // namespace bumpfoil
