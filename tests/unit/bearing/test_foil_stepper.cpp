#include "bumpfoil/bearing/foil_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/span_loads.hpp"
#include "support/dense_contacts.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;
const Eigen::Vector2d push = unit_vector(0.7);

SolverSettings solver(SolverName name) {
  return {.name = name, .uzawa = {}};
}

Excitation at(const Eigen::Vector2d& position) {
  return {.position = position};
}

double direct_force(const BearingModel& foils, const BearingState& state) {
  return holding_force(foils, state.contacts.normal_force).dot(push);
}

/// A bearing that was pushed to 60 um in three increments.
class PushedStepper : public testing::TestWithParam<SolverName> {
 protected:
  PushedStepper() {
    stepper.assemble({}, step);
    EXPECT_TRUE(step.converged());
    for (const double s : {40e-6, 50e-6, 60e-6}) advance(s * push);
  }

  void advance(const Eigen::Vector2d& position) {
    state = step.state;
    stepper.advance(state, at(position), step);
    EXPECT_TRUE(step.converged());
  }

  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  FoilStepper stepper = make_stepper(foils, solver(GetParam()));
  BearingState state;
  Step step;
};

TEST_P(PushedStepper, TellsWhereAStepLedAndWhatItTook) {
  EXPECT_EQ(step.state.position, Eigen::Vector2d(60e-6 * push));
  EXPECT_EQ(step.state.loading.initial_gap, loading_under(*foils, at(60e-6 * push)).initial_gap);
  EXPECT_GT(direct_force(*foils, step.state), 100.0);
  EXPECT_GT(step.state.work, state.work);
  EXPECT_GT(step.state.dissipated_energy, state.dissipated_energy);
  EXPECT_GT(step.cost.iterations, 0);
  EXPECT_EQ(step.substeps, 0);
  EXPECT_EQ(step.events.empty(), GetParam() != SolverName::events);
  for (const StepEvent& event : step.events) {
    EXPECT_GE(event.position.dot(push), state.position.dot(push));
    EXPECT_LE(event.position.dot(push), step.state.position.dot(push));
  }
}

/// The caller may drop what came out and take another step from the state that it kept.
TEST_P(PushedStepper, LeavesTheOldStateToGoBackTo) {
  const BearingState kept = step.state;
  Step far, again;
  stepper.advance(kept, at(75e-6 * push), far);
  ASSERT_TRUE(far.converged());
  stepper.advance(kept, at(62e-6 * push), again);
  FoilStepper other = make_stepper(foils, solver(GetParam()));
  Step fresh;
  other.advance(kept, at(62e-6 * push), fresh);
  EXPECT_EQ(again.state.contacts.x, fresh.state.contacts.x);
  EXPECT_EQ(again.state.work, fresh.state.work);
  EXPECT_EQ(again.state.dissipated_energy, fresh.state.dissipated_energy);
}

/// Increments of one path, and each increment as a path of its own.
TEST_P(PushedStepper, MovesTheSameWayAlongOnePathOrMany) {
  FoilStepper other = make_stepper(foils, solver(GetParam()));
  Step one;
  other.assemble({}, one);
  BearingState from = one.state;
  other.advance(from, at(40e-6 * push), one);
  from = one.state;
  other.set_out(from, at(60e-6 * push));
  for (const double fraction : {0.5, 1.0}) {
    other.advance_to(fraction, from, one);
    ASSERT_TRUE(one.converged());
    from = one.state;
  }
  const double solved = GetParam() == SolverName::uzawa ? 1e-6 : 1e-9;  // that of the multipliers
  const double force = direct_force(*foils, step.state);
  EXPECT_NEAR((one.state.position - step.state.position).norm(), 0.0, 1e-19);
  EXPECT_NEAR(direct_force(*foils, one.state), force, solved * force);
  EXPECT_NEAR(one.state.work, step.state.work, solved * step.state.work);
  EXPECT_NEAR(one.state.dissipated_energy, step.state.dissipated_energy, solved * step.state.work);
  // Events are those of the last increment, the second half of the path.
  ASSERT_EQ(one.events.size(), step.events.size());
  for (std::size_t i = 0; i < step.events.size(); ++i) {
    EXPECT_EQ(one.events[i].contact, step.events[i].contact);
    EXPECT_LT((one.events[i].position - step.events[i].position).norm(), 1e-14);
  }
}

TEST_P(PushedStepper, AssemblyForgetsWhatWasBefore) {
  Step again;
  stepper.assemble({}, again);
  FoilStepper other = make_stepper(foils, solver(GetParam()));
  Step fresh;
  other.assemble({}, fresh);
  EXPECT_EQ(again.state.contacts.x, fresh.state.contacts.x);
  EXPECT_EQ(again.state.work, 0.0);
}

INSTANTIATE_TEST_SUITE_P(FoilStepper, PushedStepper,
                         testing::Values(SolverName::newton, SolverName::events, SolverName::uzawa));

TEST(FoilStepper, CountsTheFrictionOfTheAssembly) {
  Case input = case_with_given_constants();
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[3] = 60e-6;  // squeezed between journal and sleeve at once
  FoilStepper stepper = make_stepper(make_bearing_foils(input), solver(SolverName::newton));
  Step step;
  stepper.assemble({}, step);
  ASSERT_TRUE(step.converged());
  EXPECT_GT(step.state.dissipated_energy, 0.0);
  EXPECT_EQ(step.state.work, 0.0);
}

/// Gap offsets that change with the journal at rest: a bump that grows by 60 um.
TEST(FoilStepper, FollowsGapsThatChange) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  Case grown = case_with_given_constants();
  grown.bump_foil.height_errors.assign(26, 0.0);
  grown.bump_foil.height_errors[3] = 60e-6;
  Excitation end;
  end.gap_offset = make_bearing_foils(grown)->assembled_gap - foils->assembled_gap;
  FoilStepper stepper = make_stepper(foils, solver(SolverName::newton));
  Step first, offset, built;
  stepper.assemble({}, first);
  stepper.advance(first.state, end, offset);
  make_stepper(make_bearing_foils(grown), solver(SolverName::newton)).assemble({}, built);
  ASSERT_TRUE(offset.converged() && built.converged());
  // One increment from foils without load is the assembly.
  EXPECT_LT((offset.state.contacts.normal_force - built.state.contacts.normal_force).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(built.state.contacts.normal_force.maxCoeff(), 1.0);
}

/// The second kind of excitation: a pressure on the top foil. Lifted off the bumps by suction, with the journal out of
/// reach, the foil is a free cantilever under a uniform load q: with a the angle of its free end
/// |     u = (R^4 q / EI') (1 - cos(theta) - (theta sin(theta - a) + sin(a) sin(theta)) / 2)
TEST(FoilStepper, APressureLiftsTheTopFoilAsTheClosedFormSays) {
  Case input = case_with_given_constants();
  input.bearing.radial_clearance = 1.9e-3;
  const SharedBearing foils = make_bearing_foils(input);
  const TopFoilBeam beam = make_top_foil_beam(make_bearing_design(input));
  const double end_angle = input.bump_foil.bumps * input.bump_foil.pitch.values.front() / input.bearing.radius;
  constexpr double q = -0.5;  // N/m: less than a millimetre, though the foil is soft
  Excitation suction;
  suction.top_load = crest_loads(beam, make_top_foil_moments(beam), end_angle, Vector::Constant(27, q));
  for (const SolverName name : {SolverName::newton, SolverName::events}) {
    FoilStepper stepper = make_stepper(foils, solver(name));
    Step first, step;
    stepper.assemble({}, first);
    stepper.advance(first.state, suction, step);
    ASSERT_TRUE(step.converged());
    EXPECT_EQ(step.state.contacts.normal_force.cwiseAbs().maxCoeff(), 0.0);
    const Vector u = step.state.contacts.x(foils->top_foil());
    const double scale = std::pow(beam.radius, 4) * q / beam.bending_stiffness;
    for (Eigen::Index i = 0; i < 26; ++i) {
      const double t = beam.theta[i];
      const double exact =
          scale * (1.0 - std::cos(t) - 0.5 * (t * std::sin(t - end_angle) + std::sin(end_angle) * std::sin(t)));
      EXPECT_NEAR(u[i], exact, 1e-9 * std::abs(scale)) << i;  // cond(K) = 1e5
    }
    Increment increment = place_increment(*foils, step, push);
    check_increment(*foils, step.state, increment);
    EXPECT_TRUE(increment.residuals.within()) << increment.residuals.equilibrium;
  }
}

/// The reference bearing pushed to 2.5 clearances along n.
class Pushed : public testing::TestWithParam<double> {
 protected:
  void SetUp() override {
    for (int k = 0; k <= 50; ++k) {
      const ContactState previous = state.contacts;
      ASSERT_TRUE(solver.solve(loading_under(*foils, at(k * 1.59e-6 * n)), previous, state.contacts).converged());
    }
  }

  [[nodiscard]] double force(const Vector& normal_force) const { return holding_force(*foils, normal_force).dot(n); }

  /// Slope of the force when the journal moves by `step` from where it is.
  double slope(double step) {
    ContactState moved;
    EXPECT_TRUE(solver.solve(loading_under(*foils, at((79.5e-6 + step) * n)), state.contacts, moved).converged());
    return (force(moved.normal_force) - force(state.contacts.normal_force)) / step;
  }

  TangentStiffnesses tangents() { return stepper.tangents(state).along(n); }

  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  const Eigen::Vector2d n = unit_vector(GetParam());
  NewtonSolver solver{foils->problem};
  FoilStepper stepper = make_stepper(foils);
  BearingState state = BearingState::unstressed(*foils);
};

TEST_P(Pushed, TangentsAreTheSlopesOfSmallSteps) {
  const TangentStiffnesses tangent = tangents();
  constexpr double step = 1e-11;  // short of the next event
  EXPECT_NEAR(slope(step), tangent.loading.value(), 1e-4 * *tangent.loading);
  // A few lightly loaded contacts slip immediately as the journal reverses; the unloading tangent assumes stick.
  EXPECT_NEAR(slope(-step), tangent.unloading.value(), 0.01 * *tangent.unloading);
  EXPECT_GT(*tangent.unloading, 1.5 * *tangent.loading);
}

TEST_P(Pushed, UnloadingTangentHoldsEveryClosedContact) {
  std::vector<ContactMode> mode = state.contacts.mode;
  for (ContactMode& m : mode) m = m == ContactMode::open ? m : ContactMode::stick;
  const DenseState rate =
      solve_dense(make_dense(foils->problem), loading_rate(*foils, n), 0.0 * state.contacts.x, mode);
  const double expected = force(rate.normal_force);
  EXPECT_NEAR(tangents().unloading.value(), expected, 1e-9 * expected);
}

/// Entry (i, j) = dF_i/dx_j: the column of a motion is the force that it takes.
TEST_P(Pushed, ColumnsOfTheTangentMatrixAreForcesOfMotions) {
  const Eigen::Matrix2d K = stepper.tangents(state).unloading.value();
  std::vector<ContactMode> mode = state.contacts.mode;
  for (ContactMode& m : mode) m = m == ContactMode::open ? m : ContactMode::stick;
  for (const int axis : {0, 1}) {
    const DenseState rate = solve_dense(make_dense(foils->problem), loading_rate(*foils, Eigen::Vector2d::Unit(axis)),
                                        0.0 * state.contacts.x, mode);
    EXPECT_LT((holding_force(*foils, rate.normal_force) - K.col(axis)).norm(), 1e-9 * K.norm());
  }
  // Without slip the foils are elastic, and their stiffness is symmetric.
  EXPECT_NEAR(K(0, 1), K(1, 0), 1e-9 * K.norm());
}

INSTANTIATE_TEST_SUITE_P(TangentStiffnesses, Pushed, testing::Values(0.0, pi, 1.0, 4.0));

TEST(TangentStiffnesses, OfUntouchedFoilsAreZero) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  BearingState state = BearingState::unstressed(*foils);
  state.contacts.mode.assign(78, ContactMode::stick);
  for (std::size_t i = 0; i < 26; ++i) state.contacts.mode[3 * i] = ContactMode::open;
  const TangentStiffnesses tangent = make_stepper(foils).tangents(state).along(unit_vector(0.0));
  EXPECT_EQ(tangent.loading, 0.0);
  EXPECT_EQ(tangent.unloading, 0.0);
}

TEST(FoilStepper, DoesNotTakeAFilm) {
  const auto running = std::make_shared<const BearingModel>(make_film_bearing(case_with_given_constants()));
  EXPECT_THROW(make_stepper(running), Error);
}

TEST(TangentStiffnesses, OfFoilsThatNothingHoldsAreAbsent) {
  BearingModel loose = *make_bearing_foils(case_with_given_constants());
  // No spring holds crest 8 along the foil any more.
  loose.problem.K.diagonal[7].row(0).setZero();
  loose.problem.K.diagonal[7].col(0).setZero();
  loose.problem.K.upper[6].col(0).setZero();
  loose.problem.K.upper[7].row(0).setZero();
  loose.structure.K = loose.problem.K;
  const auto foils = std::make_shared<const BearingModel>(loose);
  BearingState state = BearingState::unstressed(*foils);
  state.contacts.mode.assign(78, ContactMode::open);
  const TangentStiffnesses tangent = make_stepper(foils).tangents(state).along(unit_vector(0.0));
  EXPECT_EQ(tangent.loading, std::nullopt);
  EXPECT_EQ(tangent.unloading, std::nullopt);
}

}  // namespace
}  // namespace bumpfoil
