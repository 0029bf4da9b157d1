#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

/// Points with these forces, 10 um apart.
LoadingCurve curve(const std::vector<double>& forces, std::optional<double> first_contact = {}) {
  LoadingCurve curve(first_contact);
  for (std::size_t k = 0; k < forces.size(); ++k) curve.add({1e-5 * static_cast<double>(k), forces[k]});
  return curve;
}

TEST(LoadingCurve, IsLinearBetweenPoints) {
  EXPECT_DOUBLE_EQ(*curve({0.0, 2.0, 10.0}).first_reaches(5.0), 1e-5 + 3.0 / 8.0 * 1e-5);
  EXPECT_DOUBLE_EQ(*curve({0.0, 5.0, 10.0}).first_reaches(5.0), 1e-5);
  EXPECT_DOUBLE_EQ(*curve({-4.0, 6.0}).first_reaches(5.0), 0.9e-5);
}

TEST(LoadingCurve, StaysAsItIsUntilTheFirstContact) {
  EXPECT_DOUBLE_EQ(*curve({0.0, 10.0}, 4e-6).first_reaches(5.0), 7e-6);
  EXPECT_DOUBLE_EQ(*curve({0.0, 0.0, 10.0}, 1e-5).first_reaches(5.0), 1.5e-5);
  EXPECT_DOUBLE_EQ(*curve({1.0, 9.0}, 0.0).first_reaches(5.0), 5e-6);
}

TEST(LoadingCurve, FindsTheFirstCrossingAndTheLast) {
  const LoadingCurve twice = curve({0.0, 10.0, 0.0, 10.0});
  EXPECT_DOUBLE_EQ(*twice.first_reaches(5.0), 0.5e-5);
  EXPECT_DOUBLE_EQ(twice.last_rises_through(5.0).displacement, 2.5e-5);
  EXPECT_DOUBLE_EQ(twice.last_rises_through(5.0).force, 5.0);
}

TEST(LoadingCurve, BeginsAtItsStartWhereItLiesAboveAllTheTime) {
  EXPECT_EQ(curve({5.0, 3.0, 10.0}).first_reaches(5.0), 0.0);
  EXPECT_EQ(curve({7.0, 6.0, 10.0}).last_rises_through(5.0).displacement, 0.0);
  EXPECT_EQ(curve({7.0, 6.0, 10.0}).last_rises_through(5.0).force, 7.0);
}

TEST(LoadingCurve, NeedNotReachAForce) {
  EXPECT_EQ(curve({0.0, 4.9}).first_reaches(5.0), std::nullopt);
  EXPECT_EQ(curve({}).first_reaches(5.0), std::nullopt);
}

/// A cycle of two steps per branch with these forces, of which the first `taken` increments exist.
Cycle fed(const std::vector<double>& forces, std::size_t taken) {
  Cycle cycle;
  cycle.amplitude = 2e-5;
  cycle.steps = 2;
  cycle.due = 5;
  cycle.clearances = {{.force = 5.0, .displacement = {}}};
  CycleQuantities quantities(cycle);
  for (std::size_t k = 0; k < taken; ++k) {
    Increment next;
    next.index = static_cast<int>(k);
    next.displacement = 1e-5 * static_cast<double>(k <= 2 ? k : 4 - k);
    next.force_direct = forces[k];
    next.elastic_energy = 1e-3 * static_cast<double>(k <= 2 ? k : 4 - k);
    next.work = 1e-4 * static_cast<double>(k);
    next.residuals.equilibrium = 1e-12 * static_cast<double>(k);
    next.cost = {.iterations = 2, .factorisations = 1, .outer_iterations = 0};
    quantities.add(next, true, k == 2 || k == 4);
    if (k == 2) quantities.turn({});
  }
  quantities.finish();
  return cycle;
}

TEST(CycleQuantities, FollowFromTheIncrementsThatPass) {
  const Cycle cycle = fed({0.0, 4.0, 20.0, 8.0, 0.0}, 5);
  EXPECT_TRUE(cycle.converged());
  EXPECT_EQ(cycle.turning_point->max_force, 20.0);
  EXPECT_DOUBLE_EQ(*cycle.secant_stiffness, 20.0 / 2e-5);
  EXPECT_EQ(cycle.turns.size(), 2U);
  EXPECT_EQ(cycle.start->index, 0);
  EXPECT_DOUBLE_EQ(*cycle.loop_energy, 4e-4);
  // The force exceeds 1 % of its maximum, 0.2 N, at 0.5 um.
  EXPECT_DOUBLE_EQ(*cycle.take_up, 0.5e-6);
  const double stiffness = 19.8 / 19.5e-6;
  EXPECT_DOUBLE_EQ(*cycle.loaded_stiffness, stiffness);
  EXPECT_DOUBLE_EQ(*cycle.loss_factor, 4e-4 / (pi * stiffness * 9.75e-6 * 9.75e-6));
  EXPECT_DOUBLE_EQ(*cycle.specific_damping_capacity, 4e-4 / 2e-3);
  EXPECT_DOUBLE_EQ(*cycle.clearances[0].displacement, 1e-5 + 1.0 / 16.0 * 1e-5);
  EXPECT_EQ(cycle.cost.iterations, 10);
  EXPECT_EQ(cycle.cost.factorisations, 5);
  EXPECT_EQ(cycle.max_residual, 4e-12);
}

TEST(CycleQuantities, TakeTheWayToAnIncrementIntoAccount) {
  Cycle cycle;
  cycle.steps = 1;
  cycle.due = 3;
  cycle.first_contact = 2e-6;
  cycle.clearances = {{.force = 4.0, .displacement = {}}, {.force = 30.0, .displacement = {}}};
  CycleQuantities quantities(cycle);
  quantities.add({}, true, false);
  Increment turning;
  turning.index = 1;
  turning.displacement = 1e-5;
  turning.force_direct = 20.0;
  const LoadingCurve::Point way[] = {{6e-6, 8.0}};
  quantities.add(turning, true, true, way);
  quantities.turn({});
  quantities.finish();
  EXPECT_DOUBLE_EQ(*cycle.clearances[0].displacement, 4e-6);
  EXPECT_EQ(cycle.clearances[1].displacement, std::nullopt);
  EXPECT_DOUBLE_EQ(*cycle.take_up, 2e-6 + 0.2 / 8.0 * 4e-6);
}

/// A fully reversed cycle from +10 to -10 um, with 30 and 10 N there.
TEST(CycleQuantities, OfAFullyReversedCycleCompareItsTurningPoints) {
  Cycle cycle;
  cycle.course = Course::fully_reversed;
  cycle.clearances = {{.force = 5.0, .displacement = {}}};
  cycle.steps = 1;
  cycle.due = 4;
  CycleQuantities quantities(cycle);
  const std::vector<Increment> increments = [] {
    std::vector<Increment> all(4);
    const double displacement[] = {0.0, 1e-5, -1e-5, 0.0};
    const double force[] = {20.0, 30.0, 10.0, 20.0};
    for (int k = 0; k < 4; ++k) {
      Increment& next = all[static_cast<std::size_t>(k)];
      next.index = k;
      next.displacement = displacement[k];
      next.force_direct = force[k];
      next.work = 1e-6 * k;
    }
    return all;
  }();
  for (const Increment& next : increments) {
    quantities.add(next, true, next.index > 0);
    if (next.index == 1) quantities.turn({});
  }
  quantities.finish();
  EXPECT_DOUBLE_EQ(*cycle.loaded_stiffness, 1e6);
  EXPECT_DOUBLE_EQ(*cycle.loss_factor, 3e-6 / (pi * 1e6 * 1e-10));
  EXPECT_EQ(cycle.take_up, std::nullopt);
  EXPECT_EQ(cycle.secant_stiffness, std::nullopt);
  EXPECT_EQ(cycle.clearances[0].displacement, std::nullopt);
}

TEST(CycleQuantities, TakeARoundingForNoLoop) {
  for (const auto& [last_work, loop] : {std::pair{-1e-18, 0.0}, std::pair{2e-7, 2e-7}}) {
    Cycle cycle;
    cycle.steps = 1;
    cycle.due = 3;
    CycleQuantities quantities(cycle);
    const double work[] = {0.0, 1e-3, last_work};
    for (int k = 0; k < 3; ++k) {
      Increment next;
      next.index = k;
      next.displacement = k == 1 ? 1e-5 : 0.0;
      next.force_direct = k == 1 ? 10.0 : 0.0;
      next.work = work[k];
      quantities.add(next, true, k > 0);
      if (k == 1) quantities.turn({});
    }
    quantities.finish();
    EXPECT_EQ(cycle.loop_energy, loop);
    EXPECT_EQ(std::signbit(*cycle.loop_energy), false);
    EXPECT_EQ(*cycle.loss_factor == 0.0, loop == 0.0);
  }
}

TEST(CycleQuantities, LeaveOutWhatNeedsTheWholeCycle) {
  EXPECT_EQ(fed({0.0, 4.0, 20.0, 8.0, 0.0}, 4).loop_energy, std::nullopt);
  EXPECT_TRUE(fed({0.0, 4.0, 20.0, 8.0, 0.0}, 4).turning_point);
  EXPECT_EQ(fed({0.0, 4.0, 20.0, 8.0, 0.0}, 2).turning_point, std::nullopt);
}

TEST(CycleQuantities, SeekClearancesOnTheLoadingBranchAlone) {
  EXPECT_EQ(fed({0.0, 3.0, 4.0, 8.0, 0.0}, 5).clearances[0].displacement, std::nullopt);
}

TEST(CycleQuantities, KeepTheStatusOfTheIncrementThatFailed) {
  Cycle cycle;
  cycle.due = 3;
  CycleQuantities quantities(cycle);
  Increment next;
  quantities.add(next, true, false);
  next.status = Status::no_modes;
  next.cost.iterations = 7;
  quantities.add(next, false, false);
  quantities.finish();
  EXPECT_EQ(cycle.status, Status::no_modes);
  EXPECT_EQ(cycle.cost.iterations, 7);  // includes failed increments
  EXPECT_EQ(cycle.loop_energy, std::nullopt);
}

TEST(CycleQuantities, DoNotTakeAnUnknownResidualForASmallOne) {
  for (const bool known : {true, false}) {
    Cycle cycle;
    cycle.due = 3;
    CycleQuantities quantities(cycle);
    Increment next;
    for (const double residual : {1e-12, known ? 3e-12 : std::nan(""), 2e-12}) {
      next.residuals.equilibrium = residual;
      quantities.add(next, true, false);
    }
    if (known) {
      EXPECT_EQ(cycle.max_residual, 3e-12);
    } else {
      EXPECT_TRUE(std::isnan(cycle.max_residual));
    }
  }
}

TEST(FirstContact, IsWhereTheNearestCrestIsMet) {
  Case input = case_with_given_constants();
  const SharedBearing foils = make_bearing_foils(input);
  const Vector clear = Vector::Constant(26, input.bearing.radial_clearance);
  // Exactly towards crest 5: the clearance; half-way between two crests: slightly more.
  const double pitch_angle = input.bump_foil.pitch.values.front() / input.bearing.radius;
  EXPECT_NEAR(*first_contact_displacement(clear, foils->normals, unit_vector(pi - 4.5 * pitch_angle)), 31.8e-6, 1e-18);
  EXPECT_NEAR(*first_contact_displacement(clear, foils->normals, unit_vector(pi - 5.0 * pitch_angle)),
              31.8e-6 / std::cos(0.5 * pitch_angle), 1e-18);
}

TEST(FirstContact, IsAbsentWhereNoCrestFacesTheDirection) {
  Case input = case_with_given_constants();
  input.bump_foil.bumps = 6;  // 82 degrees, starting at the weld
  const SharedBearing foils = make_bearing_foils(input);
  const Vector clear = Vector::Constant(6, foils->clearance);
  EXPECT_EQ(first_contact_displacement(clear, foils->normals, unit_vector(0.0)), std::nullopt);
  EXPECT_TRUE(first_contact_displacement(clear, foils->normals, unit_vector(pi)).has_value());
}

/// Increments with these stresses, one row each, 1 um apart.
struct Stressed {
  StressFields fields;
  std::vector<Increment> increments;

  void add(const FoilStress& stress) {
    const auto row = static_cast<Eigen::Index>(increments.size());
    Increment next;
    next.index = static_cast<int>(row);
    next.displacement = 1e-6 * static_cast<double>(row);
    increments.push_back(next);
    const auto append = [row](FieldMatrix& field, const Vector& values) {
      field.conservativeResize(row + 1, values.size());
      field.row(row) = values.transpose();
    };
    append(fields.top_weld, stress.top_weld ? Vector::Constant(1, *stress.top_weld) : Vector());
    append(fields.top_crest, stress.top_crest);
    append(fields.bump_weld, stress.bump_weld ? Vector::Constant(1, *stress.bump_weld) : Vector());
    append(fields.bump_crest, stress.bump_crest);
    append(fields.bump_foot, stress.bump_foot);
    append(fields.bump_largest, stress.bump_largest);
  }
};

std::optional<StressPeak> top_peak(const std::vector<FoilStress>& stresses) {
  Stressed stressed;
  for (const FoilStress& stress : stresses) stressed.add(stress);
  return top_foil_peak(stressed.fields, stressed.increments);
}

std::optional<StressPeak> bump_peak(const std::vector<FoilStress>& stresses) {
  Stressed stressed;
  for (const FoilStress& stress : stresses) stressed.add(stress);
  return bump_foil_peak(stressed.fields, stressed.increments);
}

TEST(StressPeaks, NamePlaceAndTimeOfTheLargest) {
  FoilStress low;
  low.top_weld = 3.0;
  low.top_crest = Vector{{1.0, 2.0}};
  low.bump_weld = 4.0;
  low.bump_crest = Vector{{5.0, 6.0}};
  low.bump_foot = Vector{{6.0, 1.0, 2.0, 5.5}};
  low.bump_largest = Vector{{6.0, 6.0}};
  FoilStress high = low;
  high.top_crest[1] = 9.0;
  high.bump_foot[3] = 7.0;
  FoilStress higher = high;
  higher.bump_largest[1] = 8.0;

  const StressPeak top = top_peak({low, high, high}).value();
  EXPECT_EQ(top.stress, 9.0);
  EXPECT_EQ(top.place, StressPlace::crest);
  EXPECT_EQ(top.bump, 1);
  EXPECT_EQ(top.increment, 1);  // first occurrence
  EXPECT_EQ(top.displacement, 1e-6);
  EXPECT_EQ(top_peak({low})->place, StressPlace::weld);
  EXPECT_EQ(top_peak({low})->bump, -1);
  EXPECT_EQ(top_peak({low})->pad, 0);
  Stressed of_pads;
  of_pads.add(low);
  of_pads.fields.top_weld = FieldMatrix{{3.0, 1.0, 4.0}};
  EXPECT_EQ(top_foil_peak(of_pads.fields, of_pads.increments)->pad, 2);

  const StressPeak crest = bump_peak({low}).value();
  EXPECT_EQ(crest.place, StressPlace::crest);  // not the arc, whose stress is not higher
  EXPECT_EQ(crest.bump, 1);
  const StressPeak foot = bump_peak({low, high}).value();
  EXPECT_EQ(foot.place, StressPlace::foot);
  EXPECT_EQ(foot.bump, 1);
  EXPECT_EQ(bump_peak({higher})->place, StressPlace::arc);
  low.bump_largest[1] *= 1.0 + 1e-12;  // round-off
  EXPECT_EQ(bump_peak({low})->place, StressPlace::crest);
  EXPECT_EQ(bump_peak({FoilStress{}}), std::nullopt);
}

TEST(CompressionPeak, NamesBumpAndTimeOfTheLargest) {
  std::vector<Increment> increments(3);
  for (int k = 0; k < 3; ++k) {
    increments[static_cast<std::size_t>(k)].index = k;
    increments[static_cast<std::size_t>(k)].displacement = 1e-6 * k;
  }
  FieldMatrix compression(3, 2);
  compression << 0.0, 1e-6, 5e-6, 7e-6, 7e-6, 2e-6;
  EXPECT_EQ(compression_peak(compression, increments),
            (CompressionPeak{.compression = 7e-6, .bump = 1, .increment = 1, .displacement = 1e-6}));
  EXPECT_EQ(compression_peak({}, {}), std::nullopt);
}

}  // namespace
}  // namespace bumpfoil
