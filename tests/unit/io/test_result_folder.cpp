#include "bumpfoil/io/result_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using testing::TemporaryFolder;

std::string refusal(const std::filesystem::path& path, Existing existing) {
  try {
    const ResultFolder folder(path, existing);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

TEST(ResultFolder, PublishesEverythingAtOnce) {
  const TemporaryFolder outer;
  const std::filesystem::path path = outer.path() / "a/b";
  ResultFolder folder(path, Existing::refuse);
  folder.stage("summary.json", "{}\n");
  folder.stage("cycle.csv", "x\n");
  EXPECT_FALSE(std::filesystem::exists(path / "summary.json"));
  folder.publish();
  EXPECT_EQ(outer.read("a/b/summary.json"), "{}\n");
  EXPECT_EQ(outer.read("a/b/cycle.csv"), "x\n");
  // Nothing but these is left.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path), {}), 2);
}

TEST(ResultFolder, TakesBackWhatWasNotPublished) {
  const TemporaryFolder outer;
  {
    ResultFolder folder(outer.path() / "new", Existing::refuse);
    folder.stage("summary.json", "half");
  }
  EXPECT_EQ(outer.listing(), "");
  {
    ResultFolder folder(outer.path(), Existing::refuse);
    folder.stage("summary.json", "half");
  }
  EXPECT_TRUE(std::filesystem::exists(outer.path()));
  EXPECT_EQ(outer.listing(), "");
}

TEST(ResultFolder, RefusesToReplaceResults) {
  const TemporaryFolder folder;
  folder.write("summary.json", "old");
  const std::string message = refusal(folder.path(), Existing::refuse);
  EXPECT_NE(message.find("holds results already (summary.json)"), std::string::npos);
  EXPECT_NE(message.find("--force"), std::string::npos);
  EXPECT_EQ(folder.read("summary.json"), "old");
}

TEST(ResultFolder, LeavesOtherFilesAlone) {
  const TemporaryFolder outer;
  outer.write("case.toml", "mine");
  ResultFolder folder(outer.path(), Existing::refuse);
  folder.stage("summary.json", "new");
  folder.publish();
  EXPECT_EQ(outer.listing(), "case.toml summary.json ");
}

TEST(ResultFolder, ReplacesAllResultsOfTheEarlierRun) {
  const TemporaryFolder outer;
  outer.write("summary.json", "old");
  outer.write("result.nc", "old");
  outer.write("case.toml", "mine");
  ResultFolder folder(outer.path(), Existing::replace);
  EXPECT_EQ(outer.read("summary.json"), "old");  // until the new ones are there
  folder.stage("summary.json", "new");
  folder.publish();
  EXPECT_EQ(outer.listing(), "case.toml summary.json ");
  EXPECT_EQ(outer.read("summary.json"), "new");
}

TEST(ResultFolder, SaysWhyItCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  EXPECT_NE(refusal(file, Existing::replace).find("cannot be written"), std::string::npos);
  EXPECT_NE(refusal(file + "/below", Existing::refuse).find("cannot be written"), std::string::npos);
  EXPECT_NE(refusal("", Existing::refuse).find("cannot be written"), std::string::npos);
  if (::geteuid() != 0) {  // root writes everywhere
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_NE(refusal(folder.path(), Existing::refuse).find("cannot be written"), std::string::npos);
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  }
}

TEST(ResultFolder, ForgetsWhatIsDiscarded) {
  const TemporaryFolder folder;
  ResultFolder results(folder.path(), Existing::refuse);
  const std::filesystem::path staged = results.stage("summary.json", "text");
  EXPECT_TRUE(std::filesystem::exists(staged));
  results.stage("picture.svg");  // never written
  results.discard("summary.json");
  results.discard("picture.svg");
  EXPECT_EQ(folder.listing(), "");
  results.stage("cycle.csv", "text");
  results.publish();
  EXPECT_EQ(folder.listing(), "cycle.csv ");
}

TEST(WriteFile, IsWholeOrNotThere) {
  const TemporaryFolder folder;
  write_file(folder.path() / "case.toml", "text", Existing::refuse);
  EXPECT_EQ(folder.read("case.toml"), "text");
  EXPECT_EQ(folder.listing(), "case.toml ");
  EXPECT_THROW(write_file(folder.path() / "case.toml", "other", Existing::refuse), Error);
  EXPECT_EQ(folder.read("case.toml"), "text");
  write_file(folder.path() / "case.toml", "other", Existing::replace);
  EXPECT_EQ(folder.read("case.toml"), "other");
}

TEST(WriteFile, ReplacesOrdinaryFilesOnly) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_file(folder.path(), "text", Existing::replace), Error);
  EXPECT_THROW(write_file("/dev/null", "text", Existing::replace), Error);
  EXPECT_THROW(write_file(folder.path() / "missing/case.toml", "text", Existing::refuse), Error);
  EXPECT_EQ(folder.listing(), "");
}

}  // namespace
}  // namespace bumpfoil
