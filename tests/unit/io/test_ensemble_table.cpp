#include "bumpfoil/io/ensemble_table.hpp"

#include <gtest/gtest.h>

#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

TEST(EnsembleTable, ShowsEveryDirectionAndEveryFailure) {
  const EnsembleLayout layout = make_ensemble_layout(testing::ensemble_case(3));
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

}  // namespace
}  // namespace bumpfoil
