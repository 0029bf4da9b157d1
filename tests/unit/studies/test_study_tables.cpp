#include "bumpfoil/studies/study_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

/// A short study of two bearings, one with height errors.
class StudyTables : public ::testing::Test {
 protected:
  StudyTables() {
    study_.name = "test";
    study_.parameter = "length";
    study_.parameter_unit = "mm";
    study_.increments = {0, 3};
    for (const double error : {0.0, 40e-6}) {
      study_.runs.push_back(
          {.name = error > 0.0 ? "tall" : "even", .label = "", .overrides = {}, .parameter = 1e6 * error});
      StudyRunResult& run = results_.emplace_back();
      run.input = reference_case();
      CycleSettings& cycle = run.input.settings.get<CycleSettings>();
      cycle.directions = {0.0};
      cycle.steps = 3;
      run.input.bump_foil.height_errors.assign(26, 0.0);
      run.input.bump_foil.height_errors[13] = error;
      run.result = run_cycles(run.input);
    }
  }

  [[nodiscard]] StudyTable make(StudyTableKind kind) const {
    StudyTable table = make_study_table(kind, study_, results_);
    EXPECT_EQ(table.name, name_of(kind));
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    return table;
  }

  [[nodiscard]] const Increment& increment(std::size_t run, std::size_t index) const {
    return results_[run].result.cycles[0].increments[index];
  }

  [[nodiscard]] const FoilFields& fields(std::size_t run) const { return results_[run].result.cycles[0].fields; }

  static const TableCell& cell(const StudyTable& table, std::size_t row, const std::string& column) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    EXPECT_NE(found, table.columns.end()) << column;
    return table.rows[row][static_cast<std::size_t>(found - table.columns.begin())];
  }
  static double number(const StudyTable& table, std::size_t row, const std::string& column) {
    return std::get<double>(cell(table, row, column));
  }
  static std::string word(const StudyTable& table, std::size_t row, const std::string& column) {
    return std::get<std::string>(cell(table, row, column));
  }
  static int whole(const StudyTable& table, std::size_t row, const std::string& column) {
    return std::get<int>(cell(table, row, column));
  }

  Study study_;
  std::vector<StudyRunResult> results_;
};

TEST_F(StudyTables, LoopsHaveARowForEachIncrement) {
  const StudyTable table = make(StudyTableKind::loops);
  ASSERT_EQ(table.rows.size(), 2U * 7U);
  EXPECT_EQ(word(table, 7 + 4, "run"), "tall");
  EXPECT_EQ(word(table, 7 + 4, "branch"), "unloading");
  EXPECT_EQ(number(table, 7 + 4, "force_direct_N"), increment(1, 4).force_direct);
  EXPECT_EQ(number(table, 7 + 4, "displacement_m"), increment(1, 4).displacement);
}

TEST_F(StudyTables, QuantitiesAreThoseOfTheSummaryAndTheParameter) {
  const StudyTable table = make(StudyTableKind::quantities);
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_DOUBLE_EQ(number(table, 1, "length_mm"), 40.0);
  EXPECT_EQ(number(table, 1, "max_force_N"), results_[1].result.cycles[0].turning_point->max_force);
  EXPECT_EQ(number(table, 1, "clearance_5N_m"), results_[1].result.cycles[0].clearances[0].displacement);
  EXPECT_EQ(std::count(table.columns.begin(), table.columns.end(), "wall_time_s"), 0);
}

TEST_F(StudyTables, LoadsAreThoseAtFullDisplacement) {
  const StudyTable table = make(StudyTableKind::loads);
  ASSERT_EQ(table.rows.size(), 2U * 26U);
  EXPECT_EQ(whole(table, 26 + 12, "bump"), 13);
  EXPECT_EQ(number(table, 26 + 12, "bump_load_N"), fields(1).top_bump.normal_force(3, 12));
  EXPECT_EQ(number(table, 26 + 12, "journal_load_N"), fields(1).journal_top.normal_force(3, 12));
}

TEST_F(StudyTables, HeightsTellWhatTheJournalMeets) {
  const StudyTable table = make(StudyTableKind::heights);
  ASSERT_EQ(table.rows.size(), 2U * 26U);
  const std::size_t row = 26 + 13;
  EXPECT_DOUBLE_EQ(number(table, row, "height_m"), 0.508e-3 + 40e-6);
  EXPECT_DOUBLE_EQ(number(table, row, "journal_centred_m"), 0.508e-3 + 31.8e-6);
  // Bump 14 is within 6 degrees of +X, where the journal approaches by its full displacement.
  EXPECT_NEAR(number(table, row, "journal_pushed_m"), 0.508e-3 + 31.8e-6 - 79.5e-6, 0.006 * 79.5e-6);
}

TEST_F(StudyTables, FoilsAreDrawnFromTheirGaps) {
  const StudyTable table = make(StudyTableKind::foils);
  ASSERT_EQ(table.rows.size(), 2U * 2U * 26U);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    // Heights differ by the gaps; both are about 1e-4 m, computed from terms of 5e-4 m.
    const double rounding = 1e-18;
    EXPECT_NEAR(number(table, row, "journal_height_m") - number(table, row, "top_foil_height_m"),
                number(table, row, "gap_journal_top_m"), rounding);
    EXPECT_NEAR(number(table, row, "top_foil_height_m") - number(table, row, "crest_height_m"),
                number(table, row, "gap_top_bump_m"), rounding);
    EXPECT_EQ(number(table, row, "foot_height_m"), number(table, row, "gap_bump_sleeve_m"));
  }
  const std::size_t row = 26 + 12;  // first run, full displacement, bump 13
  EXPECT_EQ(whole(table, row, "increment"), 3);
  EXPECT_EQ(word(table, row, "state_journal_top"), "stick");
  EXPECT_EQ(number(table, row, "normal_force_bump_sleeve_N"), fields(0).bump_sleeve.normal_force(3, 12));
  EXPECT_EQ(word(table, 0, "state_journal_top"), "open");
}

TEST_F(StudyTables, ContactsAreCounted) {
  const StudyTable table = make(StudyTableKind::contacts);
  ASSERT_EQ(table.rows.size(), 2U * 7U);
  const auto closed = [this](std::size_t index) {
    const auto modes = fields(1).journal_top.mode.row(static_cast<Eigen::Index>(index));
    return static_cast<int>(std::count_if(modes.begin(), modes.end(), [](auto m) { return m != ContactMode::open; }));
  };
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(whole(table, 7 + i, "closed_journal_top"), closed(i));
    if (i == 0) continue;
    EXPECT_EQ(whole(table, 7 + i, "newly_closed_journal_top") - whole(table, 7 + i, "newly_open_journal_top"),
              closed(i) - closed(i - 1));
  }
  EXPECT_GT(closed(3), closed(0));
  EXPECT_EQ(whole(table, 7 + 3, "slipping_journal_top"), 0);
  EXPECT_GT(whole(table, 7 + 3, "slipping_bump_sleeve"), 0);
}

TEST(StudyTablesCsv, LeavesOutWhatIsNotKnown) {
  StudyTable table{.name = "t", .columns = {"a", "b", "c"}, .rows = {}};
  table.rows.push_back({std::string("x"), 1, 0.1});
  table.rows.push_back({TableCell(), std::numeric_limits<double>::quiet_NaN(), -2.0});
  EXPECT_EQ(table_csv(table), "a,b,c\nx,1,0.10000000000000001\n,,-2\n");
}

}  // namespace
}  // namespace bumpfoil
