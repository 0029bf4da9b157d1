#include "bumpfoil/results/made_folder.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using test_support::TemporaryFolder;

TEST(MadeFolder, IsRemovedWithThoseThatHoldItWhereTheyStayEmpty) {
  const TemporaryFolder folder;
  const std::filesystem::path outer = folder.path() / "a";
  {
    const MadeFolder made(outer / "b" / "c");
    EXPECT_TRUE(std::filesystem::is_directory(outer / "b" / "c"));
  }
  EXPECT_FALSE(std::filesystem::exists(outer));
  {
    const MadeFolder made(outer / "b" / "c/");
    folder.write("a/kept", "");
  }
  EXPECT_FALSE(std::filesystem::exists(outer / "b"));
  EXPECT_TRUE(std::filesystem::exists(outer / "kept"));
  std::filesystem::create_directory(outer / "empty");
  { const MadeFolder there(outer / "empty"); }
  EXPECT_TRUE(std::filesystem::exists(outer / "empty"));
}

TEST(MadeFolder, CannotBeInAFile) {
  const TemporaryFolder folder;
  folder.write("file", "");
  EXPECT_THROW(MadeFolder(folder.path() / "file" / "x"), Error);
}

}  // namespace
}  // namespace bumpfoil
