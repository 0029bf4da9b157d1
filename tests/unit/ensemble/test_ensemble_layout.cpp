#include "bumpfoil/ensemble/ensemble_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/experiments/cycle/sampled_cycles.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

/// Of the first sample.
std::vector<double> row_of_sample(const Case& input, const EnsembleLayout& layout) {
  return EnsembleSampler(input, layout).run(0, [](double) { return true; }).value();
}

TEST(EnsembleLayout, RowsHoldTheQuantitiesOfEveryCycle) {
  Case input = test_support::ensemble_case(1);
  input.settings.get<CycleSettings>().clearance_forces = {5.0, 1e6};
  const EnsembleLayout layout = make_ensemble_layout(input);
  EXPECT_EQ(layout.columns.front().meaning.name, "status");
  std::set<std::string> names;
  for (const EnsembleColumn& column : layout.columns) names.insert(column.meaning.name);
  EXPECT_EQ(names.size(), layout.columns.size());
  EXPECT_EQ(names.count("clearance_5N"), 1U);
  EXPECT_EQ(names.count("clearance_1e+06N"), 1U);

  const CycleResult result = run_sampled_cycles(sampled_case(input, draw_sample(input, 0))).value();
  const std::vector<double> row = row_of_sample(input, layout);
  ASSERT_EQ(row.size(), layout.width());
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const Cycle& cycle = result.cycles[direction];
    const auto value = [&](std::string_view name) -> double {
      for (std::size_t k = 0; k < layout.columns.size(); ++k) {
        if (layout.columns[k].meaning.name == name) return row[layout.entry(direction, k)];
      }
      return NAN;
    };
    EXPECT_EQ(value("status"), 0.0);
    EXPECT_EQ(value("max_force"), cycle.turning_point->max_force);
    EXPECT_EQ(value("loop_energy"), *cycle.loop_energy);
    EXPECT_EQ(value("clearance_5N"), *cycle.clearances[0].displacement);
    EXPECT_TRUE(std::isnan(value("clearance_1e+06N")));
    EXPECT_EQ(value("largest_bump_load"), cycle.turning_point->bump_loads.maxCoeff());
    EXPECT_EQ(row[layout.entry(direction, layout.columns.size() + 7)], cycle.turning_point->bump_loads[7]);
  }
}

TEST(EnsembleLayout, OfWhatWasNotRunOnlyTheStatusIsKnown) {
  const Case input = test_support::ensemble_case(1);
  const EnsembleLayout layout = make_ensemble_layout(input);
  const std::vector<double> row = make_ensemble_row(layout, std::nullopt);
  for (std::size_t k = 0; k < layout.per_place(); ++k) {
    if (k == 0) {
      EXPECT_EQ(row[k], layout.no_bearing());
    } else {
      EXPECT_TRUE(std::isnan(row[k])) << k;
    }
  }
}

TEST(EnsembleLayout, RowsHoldTheStatesOfRunningBearings) {
  const Case input = test_support::running_ensemble_case(1);
  const EnsembleLayout layout = make_ensemble_layout(input);
  ASSERT_EQ(layout.places.size(), 2U);
  EXPECT_EQ(layout.places[1].name, "44996.3 rpm, load (40, 0) N");
  EXPECT_EQ(layout.columns.front().meaning.name, "status");
  const auto has = [](const EnsembleLayout& one, std::string_view name) {
    return std::any_of(one.columns.begin(), one.columns.end(),
                       [&](const EnsembleColumn& column) { return column.meaning.name == name; });
  };
  EXPECT_TRUE(has(layout, "h_min"));
  // Loads are prescribed and have no scatter. The others exist only for pads, limits or rough surfaces.
  for (const char* const name : {"force_x", "h_min_pad", "load_capacity", "asperity_share"}) {
    EXPECT_FALSE(has(layout, name)) << name;
  }
  Case rough = input;
  rough.asperity = AsperitySettings{.sigma = 0.3e-6, .pressure_factor = 2.4e8, .friction = 0.2};
  EXPECT_TRUE(has(make_ensemble_layout(rough), "asperity_share"));

  const EquilibriumResult result = run_equilibrium(sampled_case(input, draw_sample(input, 0)));
  const std::vector<double> row = row_of_sample(input, layout);
  ASSERT_EQ(row.size(), layout.width());
  for (std::size_t place = 0; place < 2; ++place) {
    const RunningState& state = result.states[place];
    ASSERT_TRUE(state.found());
    const auto value = [&](std::string_view name) {
      const auto column = std::find_if(layout.columns.begin(), layout.columns.end(),
                                       [name](const EnsembleColumn& one) { return one.meaning.name == name; });
      return row[layout.entry(place, static_cast<std::size_t>(column - layout.columns.begin()))];
    };
    EXPECT_EQ(value("power"), state.outcome->power);
    EXPECT_EQ(value("kyx"), (*state.stiffness)(1, 0));
    const Vector loads = bump_loads(*result.bearing, *state.last);
    EXPECT_GT(loads.maxCoeff(), 1.0);
    for (std::size_t bump = 0; bump < layout.bumps; ++bump) {
      EXPECT_EQ(row[layout.entry(place, layout.columns.size() + bump)], loads[static_cast<Eigen::Index>(bump)]);
    }
  }
}

TEST(EnsembleLayout, RowsHoldTheRotorOverItsSpeeds) {
  const Case input = test_support::rotor_ensemble_case(1);
  const EnsembleLayout layout = make_ensemble_layout(input);
  ASSERT_EQ(layout.places.size(), 1U);
  EXPECT_EQ(layout.places[0].name, "rotor");
  EXPECT_EQ(layout.place.name, "rotor");
  EXPECT_EQ(layout.width(), layout.columns.size());  // bump loads are omitted, as they differ between speeds
  EXPECT_EQ(layout.columns.front().meaning.name, "status");
  EXPECT_EQ(layout.status_name(static_cast<int>(Status::interrupted)), "interrupted");
  EXPECT_EQ(layout.status_name(layout.no_bearing()), "not_physical");
  EXPECT_EQ(make_ensemble_row(layout, std::nullopt).front(), layout.no_bearing());

  const Case sampled = sampled_case(input, draw_sample(input, 0));
  const StabilityResult result = run_stability(sampled);
  double first = 1570.8;
  for (const WhirlOnset& found : result.map.onsets) first = std::min(first, std::abs(found.onset.speed));
  ASSERT_LT(first, 1570.8);
  const std::vector<double> row = row_of_sample(input, layout);
  ASSERT_EQ(row.size(), layout.width());
  const auto value = [&](std::string_view name) {
    const auto column = std::find_if(layout.columns.begin(), layout.columns.end(),
                                     [name](const EnsembleColumn& one) { return one.meaning.name == name; });
    return row[static_cast<std::size_t>(column - layout.columns.begin())];
  };
  EXPECT_EQ(value("status"), 0.0);
  EXPECT_EQ(value("stable_up_to"), first);
  EXPECT_EQ(value("onset_speed"), result.map.onsets.front().onset.speed);
  EXPECT_EQ(value("stable_throughout"), 0.0);
  EXPECT_EQ(value("unstable_at_lowest"), 0.0);
}

TEST(EnsembleLayout, RowsHoldTheLargestAmplitudeOfARotor) {
  Case input = test_support::unbalance_ensemble_case(1);
  const EnsembleLayout layout = make_ensemble_layout(input);
  EXPECT_EQ(layout.place.name, "rotor");
  EXPECT_EQ(layout.target, "largest_amplitude");
  EXPECT_EQ(layout.width(), layout.columns.size());
  std::vector<std::string> names;
  for (const EnsembleColumn& column : layout.columns) names.push_back(column.meaning.name);
  EXPECT_EQ(names, (std::vector<std::string>{"status", "largest_amplitude", "largest_amplitude_speed",
                                             "largest_amplitude_ratio"}));
  EXPECT_EQ(layout.status_name(layout.no_bearing()), "not_physical");
  const std::vector<double> row = row_of_sample(input, layout);
  EXPECT_EQ(row[0], 0.0);
  EXPECT_GT(row[1], 0.5e-6);  // the centre of mass is 1 um from the axis
  EXPECT_LT(row[1], 5e-6);
  EXPECT_GE(row[2], 700.0);
  EXPECT_LT(row[3], 1.0);
  // With orbits their quantities are added.
  input.settings.get<UnbalanceSettings>().orbits = true;
  EXPECT_EQ(make_ensemble_layout(input).columns.back().meaning.name, "orbits_last");
}

TEST(EnsembleLayout, RowsHoldWhatARotorDoesInTime) {
  const Case input = test_support::transient_ensemble_case(1);
  const EnsembleLayout layout = make_ensemble_layout(input);
  EXPECT_EQ(layout.place.name, "rotor");
  std::vector<std::string> names;
  for (const EnsembleColumn& column : layout.columns) names.push_back(column.meaning.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"status", "end_time", "end_speed", "largest_half_peak_to_peak",
                                      "largest_amplitude_half", "thinnest_film_of_run", "largest_asperity_load_of_run",
                                      "rub_count", "friction_loss_of_run", "energy_defect_of_run"}));
  EXPECT_EQ(std::count(names.begin(), names.end(), layout.target), 1);
  const std::vector<double> row = row_of_sample(input, layout);
  EXPECT_EQ(row[1], input.settings.get<TransientSettings>().speed.front().time);
}

/// Errors of the case throw; they are not failures of samples.
TEST(EnsembleLayout, OfRotorsWantsOne) {
  Case still = test_support::transient_ensemble_case(1);
  still.settings.set(TransientSettings{});
  EXPECT_THROW(static_cast<void>(make_ensemble_layout(still)), Error);
  Case unbalanced = test_support::unbalance_ensemble_case(1);
  unbalanced.settings.set(UnbalanceSettings{});
  EXPECT_THROW(static_cast<void>(make_ensemble_layout(unbalanced)), Error);
  Case input = test_support::rotor_ensemble_case(1);
  input.settings.set(StabilitySettings{});
  EXPECT_THROW(static_cast<void>(make_ensemble_layout(input)), Error);
}

TEST(EnsembleLayout, OfARunningBearingThatIsNoneOnlyTheStatusIsKnown) {
  const Case input = test_support::running_ensemble_case(1);
  const EnsembleLayout layout = make_ensemble_layout(input);
  const std::vector<double> row = make_ensemble_row(layout, std::nullopt);
  EXPECT_EQ(layout.status_name(static_cast<int>(row[0])), "not_physical");
  EXPECT_EQ(layout.status_reason(static_cast<int>(row[0])), "invalid sample");
  EXPECT_TRUE(std::all_of(row.begin() + 1, row.begin() + static_cast<std::ptrdiff_t>(layout.per_place()),
                          [](double value) { return std::isnan(value); }));
}

/// Of a case that was not read from a file.
TEST(EnsembleLayout, WantsACommandThatEnsemblesRun) {
  for (const char* command : {"strip", "equilibrum", ""}) {
    Case input = test_support::ensemble_case(1);
    input.montecarlo->command = command;
    EXPECT_THROW(static_cast<void>(make_ensemble_layout(input)), Error) << command;
  }
}

}  // namespace
}  // namespace bumpfoil
