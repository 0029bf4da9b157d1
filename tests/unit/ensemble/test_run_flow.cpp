#include "bumpfoil/ensemble/run_flow.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace bumpfoil {
namespace {

using Rows = std::vector<double>;
using namespace std::chrono_literals;

TEST(RunFlow, RowsLeaveInTheOrderOfTheirNumbers) {
  RunFlow flow(10, 14, 100);
  for (std::size_t number = 10; number < 14; ++number) EXPECT_EQ(flow.next(), number);
  flow.put(12, {12.0, 0.5});
  EXPECT_EQ(flow.leave(9), Rows{});
  flow.put(10, {10.0, 0.5});
  EXPECT_EQ(flow.done(), 12U);
  EXPECT_EQ(flow.waiting(), 2U);
  EXPECT_EQ(flow.leave(9), (Rows{10.0, 0.5}));
  flow.put(11, {11.0, 0.5});
  flow.put(13, {13.0, 0.5});
  EXPECT_EQ(flow.leave(2), (Rows{11.0, 0.5, 12.0, 0.5}));
  EXPECT_EQ(flow.leave(2), (Rows{13.0, 0.5}));
  EXPECT_EQ(flow.done(), 14U);
  EXPECT_EQ(flow.waiting(), 0U);
}

TEST(RunFlow, NothingGoesOutBeyondTheWindow) {
  RunFlow flow(0, 100, 4);
  RunRange range = flow.take(3);
  EXPECT_EQ(range.first, 0U);
  EXPECT_EQ(range.count, 3U);
  range = flow.take(3);
  EXPECT_EQ(range.first, 3U);
  EXPECT_EQ(range.count, 1U);
  for (const std::size_t number : {1U, 2U, 3U}) flow.put(number, {});
  flow.leave(9);
  EXPECT_EQ(flow.take(3).count, 0U);  // the first is missing
  flow.put(0, {1.0});
  EXPECT_EQ(flow.take(3).count, 0U);  // its row has not left
  EXPECT_EQ(flow.leave(9).size(), 1U);
  EXPECT_EQ(flow.take(9).count, 4U);
}

/// Checks that a request for a sample waits until an action is done.
template <typename Something>
void expect_waits_until(RunFlow& flow, std::optional<std::size_t> then, Something something) {
  std::atomic<bool> answered{false};
  std::thread asks([&] {
    EXPECT_EQ(flow.next(), then);
    answered = true;
  });
  std::this_thread::sleep_for(30ms);
  EXPECT_FALSE(answered);
  something();
  asks.join();
}

TEST(RunFlow, WaitsForRoomAndForTheLastRow) {
  RunFlow flow(0, 2, 1);
  EXPECT_EQ(flow.next(), 0U);
  flow.put(0, {});
  expect_waits_until(flow, 1, [&] { flow.leave(1); });
  expect_waits_until(flow, std::nullopt, [&] { flow.put(1, {}); });
  EXPECT_EQ(flow.next(), std::nullopt);
}

TEST(RunFlow, ClosedItGivesNothingMore) {
  RunFlow flow(0, 2, 1);
  EXPECT_FALSE(flow.closed());
  EXPECT_EQ(flow.next(), 0U);
  expect_waits_until(flow, std::nullopt, [&] { flow.close(); });
  EXPECT_TRUE(flow.closed());
  EXPECT_EQ(flow.take(1).count, 0U);
  flow.put(0, {1.0});  // results of runs in progress are accepted
  EXPECT_EQ(flow.leave(1), Rows{1.0});
}

TEST(RunFlow, OfNoSamplesIsAtItsEnd) {
  RunFlow flow(7, 7, 5);
  EXPECT_EQ(flow.next(), std::nullopt);
  EXPECT_EQ(flow.take(3).count, 0U);
  EXPECT_EQ(flow.done(), 7U);
}

}  // namespace
}  // namespace bumpfoil
