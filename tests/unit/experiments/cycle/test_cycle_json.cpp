#include "experiments/cycle/cycle_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_names.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/bearing_cases.hpp"
#include "support/run_files.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

Case summarised_case() {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.5 * std::numbers::pi, 0.3};
  cycle.steps = 5;
  return input;
}

/// A run stopped by the user after `increments` of the first direction.
CycleResult stopped_after(int increments) {
  int count = 0;
  return run_cycles(summarised_case(), [&](double) { return ++count < increments; });
}

double sum(const json& numbers) {
  double total = 0.0;
  for (const json& number : numbers) total += number.get<double>();
  return total;
}

TEST(CycleJson, StandsBehindWhatWasRun) {
  const Case input = summarised_case();
  const json summary = json::parse(test_support::files_of("cycle", input)[2].contents);
  EXPECT_EQ(summary.at("schema"), "bumpfoil-summary/2");
  EXPECT_EQ(summary.at("version"), version());
  EXPECT_EQ(summary.at("solver"), "newton");
  EXPECT_EQ(summary.at("status"), "complete");
  EXPECT_EQ(summary.at("case"), json::parse(case_to_json(input)));
  EXPECT_EQ(summary.at("cycles").size(), 2U);
}

TEST(CycleJson, CarriesTheQuantitiesOfEveryCycle) {
  const Case input = summarised_case();
  const CycleResult result = run_cycles(input);
  ASSERT_TRUE(result.converged());
  const json cycle = json(cycle_lists(input, result)).at("cycles").at(0);
  const Cycle& expected = result.cycles[0];

  // All keys, and no others: scripts rely on them.
  const std::set<std::string> keys{"direction_deg",
                                   "amplitude_m",
                                   "steps",
                                   "converged",
                                   "status",
                                   "failed_increment",
                                   "failed_displacement_m",
                                   "reason",
                                   "max_force_N",
                                   "cross_force_at_max_N",
                                   "initial_force_N",
                                   "initial_force_x_N",
                                   "initial_force_y_N",
                                   "initial_journal_load_N",
                                   "initial_elastic_energy_J",
                                   "assembly_dissipation_J",
                                   "loop_energy_J",
                                   "elastic_energy_at_max_J",
                                   "loss_factor",
                                   "specific_damping_capacity",
                                   "loaded_stiffness_N_per_m",
                                   "take_up_m",
                                   "clearances",
                                   "loop_energies_J",
                                   "settled",
                                   "initial_x_m",
                                   "initial_y_m",
                                   "max_compression_m",
                                   "warnings",
                                   "tangent_stiffness_loading_N_per_m",
                                   "tangent_stiffness_unloading_N_per_m",
                                   "secant_stiffness_N_per_m",
                                   "first_contact_m",
                                   "clearance_5N_m",
                                   "clearance_10N_m",
                                   "bump_loads_N",
                                   "foot_loads_N",
                                   "journal_loads_N",
                                   "max_stress_top_foil_Pa",
                                   "max_stress_top_foil_at",
                                   "above_yield_top_foil",
                                   "max_stress_bump_foil_Pa",
                                   "max_stress_bump_foil_at",
                                   "above_yield_bump_foil",
                                   "max_residual",
                                   "iterations",
                                   "factorisations",
                                   "substeps",
                                   "wall_time_s"};
  std::set<std::string> met;
  for (const auto& [key, value] : cycle.items()) met.insert(key);
  EXPECT_EQ(met, keys);

  // Numbers have enough digits to read the same double back.
  EXPECT_EQ(cycle.at("direction_deg"), 90.0);
  EXPECT_EQ(cycle.at("converged"), true);
  EXPECT_EQ(cycle.at("status"), "converged");
  for (const char* key : {"failed_increment", "failed_displacement_m", "reason"}) EXPECT_TRUE(cycle.at(key).is_null());
  EXPECT_EQ(cycle.at("max_force_N"), expected.turning_point->max_force);
  EXPECT_EQ(cycle.at("cross_force_at_max_N"), expected.turning_point->cross_force);
  EXPECT_EQ(cycle.at("tangent_stiffness_loading_N_per_m"), expected.turning_point->tangent.loading.value());
  EXPECT_EQ(cycle.at("tangent_stiffness_unloading_N_per_m"), expected.turning_point->tangent.unloading.value());
  EXPECT_EQ(cycle.at("secant_stiffness_N_per_m"),
            expected.turning_point->max_force / input.settings.get<CycleSettings>().amplitude.value);
  EXPECT_EQ(cycle.at("elastic_energy_at_max_J"), expected.turning_point->elastic_energy);
  EXPECT_EQ(cycle.at("loop_energy_J"), *expected.loop_energy);
  EXPECT_EQ(cycle.at("loss_factor"), *expected.loss_factor);
  EXPECT_EQ(cycle.at("loaded_stiffness_N_per_m"), *expected.loaded_stiffness);
  EXPECT_EQ(cycle.at("take_up_m"), *expected.take_up);
  EXPECT_EQ(cycle.at("specific_damping_capacity"), *expected.specific_damping_capacity);
  EXPECT_EQ(cycle.at("clearances"),
            json({{{"force_N", 5.0}, {"displacement_m", *expected.clearances[0].displacement}},
                  {{"force_N", 10.0}, {"displacement_m", *expected.clearances[1].displacement}}}));
  EXPECT_EQ(cycle.at("max_compression_m"), expected.compression->compression);
  EXPECT_EQ(cycle.at("warnings"), json::array());
  EXPECT_EQ(cycle.at("loop_energies_J"), json::array({*expected.loop_energy}));
  EXPECT_TRUE(cycle.at("settled").is_null());
  EXPECT_EQ(cycle.at("first_contact_m"), *expected.first_contact);
  EXPECT_EQ(cycle.at("iterations"), expected.cost.iterations);
  EXPECT_EQ(cycle.at("factorisations"), expected.cost.factorisations);
  EXPECT_EQ(cycle.at("bump_loads_N").size(), 26U);
  EXPECT_EQ(cycle.at("foot_loads_N").size(), 26U);
  // Loads are at full displacement.
  EXPECT_EQ(sum(cycle.at("journal_loads_N")), expected.fields.journal_top.normal_force.row(5).sum());
}

TEST(CycleJson, SaysWhereAFoilIsBentMost) {
  Case input = summarised_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.yield_stress = 100e6;  // a ninth of the maximum stress of the bumps
  const CycleResult result = run_cycles(input);
  const json cycle = json(cycle_lists(input, result)).at("cycles").at(0);
  const StressPeak& peak = result.cycles[0].bump_foil_stress.value();
  EXPECT_EQ(cycle.at("max_stress_bump_foil_Pa"), peak.stress);
  const json& at = cycle.at("max_stress_bump_foil_at");
  EXPECT_EQ(at.at("place"), "crest");
  EXPECT_EQ(at.at("bump"), peak.bump + 1);
  EXPECT_EQ(at.at("increment"), 5);
  EXPECT_EQ(at.at("displacement_m"), input.settings.get<CycleSettings>().amplitude.value);
  EXPECT_EQ(cycle.at("above_yield_bump_foil"), true);
  EXPECT_EQ(cycle.at("max_stress_top_foil_at").at("place"), "weld");
  EXPECT_TRUE(cycle.at("max_stress_top_foil_at").at("bump").is_null());
  EXPECT_TRUE(cycle.at("above_yield_top_foil").is_null());  // no yield stress given

  const json truss = json(cycle_lists(summarised_case(), run_cycles(summarised_case())));
  EXPECT_TRUE(truss.at("cycles")[0].at("max_stress_bump_foil_Pa").is_null());
  EXPECT_TRUE(truss.at("cycles")[0].at("max_stress_bump_foil_at").is_null());
}

TEST(CycleJson, LeavesOutWhatAnInterruptedRunDoesNotKnow) {
  const json before = json(cycle_lists(summarised_case(), stopped_after(3)));
  ASSERT_EQ(before.at("cycles").size(), 1U);
  EXPECT_EQ(before.at("cycles")[0].at("converged"), false);
  EXPECT_EQ(before.at("cycles")[0].at("status"), "interrupted");
  EXPECT_TRUE(before.at("cycles")[0].at("failed_increment").is_null());
  EXPECT_EQ(before.at("cycles")[0].at("reason"), "the run was interrupted");
  EXPECT_TRUE(before.at("cycles")[0].at("max_force_N").is_null());
  EXPECT_TRUE(before.at("cycles")[0].at("bump_loads_N").is_null());
  EXPECT_TRUE(before.at("cycles")[0].at("loop_energy_J").is_null());
  EXPECT_EQ(before.at("cycles")[0].at("initial_force_N"), 0.0);

  const json after = json(cycle_lists(summarised_case(), stopped_after(8)));
  EXPECT_TRUE(after.at("cycles")[0].at("max_force_N").is_number());
  EXPECT_TRUE(after.at("cycles")[0].at("loop_energy_J").is_null());
}

TEST(CycleJson, SaysWhatFailedWhereAndWhy) {
  const CycleResult result = failed_at_increment_three(run_cycles(summarised_case()));
  const json cycle = json(cycle_lists(summarised_case(), result)).at("cycles").at(0);
  const Cycle& failed = result.cycles[0];
  EXPECT_EQ(cycle.at("converged"), false);
  EXPECT_EQ(cycle.at("status"), name_of(failed.status));
  EXPECT_EQ(cycle.at("failed_increment"), 3);
  EXPECT_EQ(cycle.at("failed_displacement_m"), failed.increments[3].displacement);
  EXPECT_EQ(cycle.at("reason"), explanation(failed.status));
}

TEST(CycleJson, NeverHoldsNanAsANumber) {
  CycleResult result = run_cycles(summarised_case());
  result.cycles[0].turning_point->max_force = std::numeric_limits<double>::quiet_NaN();
  result.cycles[0].loop_energy = std::numeric_limits<double>::infinity();
  const json cycle = json(cycle_lists(summarised_case(), result)).at("cycles").at(0);
  EXPECT_TRUE(cycle.at("max_force_N").is_null());
  EXPECT_TRUE(cycle.at("loop_energy_J").is_null());
}

TEST(CycleJson, HoldsACycleWithoutIncrements) {
  const CycleResult result{.solver = SolverName::newton, .cycles = {Cycle{}}};
  const json cycle = json(cycle_lists(summarised_case(), result)).at("cycles").at(0);
  EXPECT_TRUE(cycle.at("initial_force_N").is_null());
}

TEST(RunStatus, IsInterruptedWhereverTheUserStopsIt) {
  int due = 0;
  run_cycles(summarised_case(), [&](double) { return ++due > 0; });
  // Also between two directions, when all results so far have converged.
  bool between = false;
  for (int increments = 1; increments < due; ++increments) {
    const CycleResult result = stopped_after(increments);
    EXPECT_EQ(status_of(result), RunStatus::interrupted) << increments;
    EXPECT_FALSE(result.converged()) << increments;
    between = between || (result.cycles.size() == 1 && result.cycles[0].converged());
  }
  EXPECT_TRUE(between);
  EXPECT_EQ(status_of(run_cycles(summarised_case())), RunStatus::complete);
}

TEST(RunStatus, IsFailedWhereNothingWasInterrupted) {
  EXPECT_EQ(run_status({Status::converged, Status::no_modes}, 3), RunStatus::failed);
  EXPECT_EQ(run_status({Status::no_modes, Status::interrupted}, 2), RunStatus::interrupted);
}

}  // namespace
}  // namespace bumpfoil
