// A file of heights beside the case that names it.

#include "bumpfoil/case/case_reader.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "support/case_texts.hpp"
#include "support/temporary_folder.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::cut;
using test_support::TemporaryFolder;
using test_support::whole_case;

TEST(HeightErrorsFile, GivesHeightsOverThoseOfItsBumps) {
  const TemporaryFolder folder;
  std::string heights = "height_mm\n";
  for (int n = 0; n < 26; ++n) heights += n < 2 ? "0.505\n" : "0.510\n";
  folder.write("heights.csv", heights);
  std::string text = cut(whole_case(), "height_errors = []");
  text.insert(text.find("[bump_foil]") + 11, "\nheight_errors_file = \"heights.csv\"");
  text += "[[bump_foil.section]]\nfrom = 1\nto = 2\nheight = \"0.5 mm\"\n";
  const Case input = parse_case(text, (folder.path() / "case.toml").string());
  EXPECT_NEAR(input.bump_foil.height_errors[1], 5e-6, 1e-15);  // roundings of the heights
  EXPECT_NEAR(input.bump_foil.height_errors[2], 2e-6, 1e-15);
}

TEST(HeightErrorsFile, IsReadBesideTheCase) {
  const TemporaryFolder folder;
  std::string csv = "bump, height_error_m\n";
  for (int bump = 26; bump >= 1; --bump) csv += std::to_string(bump) + "," + std::to_string(bump) + "e-7\r\n";
  folder.write("deep/heights.csv", csv);
  const CaseRequest request{.overrides = {"bump_foil.height_errors_file=heights.csv"}, .commands = {}};
  const Case input = read_case(folder.write("deep/case.toml", whole_case()), request);
  ASSERT_EQ(input.bump_foil.height_errors.size(), 26U);
  EXPECT_EQ(input.bump_foil.height_errors[0], 1e-7);
  EXPECT_EQ(input.bump_foil.height_errors[25], 26e-7);
}

TEST(HeightErrorsFile, HasItsOwnLines) {
  const TemporaryFolder folder;
  folder.write(
      "heights.csv",
      "bump,height_error_m\n1,1e-6\n1,2e-6\n27,0\n2,x\n3\n4,1,2\n\n5,nan\n6,1 um\n7,+-2e-6\n+8,+2e-6\n+-9,0\n");
  const CaseRequest request{.overrides = {"bump_foil.height_errors_file=heights.csv", "bearing.radius=0"},
                            .commands = {}};
  try {
    read_case(folder.write("case.toml", whole_case()), request);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    std::vector<std::size_t> lines;
    for (const InputError& one : error.errors()) {
      if (one.file.ends_with("heights.csv")) lines.push_back(one.line);
    }
    EXPECT_EQ(lines, (std::vector<std::size_t>{3, 4, 5, 6, 7, 9, 10, 11, 13})) << error.what();
    EXPECT_NE(std::string(error.what()).find("repeats bump 1, given in line 2"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("bearing.radius"), std::string::npos);
  }
}

TEST(HeightErrorsFile, IsReadBesideAWrongListOfDimensions) {
  const TemporaryFolder folder;
  folder.write("heights.csv", "height_mm\n0.505\n0.5x\n");
  const std::string path = folder.write("case.toml", whole_case());
  for (const std::string dimension : {"pitch", "length", "height", "thickness"}) {
    try {
      read_case(path, {.overrides = {"bump_foil.height_errors_file=heights.csv",
                                     fmt::format("bump_foil.{}=[0.0001, 0.0001]", dimension)},
                       .commands = {}});
      ADD_FAILURE();
    } catch (const Error& error) {
      ASSERT_EQ(error.errors().size(), 2U) << error.what();
      EXPECT_EQ(error.errors()[0].key, "bump_foil." + dimension);
      EXPECT_EQ(error.errors()[1].line, 3U) << error.what();
    }
  }
  // Without nominal heights, valid ones cause no message.
  std::string heights = "height_mm\n";
  for (int bump = 0; bump < 26; ++bump) heights += "0.505\n";
  folder.write("heights.csv", heights);
  try {
    read_case(path, {.overrides = {"bump_foil.height_errors_file=heights.csv", "bump_foil.pitch=[0.004, 0.004]"},
                     .commands = {}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.errors().size(), 1U) << error.what();
  }
}

TEST(HeightErrorsFile, MayNotBeEmpty) {
  const TemporaryFolder folder;
  const std::string path = folder.write("case.toml", whole_case());
  for (const std::string content : {"", " \r\n\n", "# measured\n"}) {
    folder.write("heights.csv", content);
    try {
      read_case(path, {.overrides = {"bump_foil.height_errors_file=heights.csv"}, .commands = {}});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_NE(
          std::string(error.what()).find("is empty; write bump,height_error_um and one line for each of 26 bumps"),
          std::string::npos)
          << error.what();
    }
  }
}

/// As instruments and spreadsheets write them.
TEST(HeightErrorsFile, MayBeWrittenInManyWays) {
  const TemporaryFolder folder;
  const std::string path = folder.write("case.toml", whole_case());
  const auto third = [&](const std::string& header, const std::string& begin, const std::string& end) {
    std::string csv = "# probe 4\n\n" + header + "\n";
    for (int bump = 1; bump <= 26; ++bump) {
      csv += bump == 3 ? begin + "3" + end + "\n# again\n" : begin + std::to_string(bump) + end + "\n";
    }
    folder.write("heights.csv", csv);
    const Case input = read_case(path, {.overrides = {"bump_foil.height_errors_file=heights.csv"}, .commands = {}});
    return input.bump_foil.height_errors[2];
  };
  EXPECT_DOUBLE_EQ(third("bump;height_error_um", "", ";4,25"), 4.25e-6);
  EXPECT_DOUBLE_EQ(third("operator\tbump\theight_error_mm\tdate", "NN\t", "\t-0,00425\t3.2.2026"), -4.25e-6);
  EXPECT_DOUBLE_EQ(third("bump , height_error_nm", "", " , 4250"), 4.25e-6);
  EXPECT_NEAR(third("height_mm;bump", "0,5123;", ""), 4.3e-6, 1e-18);  // over 0.508 mm
  EXPECT_DOUBLE_EQ(third("height_error_um", "", ""), 3e-6);            // from the weld on
}

TEST(HeightErrorsFile, SaysHowItWasUnderstood) {
  const TemporaryFolder folder;
  const std::string path = folder.write("case.toml", whole_case());
  const auto error = [&](const std::string& csv) -> std::string {
    folder.write("heights.csv", csv);
    try {
      read_case(path, {.overrides = {"bump_foil.height_errors_file=heights.csv"}, .commands = {}});
    } catch (const Error& error) {
      EXPECT_EQ(error.errors().size(), 1U) << error.what();
      return format_error(error.errors()[0]);
    }
    return "none";
  };
  const auto says = [&](const std::string& csv, const std::string& text) {
    EXPECT_NE(error(csv).find(text), std::string::npos) << error(csv);
  };
  std::string in_um;
  for (int bump = 1; bump <= 26; ++bump) in_um += std::to_string(bump) + ",4.2\n";
  says("bump,height_error_m\n" + in_um, "heights.csv:2");
  says("bump,height_error_m\n" + in_um, "and 25 more lie further from the nominal height than a bump rises");
  says("bump,height_error_m\n" + in_um, "micrometres in a column of metres?");
  says("bump;size\n1;2\n", "has no column of heights among its 2 columns, separated by semicolons");
  says("bump,height_um,height_error_um\n", "has 2 columns of heights among its 3 columns, separated by commas");
  std::string decimal_commas;
  for (int bump = 1; bump <= 25; ++bump) decimal_commas += std::to_string(bump) + ",4\n";
  says("bump,height_error_um\n" + decimal_commas + "26,4,2\n", "has 3 columns, separated by commas, and the header 2");
  says(
      "height_error_um\n" +
          [] {
            std::string lines;
            for (int line = 0; line < 27; ++line) lines += "1\n";
            return lines;
          }(),
      "heights.csv:28");
}

TEST(HeightErrorsFile, MustNameEveryBump) {
  const TemporaryFolder folder;
  std::string csv = "bump,height_error_m\n";
  for (int bump = 1; bump <= 24; ++bump) csv += std::to_string(bump) + ",0\n";
  folder.write("heights.csv", csv);
  const CaseRequest request{.overrides = {"bump_foil.height_errors_file=heights.csv"}, .commands = {}};
  try {
    read_case(folder.write("case.toml", whole_case()), request);
    ADD_FAILURE();
  } catch (const Error& error) {
    ASSERT_EQ(error.errors().size(), 1U);
    EXPECT_EQ(error.errors()[0].what, "lacks bumps 25 to 26");
  }
}

}  // namespace
}  // namespace bumpfoil
