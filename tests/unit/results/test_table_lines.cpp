#include "results/table_lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bumpfoil {
namespace {

Table some_table() {
  Table table;
  table.add(shown_column("speed", shown::revolutions), {100.0, 200.0});
  table.add(shown_column("minimum film thickness", shown::micrometres), {5e-6, absent});
  table.add({"stable", "1", "", yes_or_no, "stable"}, {1.0, absent});
  table.add({"turns", "1", "", whole_number, "turns"}, {12.0, 7.0});
  return table;
}

TEST(TableLines, HaveARowEachUnderLabelsAndUnits) {
  EXPECT_EQ(table_lines(some_table()),
            "        minimum film\n"
            " speed     thickness  stable  turns\n"
            "   rpm            um\n"
            "954.93        5.0000     yes     12\n"
            "1909.9             -       -      7\n");
}

TEST(TableLines, NameRowsByAFirstColumnOfTexts) {
  Table table;
  table.add(shown_column("key"), std::vector<std::string>{"bearing.radius", "a"});
  table.add(shown_column("value", {"um", 1e-6}), {absent, absent});
  EXPECT_EQ(table_lines(table),
            "key             value\n"
            "bearing.radius      -\n"
            "a                   -\n")
      << "a unit without a value";
}

TEST(TableLines, PutRowsSideBySideInParts) {
  Table table;
  std::vector<std::string> names;
  std::vector<double> forces;
  for (int i = 1; i <= 7; ++i) {
    names.push_back("cycle " + std::to_string(i));
    forces.push_back(i);
  }
  table.add(shown_column(""), names);
  table.add(shown_column("maximum force", shown::newtons), forces);
  const std::string text = table_blocks(table);
  EXPECT_EQ(text.substr(text.find("\n\n") + 2),
            "                      cycle 7\n"
            "-----------------------------\n"
            "maximum force  N       7.0000\n");
  EXPECT_NE(text.find("      6.0000\n"), std::string::npos) << text;
}

TEST(TableLines, IndentLabelsThatContinueTheOneAbove) {
  Table table;
  for (const char* label : {"torque", "torque: of asperities", "torque: of the film", "power", "torque: elsewhere"}) {
    table.add(shown_column(label, shown::watts), std::vector<double>{1.0});
  }
  EXPECT_EQ(table_blocks(table),
            "torque             W       1.0000\n"
            "  of asperities    W       1.0000\n"
            "  of the film      W       1.0000\n"
            "power              W       1.0000\n"
            "torque: elsewhere  W       1.0000\n");
}

TEST(TableLines, SayWhatIsLeftOut) {
  EXPECT_EQ(left_out("speeds", 40, 60), "speeds 41 to 60 are in the files only\n");
  EXPECT_EQ(left_out("speeds", 40, 40), "");
}

}  // namespace
}  // namespace bumpfoil
