#include "bumpfoil/experiments/cycle/cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

Case short_case(int steps = 10) {
  Case input = case_with_given_constants();
  input.settings.get<CycleSettings>().steps = steps;
  return input;
}

TEST(Cycle, GoesThereAndBackInEqualIncrements) {
  const Cycle cycle = run_single_cycle(short_case(), 2.0);
  EXPECT_EQ(cycle.direction, 2.0);
  EXPECT_EQ(cycle.amplitude, 79.5e-6);
  EXPECT_EQ(cycle.steps, 10);
  ASSERT_EQ(cycle.increments.size(), 21U);
  for (std::size_t k = 0; k <= 20; ++k) {
    const FullIncrement increment = increment_at(cycle, static_cast<int>(k));
    EXPECT_EQ(increment.index, static_cast<int>(k));
    EXPECT_EQ(increment.branch, k <= 10 ? Branch::loading : Branch::unloading);
    EXPECT_NEAR(increment.displacement, 7.95e-6 * static_cast<double>(k <= 10 ? k : 20 - k), 1e-19);
    EXPECT_NEAR(increment.x, increment.displacement * std::cos(2.0), 1e-19);
    EXPECT_NEAR(increment.y, increment.displacement * std::sin(2.0), 1e-19);
  }
  EXPECT_EQ(cycle.increments[10].displacement, 79.5e-6);  // without round-off
  EXPECT_EQ(cycle.increments[20].displacement, 0.0);
}

TEST(Cycle, FieldsOfAnIncrementBelongTogether) {
  const Cycle cycle = run_single_cycle(short_case(), 1.0);
  const Case input = short_case();
  const Eigen::Matrix2Xd normals = outward_normals(polar_angles(input.bearing, crest_angles(input)));
  for (const FullIncrement& increment : full_increments(cycle)) {
    const Eigen::Vector2d force = journal_force(normals, increment.journal_top.normal_force);
    const double size = 1e-12 * (1.0 + force.norm());
    EXPECT_NEAR(increment.force_x, force.x(), size);
    EXPECT_NEAR(increment.force_y, force.y(), size);
    EXPECT_NEAR(increment.force_direct, force.x() * std::cos(1.0) + force.y() * std::sin(1.0), size);
    EXPECT_NEAR(increment.force_cross, -force.x() * std::sin(1.0) + force.y() * std::cos(1.0), size);
    const Vector r = journal_gaps(input.bearing.radial_clearance, normals, {increment.x, increment.y});
    for (Eigen::Index i = 0; i < 26; ++i) {
      const auto entry = static_cast<std::size_t>(i);
      const double g_r = r[i] + increment.top_displacement[i];
      const double g_t = increment.crest_v[i] - increment.top_displacement[i];
      const double g_b = -increment.foot_v[i];
      EXPECT_NEAR(increment.journal_top.gap[i], g_r, 1e-13);
      EXPECT_NEAR(increment.top_bump.gap[i], g_t, 1e-13);
      EXPECT_NEAR(increment.bump_sleeve.gap[i], g_b, 1e-13);
      for (const InterfaceRow* fields : {&increment.journal_top, &increment.top_bump, &increment.bump_sleeve}) {
        const bool open = fields->mode[entry] == ContactMode::open;
        EXPECT_GE(fields->gap[i], 0.0);
        EXPECT_GE(fields->normal_force[i], 0.0);
        EXPECT_EQ(fields->normal_force[i] == 0.0, open);
        EXPECT_LE(std::abs(fields->friction_force[i]), 0.1 * fields->normal_force[i] + 1e-9);
      }
      EXPECT_EQ(increment.journal_top.friction_force[i], 0.0);
    }
  }
}

TEST(Cycle, SlippingFrictionOpposesTheMotionSinceTheLastIncrement) {
  const Cycle cycle = run_single_cycle(short_case(20), 0.0);
  int slipping = 0;
  for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
    const FullIncrement now = increment_at(cycle, static_cast<int>(k));
    const Vector slip = now.crest_u - increment_at(cycle, static_cast<int>(k) - 1).crest_u;
    for (Eigen::Index i = 0; i < 26; ++i) {
      const ContactMode mode = now.top_bump.mode[static_cast<std::size_t>(i)];
      if (mode != ContactMode::slip_forward && mode != ContactMode::slip_backward) continue;
      ++slipping;
      const double sign = mode == ContactMode::slip_forward ? 1.0 : -1.0;
      EXPECT_GE(sign * slip[i], -1e-13);
      EXPECT_NEAR(now.top_bump.friction_force[i], -sign * 0.1 * now.top_bump.normal_force[i], 1e-9);
    }
  }
  EXPECT_GT(slipping, 50);
}

TEST(Cycle, QuantitiesFollowFromTheIncrements) {
  const Cycle cycle = run_single_cycle(short_case(), pi);
  ASSERT_TRUE(cycle.converged());
  ASSERT_TRUE(cycle.turning_point && cycle.loop_energy && cycle.loss_factor);
  const FullIncrement turning = turning_increment(cycle);
  EXPECT_EQ(turning.index, 10);
  EXPECT_EQ(cycle.turning_point->max_force, turning.force_direct);
  EXPECT_EQ(cycle.turning_point->cross_force, turning.force_cross);
  EXPECT_EQ(cycle.turning_point->elastic_energy, turning.elastic_energy);
  EXPECT_DOUBLE_EQ(*cycle.secant_stiffness, turning.force_direct / 79.5e-6);
  double work = 0.0;
  for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
    const Increment& a = cycle.increments[k - 1];
    const FullIncrement b = increment_at(cycle, static_cast<int>(k));
    work += 0.5 * (a.force_direct + b.force_direct) * (b.displacement - a.displacement);
    EXPECT_NEAR(b.work, work, 1e-15);
  }
  EXPECT_NEAR(*cycle.loop_energy, work, 1e-15);
  const double half_range = 0.5 * (79.5e-6 - *cycle.take_up);
  EXPECT_NEAR(*cycle.loaded_stiffness, 0.99 * turning.force_direct / (2.0 * half_range),
              1e-9 * *cycle.loaded_stiffness);
  EXPECT_DOUBLE_EQ(*cycle.loss_factor, *cycle.loop_energy / (pi * *cycle.loaded_stiffness * half_range * half_range));
  EXPECT_DOUBLE_EQ(*cycle.specific_damping_capacity,
                   *cycle.loop_energy / (turning.elastic_energy - cycle.increments.front().elastic_energy));
  EXPECT_LT(*cycle.first_contact, *cycle.take_up);
  EXPECT_LT(*cycle.first_contact, *cycle.clearances[0].displacement);
  EXPECT_LT(*cycle.clearances[0].displacement, *cycle.clearances[1].displacement);
  int iterations = 0;
  for (const Increment& increment : cycle.increments) iterations += increment.cost.iterations;
  EXPECT_EQ(cycle.cost.iterations, iterations);
  EXPECT_GT(cycle.wall_time, 0.0);
}

TEST(Cycle, PushThatTouchesNothingHasNoLoopAndNoLossFactor) {
  Case input = short_case();
  input.settings.get<CycleSettings>().amplitude.value = 20e-6;
  const Cycle cycle = run_single_cycle(input, 0.0);
  EXPECT_TRUE(cycle.converged());
  EXPECT_EQ(cycle.turning_point->max_force, 0.0);
  EXPECT_EQ(cycle.turning_point->tangent.loading, 0.0);
  EXPECT_EQ(cycle.loop_energy, 0.0);
  EXPECT_EQ(cycle.loss_factor, std::nullopt);
  EXPECT_EQ(cycle.clearances[0].displacement, std::nullopt);
}

/// An ensemble needs a few numbers of many cycles: the same ones, without records. They are bit-identical to those with
/// all records, or within tolerance if rates accumulate from piece to piece.
TEST(CycleRunner, FindsTheSameQuantitiesWithoutRecords) {
  const std::pair<SolverName, double> solvers[] = {{SolverName::newton, 0.0}, {SolverName::events, 1e-9}};
  for (const auto& [solver, tolerance] : solvers) {
    const Case input = short_case(20);
    CycleRunner runner(make_bearing_foils(input), {.name = solver, .uzawa = {}});
    for (const double direction : input.settings.get<CycleSettings>().directions) {
      const Cycle all = runner.run(direction, input.settings.get<CycleSettings>());
      const Cycle few = runner.run(direction, input.settings.get<CycleSettings>(), Recording::quantities);
      EXPECT_TRUE(few.converged());
      const auto expect_same = [tolerance = tolerance](std::optional<double> found, std::optional<double> expected) {
        ASSERT_EQ(found.has_value(), expected.has_value());
        EXPECT_NEAR(found.value_or(0.0), expected.value_or(0.0), tolerance * std::abs(expected.value_or(0.0)));
      };
      expect_same(few.turning_point->max_force, all.turning_point->max_force);
      expect_same(few.turning_point->tangent.loading, all.turning_point->tangent.loading);
      expect_same(few.turning_point->elastic_energy, all.turning_point->elastic_energy);
      EXPECT_LE((few.turning_point->bump_loads - all.turning_point->bump_loads).cwiseAbs().maxCoeff(),
                tolerance * all.turning_point->bump_loads.maxCoeff());
      expect_same(few.loop_energy, all.loop_energy);
      expect_same(few.loss_factor, all.loss_factor);
      expect_same(few.clearances[0].displacement, all.clearances[0].displacement);
      expect_same(few.take_up, all.take_up);
      EXPECT_EQ(few.first_contact, all.first_contact);
      EXPECT_TRUE(few.cost == all.cost || solver == SolverName::events);
      EXPECT_TRUE(few.increments.empty());
      EXPECT_EQ(few.fields.increments(), 0);
      EXPECT_LT(few.max_residual, 1e-9);
      if (solver == SolverName::newton) {
        EXPECT_EQ(few.max_residual, all.max_residual);
      }
    }
  }
}

/// Independent of previous runs and of the order of directions: ensembles are bit-identical.
TEST(CycleRunner, RemembersNothing) {
  Case input = short_case(20);
  input.bump_foil.height_errors = random_case(3).bump_foil.height_errors;
  input.bump_foil.height_errors.resize(26, 0.0);
  const SharedBearing foils = make_bearing_foils(input);
  const SolverSettings events{.name = SolverName::events, .uzawa = {}};
  CycleRunner used(foils, events);
  for (const double direction : {0.3, 2.0, 0.3}) {
    const Cycle again = used.run(direction, input.settings.get<CycleSettings>(), Recording::quantities);
    const Cycle fresh =
        CycleRunner(foils, events).run(direction, input.settings.get<CycleSettings>(), Recording::quantities);
    ASSERT_TRUE(fresh.converged());
    EXPECT_EQ(again.turning_point->max_force, fresh.turning_point->max_force);
    EXPECT_EQ(again.loop_energy, fresh.loop_energy);
    EXPECT_EQ(again.clearances[0].displacement, fresh.clearances[0].displacement);
  }
}

/// Foils that differ only in their gaps share their stiffness; stiffer ones must not.
TEST(CycleRunner, TakesOtherFoils) {
  std::vector<Case> inputs(4, short_case(20));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    BumpFoil& foil = inputs[i].bump_foil;
    foil.height_errors = random_case(3 + i).bump_foil.height_errors;
    foil.height_errors.resize(26, 0.0);
    if (i == 2) foil.thickness.values.front() *= 1.1;
    if (i == 3) inputs[i].friction.top_bump = 0.3;
  }
  for (const SolverName name : {SolverName::newton, SolverName::events}) {
    const SolverSettings settings{.name = name, .uzawa = {}};
    CycleRunner used(make_bearing_foils(inputs.front()), settings);
    for (const Case& input : inputs) {
      const SharedBearing foils = make_bearing_foils(input);
      used.set_foils(foils);
      const Cycle again = used.run(0.3, input.settings.get<CycleSettings>(), Recording::quantities);
      const Cycle fresh =
          CycleRunner(foils, settings).run(0.3, input.settings.get<CycleSettings>(), Recording::quantities);
      ASSERT_TRUE(fresh.converged());
      EXPECT_EQ(again.turning_point->max_force, fresh.turning_point->max_force);
      EXPECT_EQ(again.turning_point->bump_loads, fresh.turning_point->bump_loads);
      EXPECT_EQ(again.loop_energy, fresh.loop_energy);
      EXPECT_EQ(again.clearances[0].displacement, fresh.clearances[0].displacement);
      EXPECT_EQ(again.initial_journal_load, fresh.initial_journal_load);
    }
  }
}

/// The forming bends the foils before the journal does, and is no work of the journal: the energies balance, exactly
/// where every piece of the response is known.
TEST(Cycle, FormedFoilsBalanceTheirEnergies) {
  for (const SolverName name : {SolverName::newton, SolverName::events}) {
    Case input = short_case();
    input.solver.name = name;
    const double of_circle = run_single_cycle(input, 1.0).turning_point->max_force;
    input.top_foil.formed_radius = {FormedTo::seated};
    const Cycle cycle = run_single_cycle(input, 1.0);
    ASSERT_TRUE(cycle.converged()) << name_of(name);
    const double before = cycle.increments.front().elastic_energy;
    EXPECT_GT(before, 1e-6) << name_of(name);
    if (name == SolverName::events) {
      for (const Increment& increment : cycle.increments) {
        EXPECT_NEAR(increment.elastic_energy + increment.dissipated_energy, before + increment.work, 1e-13);
      }
    }
    // Their hold-down is 0.03 N.
    EXPECT_NEAR(cycle.turning_point->max_force, of_circle, 1e-3 * of_circle) << name_of(name);
  }
}

/// Also for few increments: no load before the first contact, and no difference if `events` resolves every piece.
TEST(CycleRunner, FindsClearancesInsideIncrements) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Case input = reference_case();
    input.bump_foil.height_errors = random_case(seed).bump_foil.height_errors;
    input.bump_foil.height_errors.resize(26, 0.0);
    const SharedBearing foils = make_bearing_foils(input);
    std::vector<Cycle> by_events;
    for (const int steps : {1, 2, 7}) {
      input.settings.get<CycleSettings>().steps = steps;
      const Cycle coarse = CycleRunner(foils, {}).run(0.9, input.settings.get<CycleSettings>());
      ASSERT_TRUE(coarse.converged());
      for (const Clearance& clearance : coarse.clearances) {
        EXPECT_GE(clearance.displacement.value_or(1.0), *coarse.first_contact) << seed;
      }
      by_events.push_back(
          CycleRunner(foils, {.name = SolverName::events, .uzawa = {}}).run(0.9, input.settings.get<CycleSettings>()));
    }
    for (const Cycle& cycle : by_events) {
      ASSERT_TRUE(cycle.converged());
      EXPECT_NEAR(*cycle.take_up, *by_events[0].take_up, 1e-15);
      EXPECT_NEAR(*cycle.clearances[0].displacement, *by_events[0].clearances[0].displacement, 1e-15);
      EXPECT_NEAR(*cycle.clearances[1].displacement, *by_events[0].clearances[1].displacement, 1e-15);
    }
  }
}

TEST(CycleRunner, IsFullyReversedAboutALoadThatTheJournalCarries) {
  for (const SolverName solver : {SolverName::newton, SolverName::events}) {
    Case input = short_case(20);
    input.solver.name = solver;
    CycleSettings& settings = input.settings.get<CycleSettings>();
    settings.preload = PlaneTarget{.control = Control::load, .value = {10.0, -50.0}};
    settings.amplitude.value = 3e-6;
    const Cycle cycle = CycleRunner(make_bearing_foils(input), input.solver).run(0.5, settings);
    ASSERT_TRUE(cycle.converged());
    ASSERT_EQ(cycle.increments.size(), 81U);
    const Increment& start = cycle.increments[0];
    EXPECT_NEAR(start.force_x, 10.0, 1e-7);
    EXPECT_NEAR(start.force_y, -50.0, 1e-7);
    EXPECT_EQ(start.work, 0.0);
    // Up by 3 um along the direction, down by twice as much, and back; across it the journal is held.
    const auto moved = [&](std::size_t k) -> Eigen::Vector2d {
      return {cycle.increments[k].x - start.x, cycle.increments[k].y - start.y};
    };
    for (const auto& [k, distance] : {std::pair{20U, 3e-6}, std::pair{60U, -3e-6}, std::pair{80U, 0.0}}) {
      EXPECT_LT((moved(k) - distance * unit_vector(0.5)).norm(), 1e-18);
    }
    EXPECT_GT(*cycle.loop_energy, 0.0);
    EXPECT_EQ(*cycle.loaded_stiffness, (cycle.increments[20].force_direct - cycle.increments[60].force_direct) /
                                           (cycle.increments[20].displacement - cycle.increments[60].displacement));
    EXPECT_EQ(cycle.first_contact, std::nullopt);
  }
}

TEST(CycleRunner, RepeatsUntilTheLoopHasSettled) {
  Case input = short_case(10);
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.preload = PlaneTarget{.control = Control::displacement, .value = {0.0, -60e-6}};
  cycle.amplitude.value = 10e-6;
  cycle.cycles = 50;
  CycleRunner runner(make_bearing_foils(input), {});
  const Cycle last = runner.run(1.5 * pi, cycle);
  ASSERT_TRUE(last.converged());
  EXPECT_TRUE(last.settled);
  ASSERT_GT(last.loop_energies.size(), 2U);
  ASSERT_LT(last.loop_energies.size(), 50U);
  EXPECT_EQ(last.loop_energies.back(), *last.loop_energy);
  EXPECT_NEAR(last.loop_energies.back(), *(last.loop_energies.end() - 2), 1e-6 * *last.loop_energy);
  EXPECT_GT(std::abs(last.loop_energies[1] - last.loop_energies[0]), 1e-6 * *last.loop_energy);
  EXPECT_EQ(last.increments.size(), 41U);  // of the last alone
  // Three cycles are the first three.
  cycle.cycles = 3;
  const Cycle third = runner.run(1.5 * pi, cycle);
  EXPECT_FALSE(third.settled);
  EXPECT_EQ(third.loop_energies, std::vector<double>(last.loop_energies.begin(), last.loop_energies.begin() + 3));
  EXPECT_LT(third.cost.iterations, last.cost.iterations);
}

/// Under load control the force points along the direction, and the journal goes wherever that takes it.
TEST(CycleRunner, FollowsALoad) {
  Case input = short_case(10);
  input.settings.get<CycleSettings>().amplitude = {.control = Control::load, .value = 80.0};
  CycleRunner runner(make_bearing_foils(input), {});
  for (const double direction : {0.3, 4.0}) {
    const Cycle cycle = runner.run(direction, input.settings.get<CycleSettings>());
    ASSERT_TRUE(cycle.converged());
    for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
      const Increment& increment = cycle.increments[k];
      const double load = 80.0 * static_cast<double>(k <= 10 ? k : 20 - k) / 10.0;
      // A millionth replaces zero; there the journal is only to be released.
      EXPECT_NEAR(increment.force_direct, std::max(load, 80e-6), load > 0.0 ? 1e-7 : 40e-6);
      EXPECT_NEAR(increment.force_cross, 0.0, load > 0.0 ? 1e-7 : 240e-6);
      EXPECT_DOUBLE_EQ(increment.displacement, Eigen::Vector2d(increment.x, increment.y).dot(unit_vector(direction)));
    }
    EXPECT_EQ(cycle.amplitude, cycle.increments[10].displacement);
    EXPECT_GT(*cycle.take_up, *cycle.first_contact);
    EXPECT_GT(*cycle.loss_factor, 0.0);
  }
}

/// The load turns round, and the journal crosses its clearance.
TEST(CycleRunner, IsFullyReversedThroughTheCentre) {
  Case input = short_case(6);
  input.settings.get<CycleSettings>().swing = true;
  const SharedBearing foils = make_bearing_foils(input);
  CycleRunner runner(foils, {});
  const Cycle by_displacement = runner.run(0.0, input.settings.get<CycleSettings>());
  ASSERT_TRUE(by_displacement.converged());
  EXPECT_EQ(by_displacement.increments.size(), 25U);
  const double range = by_displacement.increments[6].force_direct - by_displacement.increments[18].force_direct;
  EXPECT_DOUBLE_EQ(*by_displacement.loaded_stiffness, range / (2.0 * 79.5e-6));
  input.settings.get<CycleSettings>().amplitude = {.control = Control::load, .value = 60.0};
  const Cycle by_load = runner.run(0.0, input.settings.get<CycleSettings>());
  ASSERT_TRUE(by_load.converged());
  EXPECT_NEAR(by_load.increments[6].force_direct, 60.0, 1e-7);
  EXPECT_NEAR(by_load.increments[18].force_direct, -60.0, 1e-7);
  EXPECT_LT(by_load.increments[18].displacement, -31.8e-6);
}

TEST(CycleRunner, SaysThatThePreloadIsOutOfReach) {
  Case input = short_case(5);
  input.settings.get<CycleSettings>().preload = PlaneTarget{.control = Control::load, .value = {0.0, -1e7}};
  const Cycle cycle = CycleRunner(make_bearing_foils(input), {}).run(0.0, input.settings.get<CycleSettings>());
  EXPECT_EQ(cycle.status, Status::load_out_of_reach);
  EXPECT_EQ(cycle.increments.size(), 1U);
  EXPECT_EQ(cycle.loop_energy, std::nullopt);
}

/// Height errors as gap offsets of shared foils are height errors of foils of their own.
TEST(CycleRunner, TakesErrorsThatItsFoilsDoNotHave) {
  const Case nominal = short_case();
  Case scattered = nominal;
  scattered.bump_foil.height_errors = random_case(7).bump_foil.height_errors;
  const SharedBearing foils = make_bearing_foils(nominal);
  Excitation centre;
  centre.gap_offset = make_bearing_foils(scattered)->assembled_gap - foils->assembled_gap;
  const Cycle offset =
      CycleRunner(foils, {}).run(1.0, nominal.settings.get<CycleSettings>(), Recording::quantities, {}, centre);
  const Cycle built = run_single_cycle(scattered, 1.0);
  ASSERT_TRUE(offset.converged() && built.converged());
  EXPECT_NEAR(offset.turning_point->max_force, built.turning_point->max_force, 1e-9 * built.turning_point->max_force);
  EXPECT_NEAR(*offset.loop_energy, *built.loop_energy, 1e-9 * *built.loop_energy);
  EXPECT_EQ(*offset.first_contact, *built.first_contact);
}

TEST(RunCycles, StartsEveryDirectionAnew) {
  const Case input = short_case();
  const CycleResult all = run_cycles(input);
  ASSERT_EQ(all.cycles.size(), 4U);
  EXPECT_EQ(all.solver, SolverName::newton);
  EXPECT_TRUE(all.converged());
  for (std::size_t i = 0; i < 4; ++i) {
    const Cycle alone = run_single_cycle(input, input.settings.get<CycleSettings>().directions[i]);
    EXPECT_EQ(alone.turning_point->max_force, all.cycles[i].turning_point->max_force);
    EXPECT_EQ(*alone.loop_energy, *all.cycles[i].loop_energy);
  }
}

TEST(RunCycles, GivesTheSameNumbersEveryTime) {
  const CycleResult a = run_cycles(short_case());
  const CycleResult b = run_cycles(short_case());
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < a.cycles[i].increments.size(); ++k) {
      EXPECT_EQ(a.cycles[i].increments[k].force_direct, b.cycles[i].increments[k].force_direct);
    }
    EXPECT_EQ(a.cycles[i].fields.top_bump.friction_force, b.cycles[i].fields.top_bump.friction_force);
  }
}

TEST(RunCycles, ReportsProgressThatRisesToOne) {
  std::vector<double> seen;
  (void)run_cycles(short_case(), [&](double done) {
    seen.push_back(done);
    return true;
  });
  ASSERT_EQ(seen.size(), 84U);
  for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_GT(seen[i], seen[i - 1]);
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
}

TEST(RunCycles, StopsWhenAskedAndKeepsWhatIsThere) {
  int calls = 0;
  // After the turning point of the second direction: increments 0..20 of the first, 0..12 of the second.
  const CycleResult result = run_cycles(short_case(), [&](double) { return ++calls < 34; });
  ASSERT_EQ(result.cycles.size(), 2U);
  EXPECT_TRUE(result.cycles[0].converged());
  const Cycle& stopped = result.cycles[1];
  EXPECT_EQ(stopped.status, Status::interrupted);
  EXPECT_FALSE(result.converged());
  EXPECT_EQ(stopped.increments.size(), 13U);
  EXPECT_TRUE(stopped.turning_point.has_value());
  EXPECT_EQ(stopped.loop_energy, std::nullopt);
  EXPECT_EQ(stopped.loss_factor, std::nullopt);
}

TEST(RunCycles, StoppedBeforeTheTurningPointHasNone) {
  const CycleResult result = run_cycles(short_case(), [](double) { return false; });
  ASSERT_EQ(result.cycles.size(), 1U);
  EXPECT_EQ(result.cycles[0].increments.size(), 1U);
  EXPECT_EQ(result.cycles[0].turning_point, std::nullopt);
  EXPECT_FALSE(result.converged());
}

TEST(RunCycles, OneStepPerBranchIsEnoughToTurn) {
  const Cycle cycle = run_single_cycle(short_case(1), 0.0);
  EXPECT_TRUE(cycle.converged());
  ASSERT_EQ(cycle.increments.size(), 3U);
  EXPECT_GT(cycle.turning_point->max_force, 100.0);
  EXPECT_EQ(*cycle.loop_energy, 0.0);  // both trapezia are the same triangle
}

}  // namespace
}  // namespace bumpfoil
