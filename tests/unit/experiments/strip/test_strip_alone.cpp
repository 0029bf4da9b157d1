// Cases of a strip between plates without a bearing: neither radius nor clearance.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/properties/properties.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::whole_case;

std::string cut(std::string text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) ADD_FAILURE() << "no " << part;
  return text.erase(at, part.size());
}

std::string whole_strip() {
  return whole_case() + "\n[strip]\nbumps = 4\ndisplacement = \"20 um\"\nsteps = 5\n";
}

std::string without_radius() {
  return cut(whole_strip(), "radius = \"19.05 mm\"\n");
}

std::string without_clearance(const std::string& text) {
  return cut(text, "radial_clearance = \"31.8 um\"\n");
}

std::string refusal(const std::string& text, const std::vector<std::string>& commands = {}) {
  try {
    static_cast<void>(parse_case(text, "case.toml", {.overrides = {}, .commands = commands}));
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(StripAlone, NeedsNeitherRadiusNorClearance) {
  const Case bearing = parse_case(whole_strip(), "case.toml");
  const Case alone = parse_case(without_clearance(without_radius()), "case.toml", {{}, {"strip"}});
  EXPECT_FALSE(bearing.bearing.is_flat());
  EXPECT_TRUE(alone.bearing.is_flat());
  EXPECT_EQ(parse_case(case_to_toml(alone), "again.toml"), alone);
  EXPECT_EQ(case_to_json(alone).find("radi"), std::string::npos);

  const CycleResult expected = run_strip(bearing);
  const CycleResult found = run_strip(alone);
  ASSERT_EQ(found.cycles.size(), expected.cycles.size());
  const std::vector<Increment>& increments = expected.cycles.front().increments;
  ASSERT_EQ(found.cycles.front().increments.size(), increments.size());
  for (std::size_t i = 0; i < increments.size(); ++i) {
    EXPECT_EQ(found.cycles.front().increments[i].force_direct, increments[i].force_direct) << i;
  }
  EXPECT_GT(increments[5].force_direct, 10.0);
}

TEST(StripAlone, HasProperties) {
  const Properties properties = compute_properties(parse_case(without_clearance(without_radius()), "case.toml"));
  const Properties expected = compute_properties(parse_case(whole_strip(), "case.toml"));
  ASSERT_EQ(properties.bumps.size(), 1U);
  EXPECT_EQ(properties.bumps.front().identified.k3, expected.bumps.front().identified.k3);
  ASSERT_TRUE(properties.bump_foil);
  EXPECT_EQ(properties.bump_foil->stiffest, expected.bump_foil->stiffest);
  // The top foil around the circumference exists for bearings only.
  EXPECT_TRUE(expected.top_foil);
  EXPECT_FALSE(properties.top_foil);
}

TEST(StripAlone, IsNoBearing) {
  const std::string radius = "case.toml:2: bearing.radius: is missing";
  const std::string clearance = "case.toml:2: bearing.radial_clearance: is missing";
  const std::string why = ": only the command strip needs none";
  EXPECT_EQ(refusal(without_clearance(without_radius()), {"cycle"}),
            radius + "; give it, or bearing.diameter" + why + '\n' + clearance + "; give it" + why);
  EXPECT_THROW(static_cast<void>(run_cycles(parse_case(without_clearance(without_radius()), "case.toml"))), Error);
}

TEST(StripAlone, HasBothOrNeither) {
  EXPECT_EQ(refusal(without_clearance(whole_strip())),
            "case.toml:2: bearing.radial_clearance: is missing; give it in the table [bearing]");
  EXPECT_EQ(
      refusal(without_radius()),
      "case.toml:2: bearing.radius: is missing, though there is a clearance; give it, or bearing.diameter; a strip "
      "alone needs neither radius nor clearance");
}

TEST(StripAlone, IsWhatSparesThem) {
  const std::string cycle = without_clearance(cut(whole_case(), "radius = \"19.05 mm\"\n"));
  EXPECT_EQ(
      refusal(cycle),
      "case.toml:2: bearing.radius: is missing; give it in the table [bearing], or bearing.diameter in its place\n"
      "case.toml:2: bearing.radial_clearance: is missing; give it in the table [bearing]");
}

}  // namespace
}  // namespace bumpfoil
