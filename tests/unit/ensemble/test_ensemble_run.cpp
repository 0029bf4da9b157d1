#include "bumpfoil/ensemble/ensemble_run.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "support/ensemble_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class EnsembleRuns : public ::testing::Test {
 protected:
  RowLog new_log(const std::string& name) const { return {folder_.path() / name, "", layout_.width()}; }

  /// Bit-identical, including absent numbers.
  void expect_same(const RowLog& a, const RowLog& b) const {
    ASSERT_EQ(a.rows(), b.rows());
    for (std::size_t place = 0; place < layout_.width(); ++place) {
      const std::vector<double> of_a = a.column(place);
      const std::vector<double> of_b = b.column(place);
      EXPECT_EQ(std::memcmp(of_a.data(), of_b.data(), of_a.size() * sizeof(double)), 0) << place;
    }
  }

  Case input_{test_support::ensemble_case(60)};
  EnsembleLayout layout_{make_ensemble_layout(input_)};
  test_support::TemporaryFolder folder_;
};

TEST_F(EnsembleRuns, ThreadsMakeNoDifference) {
  RowLog one = new_log("one");
  EXPECT_TRUE(run_ensemble(input_, layout_, one, {.threads = 1}));
  RowLog three = new_log("three");
  EXPECT_TRUE(run_ensemble(input_, layout_, three, {.threads = 3}));
  EXPECT_EQ(one.rows(), 60U);
  expect_same(one, three);
}

TEST_F(EnsembleRuns, GoOnWhereTheyWereStopped) {
  RowLog whole = new_log("whole");
  ASSERT_TRUE(run_ensemble(input_, layout_, whole, {.threads = 2}));
  RowLog log = new_log("stopped");
  for (int stops = 0; log.rows() < 60U; ++stops) {
    ASSERT_LT(stops, 1000);
    const double begin = static_cast<double>(log.rows());
    run_ensemble(input_, layout_, log, {.threads = 2, .progress = [&](double done) { return done < begin + 7.0; }});
  }
  expect_same(whole, log);
}

TEST_F(EnsembleRuns, MoreSamplesAreTheSameEnsemble) {
  RowLog whole = new_log("whole");
  ASSERT_TRUE(run_ensemble(input_, layout_, whole, {.threads = 2}));
  RowLog log = new_log("more");
  Case fewer = input_;
  fewer.montecarlo->samples = 23;
  ASSERT_TRUE(run_ensemble(fewer, layout_, log, {.threads = 2}));
  EXPECT_EQ(log.rows(), 23U);
  ASSERT_TRUE(run_ensemble(input_, layout_, log, {.threads = 2}));
  expect_same(whole, log);
}

TEST_F(EnsembleRuns, AreEnoughAfterWholeRoundsOnly) {
  Case input = input_;
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0};
  cycle.steps = 1;
  input.montecarlo->samples = 2500;
  const EnsembleLayout layout = make_ensemble_layout(input);
  RowLog log(folder_.path() / "rounds", "", layout.width());
  std::vector<std::size_t> requested;
  const auto enough = [&] {
    requested.push_back(log.rows());
    return log.rows() >= 2 * ensemble_round;
  };
  EXPECT_TRUE(run_ensemble(input, layout, log, {.threads = 2, .enough = enough}));
  EXPECT_EQ(requested, (std::vector<std::size_t>{1000, 2000}));
  EXPECT_EQ(log.rows(), 2000U);
  // A repeated request finds them sufficient.
  EXPECT_TRUE(run_ensemble(input, layout, log, {.threads = 2, .enough = enough}));
  EXPECT_EQ(log.rows(), 2000U);
}

TEST_F(EnsembleRuns, ShareTheirSamplesWithOthers) {
  RowLog whole = new_log("whole");
  ASSERT_TRUE(run_ensemble(input_, layout_, whole, {.threads = 2}));
  RowLog log = new_log("shared");
  std::size_t shared = 0;
  const auto share = [&](RunFlow& flow) {
    const RunRange range = flow.take(5);
    for (std::size_t i = range.count; i > 0; --i) {  // returned in any order
      const std::size_t number = range.first + i - 1;
      flow.put(number, *EnsembleSampler(input_, layout_).run(number, [](double) { return true; }));
    }
    shared += range.count;
  };
  ASSERT_TRUE(run_ensemble(input_, layout_, log, {.threads = 1, .share = share}));
  EXPECT_GT(shared, 0U);
  expect_same(whole, log);
}

TEST_F(EnsembleRuns, WaitForThoseWhoTookSamples) {
  RowLog log = new_log("late");
  RunRange taken;
  const auto share = [&](RunFlow& flow) {
    if (taken.count == 0) taken = flow.take(1);
    if (taken.count == 1 && flow.done() == 59) {
      flow.put(taken.first, std::vector<double>(layout_.width()));
      taken.count = 2;
    }
  };
  ASSERT_TRUE(run_ensemble(input_, layout_, log, {.threads = 1, .share = share}));
  EXPECT_EQ(taken.count, 2U);
  EXPECT_EQ(log.rows(), 60U);
}

/// Scatter may make a bearing that is none: that sample is counted as such.
TEST(EnsembleSampler, CountsSamplesThatMakeNoBearing) {
  for (Case input : {test_support::running_ensemble_case(1), test_support::rotor_ensemble_case(1)}) {
    input.montecarlo->bump_foil_thickness = Distribution{.kind = DistributionKind::table, .values = {-1e-3}};
    const EnsembleLayout layout = make_ensemble_layout(input);
    const std::vector<double> row = EnsembleSampler(input, layout).run(0, [](double) { return true; }).value();
    ASSERT_EQ(row.size(), layout.width());
    EXPECT_EQ(layout.status_name(static_cast<int>(row.front())), "not_physical");
  }
}

}  // namespace
}  // namespace bumpfoil
