#include "bumpfoil/experiments/properties/properties_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

TEST(PropertiesTable, SaysWhichConstantsWereGiven) {
  Case input = reference_case();
  input.bump_foil.truss.k2 = 5e6;
  const std::string text = properties_table(input, compute_properties(input));
  EXPECT_NE(text.find("5.0000 MN/m  given\n"), std::string::npos) << text;
  EXPECT_NE(text.find("identified\n"), std::string::npos);
  EXPECT_EQ(text.find(" \n"), std::string::npos) << "blanks at the end of a line";
}

TEST(PropertiesTable, DashesStandForWhatIsNotKnown) {
  const Case input = reference_case();
  Properties properties = compute_properties(input);
  properties.bump_foil.reset();
  properties.bumps.front().loading_bump.reset();
  const std::string text = properties_table(input, properties);
  EXPECT_NE(text.find(" - N/m\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" - MN/m\n"), std::string::npos);
}

TEST(PropertiesTable, HasALineForEachShapeOfBumps) {
  Case input = reference_case();
  input.bump_foil.sections = {{.from = 3, .to = 5, .thickness = 0.127e-3}};
  const Properties properties = compute_properties(input);
  const std::string text = properties_table(input, properties);
  for (const char* line :
       {"\n1 to 2        4.5720  0.40600   1.0160   0.10200",
        "\n3 to 5        4.5720  0.38100   1.0160   0.12700     245.40     12.441     2.1011     21.270   15.267     "
        "3.8442     1.6081\n",
        "\n6 to 26       4.5720  0.40600   1.0160   0.10200"}) {
    EXPECT_NE(text.find(line), std::string::npos) << text;
  }
  const auto json = nlohmann::json::parse(properties_json(input, properties));
  ASSERT_EQ(json.at("bumps").size(), 3U);
  EXPECT_EQ(json.at("bumps").at(1).at("from"), 3);
  EXPECT_EQ(json.at("bumps").at(1).at("to"), 5);
  EXPECT_EQ(json.at("bumps").at(1).at("truss").at("k1_N_per_m"), properties.bumps[1].identified.k1);
  EXPECT_FALSE(json.contains("truss"));
  EXPECT_EQ(json.at("top_foil").at("softest_N_per_m"), properties.top_foil->softest);
}

TEST(PropertiesTable, ListsStripsWithBumpsOfTheirOwn) {
  Case input = reference_case();
  input.width.modes = 3;
  input.bump_foil.strips = 2;
  input.bump_foil.strip.resize(2);
  input.bump_foil.strip[0].thickness = 0.127e-3;
  input.bump_foil.strip[1].sections = {{.from = 3, .to = 5, .length = 3.5e-3, .thickness = 0.1e-3}};
  const Properties properties = compute_properties(input);
  const std::string text = properties_table(input, properties);
  EXPECT_NE(text.find("\nStrip 1, with bumps of its own, 19.050 mm wide\n\nArc of a bump"), std::string::npos) << text;
  EXPECT_NE(text.find("\nStrip 2, with bumps of its own, 19.050 mm wide\n\nBumps "), std::string::npos);
  EXPECT_NE(text.find("\n3 to 5 "), std::string::npos);
  const auto json = nlohmann::json::parse(properties_json(input, properties));
  EXPECT_EQ(json.at("strips").at(0).at("truss").at("k1_N_per_m"), properties.strips[0].bumps.front().identified.k1);
  EXPECT_EQ(json.at("strips").at(0).at("width_m"), 0.5 * input.bearing.axial_length);
  EXPECT_EQ(json.at("strips").at(1).at("strip"), 2);
  EXPECT_EQ(json.at("strips").at(1).at("bumps").size(), 3U);
  EXPECT_EQ(json.at("strips").at(1).at("bump_foil").at("softest_N_per_m"), properties.strips[1].bump_foil->softest);
}

TEST(PropertiesTable, SaysWhichSpringsThereCannotBe) {
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.length = 3.2e-3;  // k2 < 0
  const std::string text = properties_table(input, compute_properties(input));
  EXPECT_NE(text.find("-5.3552 MN/m  identified; no spring is negative"), std::string::npos) << text;
  input.bump_foil.truss.k2 = 1e6;
  EXPECT_EQ(properties_table(input, compute_properties(input)).find("no spring is negative"), std::string::npos);
}

TEST(PropertiesJson, IsInSi) {
  Case input = reference_case();
  input.bump_foil.truss.k2 = 5e6;
  const Properties properties = compute_properties(input);
  const auto json = nlohmann::json::parse(properties_json(input, properties));
  EXPECT_EQ(json.at("arc").at("rise_m"), properties.bumps.front().arc.rise);
  EXPECT_EQ(json.at("truss").at("k1_N_per_m"), properties.bumps.front().identified.k1);
  EXPECT_EQ(json.at("truss").at("k2_N_per_m"), 5e6);
  EXPECT_EQ(json.at("truss").at("theta_d_rad"), properties.bumps.front().identified.theta_d);
  EXPECT_EQ(json.at("cell").at("crest_stiffness_N_per_m"), properties.bumps.front().cell.crest_stiffness());
  EXPECT_EQ(json.at("single_bump").at("guided_N_per_m"), properties.bumps.front().guided_bump);
  EXPECT_EQ(json.at("top_foil").at("softest_N_per_m"), properties.top_foil->softest);
}

TEST(PropertiesJson, NullStandsForWhatIsNotKnown) {
  Properties properties = compute_properties(reference_case());
  properties.top_foil.reset();
  const auto json = nlohmann::json::parse(properties_json(reference_case(), properties));
  EXPECT_TRUE(json.at("top_foil").at("softest_N_per_m").is_null());
}

}  // namespace
}  // namespace bumpfoil
