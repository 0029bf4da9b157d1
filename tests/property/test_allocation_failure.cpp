#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <new>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "property/counted_allocator.hpp"
#include "support/temporary_folder.hpp"

#ifdef BUMPFOIL_COUNTS_ALLOCATIONS

namespace bumpfoil {
namespace {

/// Allocations that fail one at a time, most among the first ones: each of the first ten, then 20 % later each time.
std::vector<long> failing_allocations(long count) {
  std::vector<long> failing;
  for (long n = 1; n <= count; n = std::max(n + 1, n + n / 5)) failing.push_back(n);
  return failing;
}

/// Number of runs with a failed allocation, by outcome.
struct Ends {
  int same{};     ///< same result: a library recovered
  int thrown{};   ///< std::bad_alloc or Error, and no leak
  int aborted{};  ///< by a library
  int wrong{};    ///< anything else
};

/// @param run  performs the run in one thread, and returns the result to compare
template <typename Run>
Ends ends_of(const Run& run) {
  const auto expected = run();  // libraries keep what they allocate at their first use
  const long before = allocations;
  EXPECT_EQ(run(), expected);
  const long count = allocations - before;
  EXPECT_GT(count, 500);
  Ends ends;
  for (const long n : failing_allocations(count)) {
    const pid_t child = fork();
    if (child == 0) {
      close(STDERR_FILENO);
      const long held = held_blocks;
      bool same = false;
      bool thrown = false;
      until_failure = n;
      try {
        same = run() == expected;
      } catch (const std::bad_alloc&) {
        thrown = true;
      } catch (const Error&) {
        thrown = true;
      }
      until_failure = 0;
      _exit(held_blocks != held ? 2 : same ? 0 : thrown ? 1 : 2);
    }
    int status = 0;
    waitpid(child, &status, 0);
    const bool exited = WIFEXITED(status);
    ++(exited && WEXITSTATUS(status) == 0                   ? ends.same
       : exited && WEXITSTATUS(status) == 1                 ? ends.thrown
       : WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? ends.aborted
                                                            : ends.wrong);
  }
  return ends;
}

/// Some libraries terminate the process when out of memory: toml++ in noexcept functions; resizing an Eigen 3.4 matrix
/// frees its memory twice, which the C library detects.
void expect_exceptions(const Ends& ends) {
  EXPECT_EQ(ends.wrong, 0);
  EXPECT_GT(ends.thrown, 20);
  EXPECT_LE(ends.aborted, ends.thrown / 10);
}

Case small_case(const std::string& command, const std::vector<std::string>& keys) {
  return parse_case(case_template("gen1"), "case.toml", {.overrides = keys, .commands = {command}});
}

/// All numbers of a result except computing times, as text, since some are NaN.
std::string numbers_of(const std::string& experiment, const Case& input) {
  const Outcome outcome = experiment_named(experiment).run(input, {});
  std::string numbers;
  for (const Variable& variable : outcome.dataset().variables) {
    if (variable.meaning.name.starts_with("wall_time") || !variable.values) continue;
    for (const double value : variable.values()) numbers += fmt::format("{} ", value);
  }
  return numbers;
}

TEST(AllocationFailure, EndsTheReaderOfCases) {
  const std::string text = case_template("gen1");
  const std::vector<std::string> keys{"cycle.steps=7", "bump_foil.thickness=\"101 um\""};
  const CaseRequest request{.overrides = keys, .commands = {"cycle"}};
  const Case whole = parse_case(text, "case.toml", request);
  expect_exceptions(ends_of([&] { return parse_case(text, "case.toml", request) == whole; }));
}

TEST(AllocationFailure, EndsACycle) {
  for (const std::string solver : {"newton", "events"}) {
    SCOPED_TRACE(solver);
    const Case input = small_case("cycle", {"cycle.directions=[\"+X\"]", "cycle.steps=4", "solver.name=" + solver});
    expect_exceptions(ends_of([&] { return numbers_of("cycle", input); }));
  }
}

TEST(AllocationFailure, EndsAnEquilibrium) {
  const Case input = small_case(
      "equilibrium", {"film.columns_per_pitch=4", "film.rows=4", "bump_foil.bumps=5",
                      "equilibrium.speeds=[\"45000 rpm\"]", "equilibrium.positions=[[\"15 um\", \"0 um\"]]"});
  expect_exceptions(ends_of([&] { return numbers_of("equilibrium", input); }));
}

/// Either the old or the new files, and no others; also if the standard library terminates the process, as it does
/// without memory to list a folder.
TEST(AllocationFailure, LeavesOneSetOfFiles) {
  const test_support::TemporaryFolder folder;
  const std::filesystem::path results = folder.path() / "results";
  const std::vector<std::string> names{"a.csv", "b.csv"};
  const auto publish = [&](const std::string& contents) {
    ResultFolder whole(results, Existing::replace, names);
    for (const std::string& name : names) whole.stage(name, contents);
    whole.publish();
  };
  const auto published = [&](const std::string& name) { return folder.read(published_file(results, name).string()); };
  publish("old");
  const long before = allocations;
  publish("old");
  const long count = allocations - before;
  int failed = 0;
  for (const long n : failing_allocations(count)) {
    const pid_t child = fork();
    if (child == 0) {
      close(STDERR_FILENO);
      until_failure = n;
      try {
        publish("new");
      } catch (...) {
        _exit(1);
      }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) ++failed;
    const std::string first = published("a.csv");
    EXPECT_TRUE(first == "new" || (first == "old" && status != 0)) << n << ": " << first;
    EXPECT_EQ(published("b.csv"), first) << n;
    publish("old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(results), {}), 2) << n;
  }
  EXPECT_GT(failed, 0);
}

}  // namespace
}  // namespace bumpfoil

#endif
