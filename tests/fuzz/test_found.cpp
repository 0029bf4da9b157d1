// Seed inputs and findings of the fuzzers, as regression tests: quick, with every compiler and sanitizer.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/byte_targets.hpp"
#include "fuzz/checked_run.hpp"

namespace bumpfoil {
namespace {

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Fuzz, ReadersTakeTheirCorpus) {
  for (const auto& [name, target] : byte_targets()) {
    SCOPED_TRACE(name);
    target("");
    for (const auto& file : files_in("fuzz/corpus/" + name)) {
      SCOPED_TRACE(file);
      target(read(file));
    }
  }
}

/// Cases that an earlier version computed wrongly: the first word is the command.
TEST(Fuzz, CasesThatWereFoundAreRight) {
  for (const auto& file : files_in("fuzz/cases")) {
    const std::string text = read(file);
    const std::size_t end = text.find('\n');
    EXPECT_EQ(check_case({text.substr(2, end - 2), text}, 1e3).wrong, "") << file;
  }
}

TEST(Fuzz, CasesThatAreDrawnAreRight) {
  int solved = 0;
  int failed = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const DrawnCase drawn = draw_case(DrawsOfBytes(bytes_of_seed(seed)));
    const Verdict verdict = check_case(drawn, 0.1);
    EXPECT_EQ(verdict.wrong, "") << drawn.text;
    solved += verdict.end == Verdict::End::solved ? 1 : 0;
    failed += verdict.end == Verdict::End::failed ? 1 : 0;
  }
  EXPECT_GT(solved, 3);
  EXPECT_GT(failed, 0);
}

}  // namespace
}  // namespace bumpfoil
