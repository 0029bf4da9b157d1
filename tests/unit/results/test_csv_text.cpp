#include "bumpfoil/results/csv_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

namespace bumpfoil {
namespace {

TEST(CsvText, WritesEachFormInItsWay) {
  static constexpr std::array<std::string_view, 2> words{"loading", "unloading"};
  Table table;
  table.add({"force_x", "N", ""}, {0.1, absent});
  table.add({"increment", "1", "", whole_number}, {12.0, 13.0});
  table.add({"settled", "1", "", yes_or_no}, {1.0, 0.0});
  table.add({"branch", "", "", {Form::flag, words}}, {1.0, absent});
  EXPECT_EQ(csv_text(table),
            "force_x_N,increment,settled,branch\n"
            "0.10000000000000001,12,true,unloading\n"
            ",13,false,\n");
  EXPECT_EQ(csv_header(table) + csv_rows(table), csv_text(table));
}

TEST(CsvText, QuotesTextsThatNeedIt) {
  Table table;
  table.add({"station", "", ""}, std::vector<std::string>{"disc", "a, b", "5\" disc"});
  EXPECT_EQ(csv_text(table), "station\ndisc\n\"a, b\"\n\"5\"\" disc\"\n");
}

}  // namespace
}  // namespace bumpfoil
