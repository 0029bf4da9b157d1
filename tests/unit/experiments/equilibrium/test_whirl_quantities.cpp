#include "experiments/equilibrium/whirl_quantities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

FilmWhirl whirl_at(double frequency) {
  Eigen::Matrix2cd Z;
  Z << std::complex<double>(1.0, 8.0), 2.0, std::complex<double>(3.0, -4.0), 4.0;
  return {.frequency = frequency, .impedance = frequency * Z, .stuck_impedance = std::nullopt};
}

double value_of(const std::string& name, const FilmWhirl& whirl) {
  const auto& all = whirl_quantities(2);
  return std::find_if(all.begin(), all.end(), [&](const WhirlQuantity& one) { return one.name() == name; })
      ->value(whirl);
}

TEST(WhirlQuantities, AreTheRealAndTheImaginaryPart) {
  ASSERT_EQ(whirl_quantities(2).size(), 16U);
  EXPECT_EQ(value_of("kyx", whirl_at(2.0)), 6.0);
  EXPECT_EQ(value_of("cxx", whirl_at(2.0)), 8.0);
  EXPECT_EQ(value_of("cyx", whirl_at(2.0)), -4.0);
  EXPECT_TRUE(std::isnan(value_of("kyx_stuck", whirl_at(2.0))));
  const WhirlQuantity& last = whirl_quantities(2).back();
  EXPECT_EQ(last.name("_at_frequency"), "cyy_at_frequency_stuck");
  EXPECT_EQ(last.unit, "N s/m");
  EXPECT_EQ(last.long_name, "dF_y/d(dy/dt) at the frequency, full stick");
}

/// Forces and moments per displacement and slope determine the units.
TEST(WhirlQuantities, AreSixteenOfEachWhereTheJournalMayTilt) {
  const std::vector<WhirlQuantity>& all = whirl_quantities(4);
  ASSERT_EQ(all.size(), 64U);
  const auto unit_of = [&](const std::string& name) {
    return std::find_if(all.begin(), all.end(), [&](const WhirlQuantity& one) { return one.name() == name; })->unit;
  };
  EXPECT_EQ(unit_of("kxy"), "N/m");
  EXPECT_EQ(unit_of("kxa"), "N/rad");
  EXPECT_EQ(unit_of("kbx"), "N");
  EXPECT_EQ(unit_of("kba"), "N m/rad");
  EXPECT_EQ(unit_of("cxa"), "N s/rad");
  EXPECT_EQ(unit_of("cbx"), "N s");
  EXPECT_EQ(unit_of("cab"), "N m s/rad");
  FilmWhirl whirl{.frequency = 2.0, .impedance = JournalMatrixC::Zero(4, 4), .stuck_impedance = std::nullopt};
  (*whirl.impedance)(3, 2) = {5.0, 8.0};
  const auto found = std::find_if(all.begin(), all.end(), [](const WhirlQuantity& one) { return one.name() == "cba"; });
  EXPECT_EQ(found->value(whirl), 4.0);
  EXPECT_EQ(found->long_name, "dM_y/d(da/dt) at the frequency, sliding contacts keep sliding");
}

/// Two states, the second of which was not found.
EquilibriumResult whirling_example(bool tabulated) {
  EquilibriumResult result;
  result.bearing = std::make_shared<const BearingModel>(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}));
  result.states.resize(2);
  result.states[0].report.status = Status::converged;
  result.states[0].whirls = {whirl_at(7.0), whirl_at(5.0)};
  if (tabulated) result.states[0].tabulated.resize(9, whirl_at(1.0));
  return result;
}

TEST(WhirlQuantities, StandInDatasetsOverTheFrequenciesOfTheCase) {
  const EquilibriumSettings settings{.speeds = {10.0}, .frequencies = {7.0, 5.0}};
  Dataset data;
  add_whirls(settings, whirling_example(false), {"state"}, {1, 0}, data);
  ASSERT_EQ(data.dims.size(), 1U);
  EXPECT_EQ(data.dims[0].name, "frequency");
  EXPECT_EQ(data.coordinates.at(0).values(), settings.frequencies);
  ASSERT_EQ(data.variables.size(), 16U);
  EXPECT_EQ(data.variables[0].meaning.name, "kxx_at_frequency");
  EXPECT_EQ(data.variables[0].dims, (std::vector<std::string>{"state", "frequency"}));
  const std::vector<double> values = data.variables[0].values();
  ASSERT_EQ(values.size(), 4U);
  EXPECT_TRUE(std::isnan(values[0]) && std::isnan(values[1]));
  EXPECT_EQ(values[2], 7.0);
  EXPECT_EQ(values[3], 5.0);
}

TEST(WhirlQuantities, OfCasesThatNameNoFrequencyAreThoseTabulatedIfAny) {
  const EquilibriumSettings settings{.speeds = {10.0}};
  EXPECT_TRUE(common_frequencies(settings, whirling_example(false)).empty());
  EXPECT_EQ(common_frequencies(settings, whirling_example(true)), tabulated_frequencies(settings));
  Dataset data;
  add_whirls(settings, whirling_example(false), {"state"}, {0, 1}, data);
  EXPECT_TRUE(data.dims.empty() && data.variables.empty());
}

}  // namespace
}  // namespace bumpfoil
