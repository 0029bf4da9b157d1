#include "bumpfoil/ensemble/ensemble_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

TEST(EnsembleTable, ShowsEveryDirectionAndEveryFailure) {
  const EnsembleLayout layout = make_ensemble_layout(test_support::ensemble_case(3));
  EnsembleStatistics statistics{.samples = 2,
                                .places = {},
                                .failures = {{.sample = 17, .place = 1, .status = static_cast<int>(Status::no_modes)}}};
  for (int direction = 0; direction < 2; ++direction) {
    PlaceStatistics& of_direction = statistics.places.emplace_back();
    of_direction.columns.assign(layout.columns.size(), statistics_of({}));
    of_direction.columns[1] = statistics_of({100.0, 200.0});
  }
  const std::string table = ensemble_table(layout, statistics);
  EXPECT_NE(table.find("\n\n-X "), std::string::npos) << table;
  const std::size_t row = table.find("\nmaximum force");
  ASSERT_NE(row, std::string::npos) << table;
  const std::string line = table.substr(row + 1, table.find('\n', row + 1) - row - 1);
  for (const char* number : {" N ", " 150", " 50", " 70.7", " 105", " 195"}) {
    EXPECT_NE(line.find(number), std::string::npos) << line;
  }
  EXPECT_NE(table.find("clearance at 5 N                         "), std::string::npos) << "a unit without a value";
  EXPECT_EQ(failure_lines(layout, statistics),
            (std::vector<std::string>{"sample 17, -X: " + std::string(explanation(Status::no_modes))}));
}

TEST(EnsembleTable, TellsHowManySamplesAreStable) {
  const EnsembleLayout states = make_ensemble_layout(test_support::running_ensemble_case(4));
  const auto stable = std::find_if(states.columns.begin(), states.columns.end(),
                                   [](const EnsembleColumn& one) { return one.meaning.name == "stable"; });
  ASSERT_NE(stable, states.columns.end());
  EnsembleStatistics statistics{.samples = 5, .places = std::vector<PlaceStatistics>(2), .failures = {}};
  for (PlaceStatistics& place : statistics.places) place.columns.assign(states.columns.size(), statistics_of({1.0}));
  const auto of_place = [&](std::size_t place) -> Statistics& {
    return statistics.places[place].columns[static_cast<std::size_t>(stable - states.columns.begin())];
  };
  of_place(0) = statistics_of({1.0, 0.0, 1.0, 1.0, 1.0});
  of_place(1) = statistics_of({1.0, 0.0, absent, 0.0, absent});
  const std::string table = ensemble_table(states, statistics);
  EXPECT_NE(table.find("\nstable, journal held: 4 of 5 samples, 80.0 %\n"), std::string::npos) << table;
  EXPECT_TRUE(table.ends_with("\nstable, journal held: 1 of 3 samples, 33.3 %; of 2 it is not known\n")) << table;

  const EnsembleLayout cycles = make_ensemble_layout(test_support::ensemble_case(3));
  for (PlaceStatistics& place : statistics.places) place.columns.assign(cycles.columns.size(), statistics_of({1.0}));
  const std::string of_cycles = ensemble_table(cycles, statistics);
  EXPECT_EQ(of_cycles.find("stable"), std::string::npos);
  EXPECT_EQ(of_cycles.find("residual"), std::string::npos) << of_cycles;  // of the solver
  EXPECT_EQ(of_cycles.find("\n "), std::string::npos) << "a row without a label: " << of_cycles;
}

TEST(EnsembleTable, TellsHowManyRotorsWhirlNowhereAndHowManyFromTheBegin) {
  const EnsembleLayout rotors = make_ensemble_layout(test_support::rotor_ensemble_case(4));
  EnsembleStatistics statistics{.samples = 4, .places = std::vector<PlaceStatistics>(1), .failures = {}};
  for (const EnsembleColumn& column : rotors.columns) {
    std::vector<double> values{1382.3, 1361.4, absent, absent};
    if (column.meaning.name == "stable_throughout") values = {0.0, 0.0, 1.0, 0.0};
    if (column.meaning.name == "unstable_at_lowest") values = {0.0, 0.0, 0.0, 1.0};
    statistics.places[0].columns.push_back(statistics_of(values));
  }
  const std::string table = ensemble_table(rotors, statistics);
  EXPECT_NE(table.find("\nonset of whirl              rpm        13100 "), std::string::npos) << table;
  EXPECT_TRUE(
      table.ends_with("\nstable at all speeds: 1 of 4 samples, 25.0 %\n"
                      "unstable at the lowest speed: 1 of 4 samples, 25.0 %\n"))
      << table;
}

/// Statistics over several branches describe none of them.
TEST(EnsembleTable, WarnsWhereSamplesLieOnSeveralBranches) {
  const EnsembleLayout cycles = make_ensemble_layout(test_support::ensemble_case(3));
  EnsembleStatistics statistics{.samples = 4, .places = std::vector<PlaceStatistics>(2), .failures = {}};
  for (PlaceStatistics& place : statistics.places)
    place.columns.assign(cycles.columns.size(), statistics_of({1.0, 2.0}));
  EXPECT_TRUE(warning_lines(test_support::ensemble_case(3), cycles, statistics).empty());  // they have no branches

  const EnsembleLayout states = make_ensemble_layout(test_support::running_ensemble_case(4));
  const auto column = [&](std::string_view name) {
    const auto found = std::find_if(states.columns.begin(), states.columns.end(),
                                    [name](const EnsembleColumn& one) { return one.meaning.name == name; });
    return static_cast<std::size_t>(found - states.columns.begin());
  };
  const auto lines_for = [&](const std::vector<double>& jumps, const std::vector<double>& lifted) {
    statistics.places.assign(states.places.size(), {});
    for (PlaceStatistics& place : statistics.places) {
      place.columns.assign(states.columns.size(), statistics_of({1.0, 1.0, 1.0, 1.0}));
    }
    statistics.places.back().columns.at(column("jumps")) = statistics_of(jumps);
    statistics.places.back().columns.at(column("lifted_bumps_at_entry")) = statistics_of(lifted);
    return warning_lines(test_support::running_ensemble_case(4), states, statistics);
  };
  EXPECT_TRUE(lines_for({0.0, 0.0, 0.0, 0.0}, {4.0, 4.0, 5.0, 5.0}).empty());  // one bump more is due to heights
  EXPECT_TRUE(lines_for({1.0, 1.0, 1.0, 1.0}, {4.0, 4.0, 4.0, 4.0}).empty());
  EXPECT_EQ(lines_for({1.0, 0.0, 1.0, 0.0}, {4.0, 4.0, 4.0, 4.0}).size(), 1U);
  const std::vector<std::string> lines = lines_for({0.0, 0.0, 0.0, 0.0}, {4.0, 4.0, 7.0, 7.0});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].starts_with(states.places.back().name + ": the samples lie on several branches")) << lines[0];
}

}  // namespace
}  // namespace bumpfoil
