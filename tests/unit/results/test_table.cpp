#include "bumpfoil/results/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

/// Two speeds, three stations with names, and quantities over both, one of them and none.
Dataset grid() {
  Dataset data;
  data.add_dimension({"speed", "rad/s", ""}, {10.0, 20.0});
  data.add_dimension({"station", "1", ""}, {1.0, 2.0, 3.0});
  data.coordinates.back().names = {"left", "right", "disc"};
  data.add({"amplitude", "m", ""}, {"speed", "station"}, std::vector<double>{11.0, 12.0, 13.0, 21.0, 22.0, 23.0});
  data.add({"h_min", "m", ""}, {"speed"}, std::vector<double>{1.0, 2.0});
  data.add({"mass", "kg", ""}, {}, std::vector<double>{5.0});
  data.add({"power", "W", ""}, {"station"}, std::vector<double>{});
  return data;
}

TEST(Table, HasARowForEveryCombinationOfEntries) {
  const Table table =
      table_of(grid(), {.over = {"station", "speed"}, .columns = {"speed", "station", "amplitude", "h_min", "mass"}});
  ASSERT_EQ(table.rows(), 6U);
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{10.0, 20.0, 10.0, 20.0, 10.0, 20.0}));
  EXPECT_EQ(table.columns[1].texts, (std::vector<std::string>{"left", "left", "right", "right", "disc", "disc"}));
  EXPECT_EQ(table.columns[2].values, (std::vector<double>{11.0, 21.0, 12.0, 22.0, 13.0, 23.0}));
  EXPECT_EQ(table.columns[3].values, (std::vector<double>{1.0, 2.0, 1.0, 2.0, 1.0, 2.0}));
  EXPECT_EQ(table.columns[4].values, std::vector<double>(6, 5.0));
}

TEST(Table, HasTheRowsThatAreGiven) {
  const Table table = table_of(
      grid(),
      {.over = {"speed", "station"}, .columns = {"speed", "amplitude"}, .rows = {{{1, 2}, {0, no_entry}, {0, 1}}}});
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{20.0, 10.0, 10.0}));
  EXPECT_EQ(table.columns[1].values[0], 23.0);
  EXPECT_TRUE(std::isnan(table.columns[1].values[1]));
  EXPECT_EQ(table.columns[1].values[2], 12.0);
  const std::vector<std::vector<std::size_t>> none;
  EXPECT_EQ(table_of(grid(), {.over = {"speed"}, .columns = {"speed"}, .rows = none}).rows(), 0U);
}

TEST(Table, OfNoDimensionIsOneRow) {
  const Table table = table_of(grid(), {.columns = {"mass"}});
  EXPECT_EQ(table.columns[0].values, std::vector<double>{5.0});
}

TEST(Table, HasAbsentNumbersWhereNoneAreKnown) {
  Table table = table_of(grid(), {.over = {"station"}, .columns = {"station", "power"}});
  ASSERT_EQ(table.columns[1].values.size(), 3U);
  EXPECT_TRUE(std::isnan(table.columns[1].values[2]));
  table.erase("power_W");
  ASSERT_EQ(table.columns.size(), 1U);
  EXPECT_EQ(table.columns[0].meaning.name, "station");
}

TEST(Table, OfAGrowingDimensionHasTheEntriesInMemory) {
  Dataset data;
  data.dims.push_back({.name = "increment", .grows = true});
  data.coordinates.push_back(
      {.meaning = {"increment", "1", "", whole_number},
       .dims = {"increment"},
       .rows = [](std::size_t first, std::size_t count) { return numbers_from(static_cast<double>(first), count); }});
  VariableMeaning force{"force", "N", ""};
  force.tags = tag::csv;
  data.add(force, {"increment"}, std::vector<double>{3.0, 4.0});
  data.add({"not_listed", "N", ""}, {"increment"}, std::vector<double>{5.0, 6.0});
  const Table table = grown_table(data, 7);
  ASSERT_EQ(table.columns.size(), 2U);
  EXPECT_EQ(table.columns[0].values, (std::vector<double>{7.0, 8.0}));
  EXPECT_EQ(table.columns[1].values, (std::vector<double>{3.0, 4.0}));
}

}  // namespace
}  // namespace bumpfoil
