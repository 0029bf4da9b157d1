#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

const double speed = speed_of_rpm(45000.0);

Case running_case(const EquilibriumSettings& equilibrium, double friction_coefficient = 0.0) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4}, friction_coefficient);
  input.settings.set(equilibrium);
  return input;
}

TEST(Equilibrium, RampsLoads) {
  const Case input = running_case({.speeds = {speed, 0.8 * speed}, .loads = {{30.0, 0.0}, {40.0, 10.0}}, .steps = 3});
  const EquilibriumResult result = run_equilibrium(input);
  ASSERT_EQ(result.states.size(), 4U);
  EXPECT_TRUE(result.converged());
  for (const RunningState& state : result.states) {
    EXPECT_EQ(state.path, FilmPath::load_ramp);
    EXPECT_EQ(state.last->speed, state.requested.speed);
    EXPECT_LT((state.outcome->force - state.requested.journal).norm(), 1e-7);  // N
    EXPECT_GT(state.outcome->attitude_angle, 0.0);
    EXPECT_LT(state.outcome->attitude_angle, 1.6);
    EXPECT_NEAR(state.outcome->torque_of_moments, state.outcome->torque, 1e-4 * state.outcome->torque);
    ASSERT_TRUE(state.stiffness && state.stuck_stiffness);
    EXPECT_GT(state.stiffness->determinant(), 0.0);
  }
  EXPECT_EQ(result.states[1].requested.journal, Eigen::Vector2d(40.0, 10.0));
  EXPECT_EQ(result.states[2].requested.speed, 0.8 * speed);
}

TEST(Equilibrium, PlansTheStatesThatItWouldFind) {
  const Case input = running_case(
      {.speeds = {speed, 0.8 * speed}, .loads = {{30.0, 0.0}, {40.0, 10.0}}, .path = FilmPath::cold_start});
  const std::vector<RunningState> found = run_equilibrium(input).states;
  const std::vector<RunningState> planned =
      planned_states(input.settings.get<EquilibriumSettings>(), Status::interrupted);
  ASSERT_EQ(planned.size(), found.size());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    EXPECT_EQ(planned[i].path, found[i].path);
    EXPECT_EQ(planned[i].requested, found[i].requested);
    EXPECT_EQ(planned[i].before, found[i].before);
    EXPECT_EQ(planned[i].report.status, Status::interrupted);
  }
}

TEST(Equilibrium, TellsHowStatesAnswerToSmallMotions) {
  EquilibriumSettings settings{
      .speeds = {-speed}, .positions = {{1e-5, 0.0}}, .path = FilmPath::position_ray, .steps = 2};
  const FilmWhirl of_rotation = run_equilibrium(running_case(settings, 0.1)).states.at(0).whirls.at(0);
  EXPECT_EQ(of_rotation.frequency, speed);
  settings.frequencies = {0.1 * speed, speed};
  const EquilibriumResult result = run_equilibrium(running_case(settings, 0.1));
  const RunningState& state = result.states.at(0);
  ASSERT_EQ(state.whirls.size(), 2U);
  EXPECT_EQ(state.whirls[0].frequency, 0.1 * speed);
  const FilmWhirl& again = state.whirls[1];
  ASSERT_TRUE(of_rotation.impedance && of_rotation.stuck_impedance && again.impedance && again.stuck_impedance);
  // Where the equations are factored depends on the results requested: to 1e-10 of what is stored.
  EXPECT_LT((*again.impedance - *of_rotation.impedance).norm(), 1e-8 * again.impedance->norm());
  EXPECT_LT((*again.stuck_impedance - *of_rotation.stuck_impedance).norm(), 1e-8 * again.impedance->norm());
  EXPECT_GT((*again.stuck_impedance - *again.impedance).norm(), 1e-3 * again.impedance->norm());
  const auto Z = FilmStepper(*result.bearing).impedances(*state.last, {{0.0, 0.1 * speed}}, true);
  ASSERT_TRUE(Z && state.whirls[0].stuck_impedance);
  EXPECT_LT(((*Z)[0] - *state.whirls[0].stuck_impedance).norm(), 1e-8 * (*Z)[0].norm());
}

/// Gas enters at the free end, or at the weld.
TEST(Equilibrium, TellsWhetherStatesLast) {
  const EquilibriumResult result = run_equilibrium(
      running_case({.speeds = {speed, -speed}, .loads = {{30.0, 0.0}}, .path = FilmPath::cold_start}, 0.1));
  ASSERT_TRUE(result.converged());
  for (const RunningState& state : result.states) {
    const bool at_weld = state.requested.speed < 0.0;
    const auto& [sliding, stuck] = state.held;
    ASSERT_TRUE(sliding && stuck);
    EXPECT_EQ(state.held.is_stable(), at_weld);
    EXPECT_EQ(sliding->rate.real() < 0.0, at_weld);
    EXPECT_EQ(stuck->rate.real() < 0.0, at_weld);
    EXPECT_NE(sliding->rate, stuck->rate);
  }
}

/// The free end stays detached under 10 N on all paths, and beyond that on the ramp that comes from there.
TEST(Equilibrium, PrefersStableStatesWhereThereAreAny) {
  EquilibriumSettings settings{.speeds = {speed_of_rpm(20000.0)}, .loads = {{10.0, 0.0}, {30.0, 0.0}}};
  const EquilibriumResult as_found = run_equilibrium(running_case(settings));
  settings.prefer_stable = true;
  StateCheckers checkers;
  const EquilibriumResult result = run_equilibrium(running_case(settings), {}, {}, &checkers);
  ASSERT_EQ(result.states.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(result.states[i].tabulated.size(), tabulated_frequencies(settings).size());
    EXPECT_EQ(as_found.states[i].held.is_stable(), false);
    EXPECT_FALSE(as_found.states[i].instead_of_unstable);
    EXPECT_TRUE(result.states[i].found());
    EXPECT_EQ(result.states[i].requested, as_found.states[i].requested);
  }
  EXPECT_EQ(result.states[0].last->position, as_found.states[0].last->position);
  EXPECT_FALSE(result.states[0].instead_of_unstable);
  EXPECT_EQ(result.states[1].held.is_stable(), true);
  EXPECT_TRUE(result.states[1].instead_of_unstable);
  EXPECT_FALSE(result.states[1].before.has_value());                                  // from rest
  EXPECT_LT((result.states[1].outcome->force - settings.loads.back()).norm(), 1e-7);  // N
  // Several paths are kept unchanged.
  const EquilibriumResult both = run_equilibrium(running_case(settings), {FilmPath::load_ramp, FilmPath::speed_ramp});
  EXPECT_EQ(both.states[1].held.is_stable(), false);
  EXPECT_EQ(both.states[3].held.is_stable(), true);
}

TEST(Equilibrium, TabulatesFrequenciesThatCoverTheSpeeds) {
  const std::vector<double> of_one = tabulated_frequencies({.speeds = {-1000.0}});
  ASSERT_EQ(of_one.size(), 10U);
  EXPECT_NEAR(of_one.front(), 200.0, 1e-9);
  EXPECT_NEAR(of_one.back(), 1200.0, 1e-9);
  const std::vector<double> of_many = tabulated_frequencies({.speeds = {3000.0, -1000.0, 7000.0}});
  EXPECT_NEAR(of_many.front(), 200.0, 1e-9);
  EXPECT_NEAR(of_many.back(), 8400.0, 1e-9);
  for (const double one : {1000.0, 3000.0, 7000.0}) {
    const auto inside = [=](double frequency) { return frequency > 0.199 * one && frequency < 1.201 * one; };
    EXPECT_GE(std::count_if(of_many.begin(), of_many.end(), inside), 9) << one;
  }
  EXPECT_EQ(tabulated_frequencies({.speeds = {1000.0}, .frequencies = {5.0, 3.0, 5.0}}),
            (std::vector<double>{3.0, 5.0}));
}

TEST(Equilibrium, TabulatesSmallMotionsOfTheStatesThatWereFound) {
  EquilibriumSettings settings{
      .speeds = {speed, 0.8 * speed}, .positions = {{1e-5, 0.0}}, .path = FilmPath::cold_start, .steps = 2};
  Case input = running_case(settings, 0.1);
  EXPECT_FALSE(run_equilibrium(input).states[0].synchronous);
  StateCheckers checkers;
  const EquilibriumResult result = run_equilibrium(input, {}, {}, &checkers);
  const RunningState& state = result.states[0];
  ASSERT_TRUE(state.synchronous);
  EXPECT_EQ(state.synchronous->frequency, speed);
  const std::vector<double> frequencies = tabulated_frequencies(settings);
  ASSERT_EQ(state.tabulated.size(), frequencies.size());
  const auto Z = FilmStepper(*result.bearing).impedances(*state.last, {{0.0, frequencies[2]}});
  ASSERT_TRUE(Z && state.tabulated[2].impedance);
  EXPECT_LT(((*Z)[0] - *state.tabulated[2].impedance).norm(), 1e-8 * (*Z)[0].norm());

  input.settings.get<EquilibriumSettings>().frequencies = {2.0 * speed, 0.5 * speed};
  const EquilibriumResult given = run_equilibrium(input, {}, {}, &checkers);
  ASSERT_EQ(given.states[1].tabulated.size(), 2U);
  EXPECT_EQ(given.states[1].tabulated[0].frequency, 0.5 * speed);
  EXPECT_EQ(*given.states[1].tabulated[0].impedance, *given.states[1].whirls[1].impedance);
  EXPECT_EQ(given.states[1].synchronous->frequency, 0.8 * speed);
}

/// Every path leads to states that carry the load, if not to the same ones.
TEST(Equilibrium, PathsLeadToStatesThatCarryTheLoad) {
  const Case input = running_case({.speeds = {speed, 0.9 * speed}, .loads = {{50.0, 0.0}}, .steps = 4});
  const std::vector<FilmPath> paths = possible_paths(input.settings.get<EquilibriumSettings>());
  ASSERT_EQ(paths.size(), 4U);
  const EquilibriumResult result = run_equilibrium(input, paths);
  ASSERT_EQ(result.states.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    SCOPED_TRACE(i);
    const RunningState& state = result.states[i];
    ASSERT_TRUE(state.found());
    EXPECT_EQ(state.path, paths[i / 2]);
    EXPECT_LT((state.outcome->force - state.requested.journal).norm(), 1e-7);  // N
    EXPECT_EQ(state.last->speed, state.requested.speed);
  }
}

/// Positions there and back: friction leaves another force.
TEST(Equilibrium, KeepsTheHistoryOfFrictionAlongItsPath) {
  const auto at = [](double e) { return Eigen::Vector2d(e * 31.8e-6, 0.0); };
  const EquilibriumSettings there_and_back{
      .speeds = {speed}, .positions = {at(0.5), at(0.8), at(0.5)}, .path = FilmPath::position_ray};
  for (const double f : {0.0, 0.1}) {
    const EquilibriumResult result = run_equilibrium(running_case(there_and_back, f));
    ASSERT_TRUE(result.converged());
    const double lost = 1.0 - result.states[2].outcome->force.x() / result.states[0].outcome->force.x();
    if (f == 0.0) {
      EXPECT_NEAR(lost, 0.0, 1e-7);
    } else {
      EXPECT_GT(lost, 0.05);
    }
  }
}

TEST(Equilibrium, SaysWhatItDidNotFindAndKeepsTheLastState) {
  Case input = running_case({.speeds = {speed}, .loads = {{50.0, 0.0}, {100.0, 0.0}, {60.0, 0.0}}, .steps = 2});
  input.film.h_floor = 10e-6;
  const EquilibriumResult result = run_equilibrium(input);
  ASSERT_EQ(result.states.size(), 3U);
  EXPECT_FALSE(result.converged());
  EXPECT_TRUE(result.states[0].found());
  const RunningState& failed = result.states[1];
  EXPECT_EQ(failed.report.status, Status::touchdown);
  ASSERT_TRUE(failed.outcome.has_value());
  EXPECT_GT(failed.outcome->force.x(), 50.0);  // on the way
  EXPECT_LT(failed.outcome->force.x(), 100.0);
  EXPECT_NEAR(failed.outcome->thinnest.thickness * 31.8, 10.0, 0.2);
  EXPECT_EQ(result.states[2].report.status, Status::not_reached);
  EXPECT_FALSE(result.states[2].last.has_value());
}

TEST(Equilibrium, HasNoRoomBeyondTheClearance) {
  const Case input = running_case({.speeds = {speed}, .positions = {{40e-6, 0.0}}, .path = FilmPath::cold_start});
  const EquilibriumResult result = run_equilibrium(input);
  EXPECT_EQ(result.states.at(0).report.status, Status::no_room);
  EXPECT_FALSE(result.states[0].outcome.has_value());
}

/// A journal larger than the foils, by 2 um: gas enters at the weld, and the load takes the journal off it.
TEST(Equilibrium, ClosesAClearanceThatWasOpened) {
  const auto states = [](FilmPath path, EquilibriumSettings settings) {
    settings.speeds = {-speed, -0.9 * speed};
    settings.path = path;
    settings.steps = 3;
    Case input = running_case(settings);
    input.bearing.radial_clearance = -2e-6;
    return run_equilibrium(input);
  };
  const EquilibriumSettings loads{.loads = {{120.0, 0.0}, {150.0, 0.0}}};
  const EquilibriumResult ramped = states(FilmPath::load_ramp, loads);
  ASSERT_TRUE(ramped.converged());
  EquilibriumSettings positions;
  for (const std::size_t i : {0U, 1U}) positions.positions.push_back(ramped.states[i].last->position);
  for (const FilmPath path : {FilmPath::load_ramp, FilmPath::position_ray, FilmPath::speed_ramp}) {
    for (const EquilibriumSettings& settings : {loads, positions}) {
      const bool is_ramp = path == FilmPath::load_ramp;
      if (is_ramp && settings.loads.empty()) continue;
      const EquilibriumResult result = is_ramp ? ramped : states(path, settings);
      ASSERT_EQ(result.states.size(), 4U);
      for (const RunningState& state : result.states) {
        ASSERT_EQ(state.report.status, Status::converged) << static_cast<int>(path);
        EXPECT_EQ(state.last->clearance_offset, 0.0);
        EXPECT_GT(state.last->position.x(), 2e-6);
        EXPECT_GT(state.last->film.thickness.minCoeff(), 0.0);
      }
      // Without friction all paths come to the same state here.
      const Eigen::Vector2d& first = result.states.front().last->position;
      EXPECT_LT((first - ramped.states.front().last->position).norm(), 1e-12);  // m
    }
  }
}

/// Gas that enters under a free end finds no more than the foil's own clearance there: the film ends with it.
TEST(Equilibrium, SaysHowFarAClearanceClosed) {
  Case input = running_case({.speeds = {speed}, .loads = {{50.0, 0.0}, {60.0, 0.0}}, .steps = 3});
  input.bearing.radial_clearance = -2e-6;
  input.film.h_floor = 0.1e-6;
  const EquilibriumResult result = run_equilibrium(input);
  const RunningState& failed = result.states.at(0);
  EXPECT_EQ(failed.report.status, Status::touchdown);
  ASSERT_TRUE(failed.last && failed.outcome);
  const double clearance = input.bearing.radial_clearance + failed.last->clearance_offset;
  EXPECT_GT(clearance, 0.2e-6);
  EXPECT_LT(clearance, 0.4e-6);
  const double h = failed.outcome->thinnest.thickness * result.bearing->film->scales.thickness;
  EXPECT_GE(h, input.film.h_floor);
  EXPECT_LT(h, 1.1 * input.film.h_floor);
  EXPECT_EQ(result.states.at(1).report.status, Status::not_reached);
}

/// Pad offsets of the clearance and more: the journal finds room between the pads' middles once they deflect.
TEST(Equilibrium, ClosesPadsInOnTheJournal) {
  Case input = running_case({.speeds = {speed}, .loads = {{20.0, 0.0}}, .steps = 3});
  input.bump_foil.bumps = 8;
  input.bearing.weld_angle = -1.0;  // the load points to the middle of the first pad
  input.bearing.wrap = Wrap::counterclockwise;
  input.bearing.radial_clearance = 20e-6;
  input.pads.assign(3, {.lobe = 21e-6});
  const EquilibriumResult result = run_equilibrium(input);
  EXPECT_LT(result.bearing->film->assembled_clearance, 0.0);
  ASSERT_EQ(result.states.at(0).report.status, Status::converged);
  EXPECT_EQ(result.states[0].last->clearance_offset, 0.0);
  EXPECT_LT((result.states[0].outcome->force - Eigen::Vector2d(20.0, 0.0)).norm(), 1e-7);  // N
}

/// A bearing whose heights scatter by 3 um: the march from rest throws its foil onto the journal at 0.6 C_r.
TEST(Equilibrium, BeginsAtTheCentreWhereTheColdStartTouches) {
  Case input = running_case({.speeds = {speed}, .loads = {{20.0, 0.0}}}, 0.1);
  input.bearing.radial_clearance = 31.3e-6;
  input.bump_foil.height_errors = {0.8, -2.5, -0.3, -6.0, -5.3, 2.2,  1.3,  -2.5, 4.3,  -1.8, 2.1,  -3.0, -2.7,
                                   6.2, -1.6, -5.2, -1.3, -4.9, -0.6, -3.0, 4.6,  -3.9, -0.8, -6.8, -2.1, -2.1};
  for (double& error : input.bump_foil.height_errors) error *= 1e-6;
  const auto state_on = [&](FilmPath path) {
    input.settings.get<EquilibriumSettings>().path = path;
    return run_equilibrium(input).states.at(0);
  };
  EXPECT_EQ(state_on(FilmPath::cold_start).report.status, Status::touchdown);
  const RunningState ramped = state_on(FilmPath::load_ramp);
  ASSERT_EQ(ramped.report.status, Status::converged);
  // Increment by increment what position_ray does.
  const RunningState ray = state_on(FilmPath::position_ray);
  ASSERT_EQ(ray.report.status, Status::converged);
  EXPECT_EQ(ramped.last->position, ray.last->position);
  EXPECT_EQ(state_on(FilmPath::speed_ramp).report.status, Status::converged);
  // The same for a request of that position.
  EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  equilibrium.loads.clear();
  equilibrium.positions = {{0.6 * input.bearing.radial_clearance, 0.0}};
  EXPECT_EQ(state_on(FilmPath::cold_start).report.status, Status::touchdown);
  EXPECT_EQ(state_on(FilmPath::position_ray).report.status, Status::converged);
}

/// Lobes of half the clearance: 0.6 of all of it would be beyond the foils.
TEST(Equilibrium, StartsInTheRoomThatLobesLeave) {
  for (const FilmPath path :
       {FilmPath::load_ramp, FilmPath::speed_ramp, FilmPath::position_ray, FilmPath::cold_start}) {
    Case input = running_case({.speeds = {speed}, .loads = {{20.0, 0.0}}, .path = path, .steps = 3});
    input.bump_foil.bumps = 8;
    input.bearing.weld_angle = 1.0;  // the load points to the middle of the first pad
    input.pads.assign(3, {.lobe = 16e-6});
    const EquilibriumResult result = run_equilibrium(input);
    EXPECT_EQ(result.states.at(0).report.status, Status::converged) << static_cast<int>(path);
    EXPECT_EQ(result.bearing->film->assembled_clearance, input.bearing.radial_clearance - 16e-6);
  }
}

TEST(Equilibrium, ReportsProgressAndStops) {
  const Case input = running_case({.speeds = {speed}, .loads = {{30.0, 0.0}, {40.0, 0.0}}, .steps = 2});
  double last = 0.0;
  EXPECT_TRUE(run_equilibrium(input, {}, [&](double fraction) {
                EXPECT_GE(fraction, last);
                EXPECT_LE(fraction, 1.0);
                last = fraction;
                return true;
              }).converged());
  EXPECT_GE(last, 0.5);
  const EquilibriumResult stopped = run_equilibrium(input, {}, [&](double fraction) { return fraction < 0.5; });
  ASSERT_EQ(stopped.states.size(), 2U);
  EXPECT_TRUE(stopped.states[0].found());
  EXPECT_EQ(stopped.states[1].report.status, Status::interrupted);
}

TEST(Equilibrium, NeedsItsTable) {
  EXPECT_THROW(run_equilibrium(film_reference_case({.columns_per_pitch = 4, .rows = 4})), Error);
}

TEST(Equilibrium, KeepsNoMoreStatesThanTheMemoryHolds) {
  Case input = film_reference_case({.columns_per_pitch = 6, .rows = 16});
  const auto errors_of = [&](std::size_t states) {
    input.settings.set(EquilibriumSettings{.speeds = std::vector<double>(states, 1.0), .loads = {{1.0, 0.0}}});
    return find_errors(input, {"equilibrium"});
  };
  EXPECT_TRUE(errors_of(10'000).empty());
  const std::vector<InputError> errors = errors_of(100'000);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].key, "equilibrium.speeds");
}

TEST(Equilibrium, KnowsNoWavesOfTheJournal) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4});
  input.settings.set(EquilibriumSettings{.speeds = {4000.0}, .loads = {{50.0, 0.0}}});
  input.bearing.journal.waves = {{3, 5e-6, 0.0}};
  EXPECT_THROW(run_equilibrium(input), Error);
}

/// Past the end of a branch solves are given up where only vain steps are left of them: else each runs to its limit,
/// and this state takes 2,432 iterations.
TEST(Equilibrium, GivesUpSoonWhereNoStateIs) {
  const Case input = read_case(
      "../examples/running_from_rest.toml",
      {.overrides = {"equilibrium.speeds=[\"0 rpm\", \"762.7 rpm\", \"1525.4 rpm\"]"}, .commands = {"equilibrium"}});
  const EquilibriumResult result = run_equilibrium(input);
  ASSERT_TRUE(result.converged());
  EXPECT_EQ(result.states[2].report.jumps, 1);
  EXPECT_LT(result.states[2].report.iterations, 1500);
}

}  // namespace
}  // namespace bumpfoil
