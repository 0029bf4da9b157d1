#include "bumpfoil/experiments/cycle/result_quantities.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

Case measured_case() {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0};
  cycle.steps = 3;
  return input;
}

const CycleQuantity& called(const std::vector<CycleQuantity>& quantities, std::string_view name) {
  const auto found =
      std::find_if(quantities.begin(), quantities.end(), [&](const auto& quantity) { return quantity.name == name; });
  EXPECT_NE(found, quantities.end()) << name;
  return *found;
}

/// Every quantity has a self-contained description, and a unique name.
template <typename Quantities>
void expect_described(const Quantities& quantities, const Wording& wording, std::set<std::string_view>& names) {
  for (const auto& quantity : quantities) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    const std::string long_name = spelled(quantity.long_name, wording);
    EXPECT_FALSE(long_name.empty()) << quantity.name;
    EXPECT_EQ(long_name.find('{'), std::string::npos) << long_name;
  }
}

TEST(ResultQuantities, AreDescribedOnce) {
  Case input = measured_case();
  input.settings.set(StripSettings{.bumps = 3, .amplitude = {Control::displacement, 20e-6}});
  for (const Experiment experiment : {Experiment::cycle, Experiment::strip}) {
    const Wording wording = wording_of(input, experiment);
    std::set<std::string_view> names;
    expect_described(increment_quantities(experiment, true), wording, names);
    expect_described(cycle_quantities(experiment, true), wording, names);
    expect_described(field_quantities(), wording, names);
    expect_described(load_quantities(experiment), wording, names);
    expect_described(event_quantities(), wording, names);
  }
}

TEST(ResultQuantities, WordsHaveNoUnitAndNumbersHaveOne) {
  for (const CycleQuantity& quantity : cycle_quantities(Experiment::cycle)) {
    const bool is_number = quantity.form.kind == Form::real || quantity.form.kind == Form::whole;
    EXPECT_EQ(quantity.unit.empty(), !is_number) << quantity.name;
    EXPECT_EQ(quantity.form.words.empty(), is_number) << quantity.name;
  }
}

TEST(ResultQuantities, AStripHasNoDirections) {
  const auto has = [](Experiment experiment, std::string_view name) {
    const std::vector<IncrementQuantity> all = increment_quantities(experiment);
    return std::any_of(all.begin(), all.end(), [name](const auto& quantity) { return quantity.name == name; });
  };
  EXPECT_TRUE(has(Experiment::cycle, "force_cross"));
  EXPECT_FALSE(has(Experiment::strip, "force_cross"));
  EXPECT_TRUE(has(Experiment::strip, "force_direct"));
}

TEST(ResultQuantities, MomentsAreThoseOfATiltedJournal) {
  for (const Experiment experiment : {Experiment::cycle, Experiment::path}) {
    const auto has_moment = [experiment](bool tilted) {
      const std::vector<IncrementQuantity> all = increment_quantities(experiment, tilted);
      return std::any_of(all.begin(), all.end(), [](const auto& quantity) { return quantity.name == "moment_y"; });
    };
    EXPECT_TRUE(has_moment(true));
    EXPECT_FALSE(has_moment(false));
  }
}

TEST(ResultQuantities, NothingIsKnownOfACycleThatFailedAtOnce) {
  Cycle cycle;
  cycle.status = Status::no_modes;
  for (const CycleQuantity& quantity : cycle_quantities(Experiment::cycle)) {
    if (quantity.is(tag::of_solver) || quantity.name == "amplitude") continue;
    EXPECT_TRUE(std::isnan(quantity.value(cycle, measured_case()))) << quantity.name;
  }
}

TEST(ResultQuantities, TheAmplitudeOfAStripUnderLoadIsWhatItFindsOut) {
  Case input = measured_case();
  input.settings.set(StripSettings{.bumps = 3, .amplitude = {Control::load, 1e6}, .steps = 4});
  const std::vector<CycleQuantity> quantities = cycle_quantities(Experiment::strip);
  const CycleQuantity& amplitude = called(quantities, "amplitude");
  EXPECT_TRUE(std::isnan(amplitude.value(run_strip(input).cycles.at(0), input)));  // flat before
  input.settings.get<StripSettings>().amplitude.value = 10.0;
  const Cycle cycle = run_strip(input).cycles.at(0);
  EXPECT_EQ(amplitude.value(cycle, input), cycle.turns.at(0).displacement - cycle.start->displacement);
}

TEST(ResultQuantities, YieldIsKnownWhereStressAndItsBoundAre) {
  Case input = measured_case();
  const Cycle cycle = run_cycles(input).cycles.at(0);
  const StressedFoil& top_foil = stressed_foils()[0];
  EXPECT_TRUE(std::isnan(above_yield(top_foil, cycle, input)));
  input.top_foil.yield_stress = cycle.top_foil_stress->stress;
  EXPECT_EQ(above_yield(top_foil, cycle, input), 0.0);
  input.top_foil.yield_stress = 0.99 * cycle.top_foil_stress->stress;
  EXPECT_EQ(above_yield(top_foil, cycle, input), 1.0);
  EXPECT_TRUE(std::isnan(above_yield(stressed_foils()[1], cycle, input)));  // the truss knows none
}

TEST(ResultQuantities, FieldsAreTheMatricesOfTheFoils) {
  const FoilFields fields = run_cycles(measured_case()).cycles.at(0).fields;
  for (const FieldQuantity& quantity : field_quantities()) {
    const FieldMatrix values = quantity.value(fields);
    EXPECT_EQ(values.rows(), 7) << quantity.name;
    if (quantity.name == "crest_v") {
      EXPECT_EQ(values, fields.crest_v);
    }
    if (quantity.name != "state_top_bump") continue;
    EXPECT_EQ(values(3, 12), static_cast<double>(fields.top_bump.mode(3, 12)));
  }
}

}  // namespace
}  // namespace bumpfoil
