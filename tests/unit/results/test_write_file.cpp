#include "bumpfoil/results/write_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::TemporaryFolder;

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

TEST(WriteFile, RemovesWhatKilledProcessesLeftAndNothingElse) {
  const TemporaryFolder folder;
  folder.write(".case.toml.0123abcd.tmp", "left");
  folder.write(".case.toml.mine", "text");
  folder.write(".other.toml.0123abcd.tmp", "left");
  // A file that is still being written is locked.
  const std::string living = folder.write(".case.toml.4567abcd.tmp", "half");
  const int file = ::open(living.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(file, LOCK_EX), 0);
  write_file(folder.path() / "case.toml", "text", Existing::refuse);
  EXPECT_EQ(folder.listing(), ".case.toml.4567abcd.tmp .case.toml.mine .other.toml.0123abcd.tmp case.toml ");
  ::close(file);
}

TEST(WriteFile, NamesTheFileThatWasAskedFor) {
  try {
    write_file("/proc/self/case.toml", "text", Existing::refuse);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_EQ(std::string(error.what()).find("/proc/self/case.toml: cannot be written: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace bumpfoil
