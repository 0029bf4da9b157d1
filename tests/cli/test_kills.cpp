// Runs that are killed at any time. Minutes.

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <string>

#include "cli/run_in_shell.hpp"

namespace bumpfoil {
namespace {

using test_support::RunInShell;
using test_support::running_commands;

TEST_F(RunInShell, EveryRunThatIsKilledLeavesTheOldSetOrTheNewOne) {
  std::mt19937 random(1);
  for (const std::string& command : running_commands()) {
    SCOPED_TRACE(command);
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(run(command + " -o killed --quiet"), 0) << log();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const std::string files = listing("killed");
    // Some kills come too late, on purpose.
    std::uniform_real_distribution<double> moment(0.0, 1.2 * taken.count());
    for (int i = 0; i < 100; ++i) {
      const std::string delay = std::to_string(moment(random));
      SCOPED_TRACE(delay);
      static_cast<void>(run(command + " -o killed --quiet --force & sleep " + delay + "; kill -9 $!; wait"));
      EXPECT_EQ(consistent_summary("killed").at("status"), "complete");
    }
    EXPECT_EQ(run(command + " -o killed --quiet --force"), 0) << log();
    EXPECT_EQ(listing("killed"), files);
    std::filesystem::remove_all(folder_.path() / "killed");
  }
}

}  // namespace
}  // namespace bumpfoil
