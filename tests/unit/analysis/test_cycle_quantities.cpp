#include "bumpfoil/analysis/cycle_quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/dense_contacts.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

constexpr double pi = std::numbers::pi;

/// Increments 10 um apart with these direct forces; the last `unloading` of them unload.
std::vector<Increment> increments(const std::vector<double>& forces, std::size_t unloading = 0) {
  std::vector<Increment> out;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    Increment next;
    next.displacement = 1e-5 * static_cast<double>(k);
    next.force_direct = forces[k];
    next.branch = k + unloading < forces.size() ? Branch::loading : Branch::unloading;
    out.push_back(next);
  }
  return out;
}

TEST(ClearanceAt, IsLinearBetweenIncrements) {
  EXPECT_DOUBLE_EQ(*clearance_at(increments({0.0, 2.0, 10.0}), 5.0), 1e-5 + 3.0 / 8.0 * 1e-5);
  EXPECT_DOUBLE_EQ(*clearance_at(increments({0.0, 5.0, 10.0}), 5.0), 1e-5);
  EXPECT_DOUBLE_EQ(*clearance_at(increments({-4.0, 6.0}), 5.0), 0.9e-5);
}

TEST(ClearanceAt, TakesTheFirstUpwardCrossing) {
  EXPECT_DOUBLE_EQ(*clearance_at(increments({0.0, 10.0, 0.0, 10.0}), 5.0), 0.5e-5);
}

TEST(ClearanceAt, IsZeroAboveFromTheStartAndAbsentIfNeverReached) {
  EXPECT_EQ(clearance_at(increments({5.0, 3.0, 10.0}), 5.0), 0.0);
  EXPECT_EQ(clearance_at(increments({0.0, 4.9}), 5.0), std::nullopt);
  EXPECT_EQ(clearance_at(increments({0.0, 4.0, 10.0}, 1), 5.0), std::nullopt);  // only while unloading
  EXPECT_EQ(clearance_at({}, 5.0), std::nullopt);
}

TEST(FirstContact, IsWhereTheNearestCrestIsMet) {
  Case input = case_with_given_constants();
  const FoilModel model = make_bearing_model(input);
  const Vector at_rest = Vector::Zero(26);
  // Towards crest 5 exactly: the clearance; half-way between two crests: a little more.
  const double pitch_angle = input.bump_foil.pitch / input.bearing.radius;
  EXPECT_NEAR(*first_contact_displacement(model.clearance, model.normals, at_rest, unit_vector(pi - 4.5 * pitch_angle)),
              31.8e-6, 1e-18);
  EXPECT_NEAR(*first_contact_displacement(model.clearance, model.normals, at_rest, unit_vector(pi - 5.0 * pitch_angle)),
              31.8e-6 / std::cos(0.5 * pitch_angle), 1e-18);
}

TEST(FirstContact, SeesTheTopFoilWhereItStands) {
  const FoilModel model = make_bearing_model(case_with_given_constants());
  Vector displaced = Vector::Zero(26);
  displaced[12] = -10e-6;  // inward
  const Eigen::Vector2d towards = model.normals.col(12);
  EXPECT_NEAR(*first_contact_displacement(model.clearance, model.normals, displaced, towards), 21.8e-6, 1e-18);
  displaced[12] = -31.8e-6;
  EXPECT_EQ(first_contact_displacement(model.clearance, model.normals, displaced, towards), 0.0);
}

TEST(FirstContact, IsAbsentWhereNoCrestFacesTheDirection) {
  Case input = case_with_given_constants();
  input.bump_foil.bumps = 6;  // 82 degrees from the weld on
  const FoilModel model = make_bearing_model(input);
  EXPECT_EQ(first_contact_displacement(model.clearance, model.normals, Vector::Zero(6), unit_vector(0.0)),
            std::nullopt);
  EXPECT_TRUE(first_contact_displacement(model.clearance, model.normals, Vector::Zero(6), unit_vector(pi)).has_value());
}

TEST(LossFactor, ComparesTheLoopWithTheEnergyStored) {
  EXPECT_DOUBLE_EQ(*loss_factor(4.0 * pi, 2.0), 1.0);
  EXPECT_EQ(loss_factor(1.0, 0.0), std::nullopt);
  EXPECT_EQ(loss_factor(1.0, -1.0), std::nullopt);
  EXPECT_EQ(loss_factor(1.0, std::nan("")), std::nullopt);
}

/// The reference bearing pushed to 2.5 clearances along n.
class Pushed : public testing::TestWithParam<double> {
 protected:
  void SetUp() override {
    for (int k = 0; k <= 50; ++k) {
      const ContactState previous = state;
      ASSERT_TRUE(solver.solve(loading_at(model, k * 1.59e-6 * n), previous, state).converged);
    }
  }

  [[nodiscard]] double force(const Vector& normal_force) const { return holding_force(model, normal_force).dot(n); }

  /// Slope of the force when the journal moves by `step` from where it is.
  double slope(double step) {
    ContactState moved;
    EXPECT_TRUE(solver.solve(loading_at(model, (79.5e-6 + step) * n), state, moved).converged);
    return (force(moved.normal_force) - force(state.normal_force)) / step;
  }

  const FoilModel model = make_bearing_model(case_with_given_constants());
  const Eigen::Vector2d n = unit_vector(GetParam());
  NewtonSolver solver{model.problem};
  ContactState state = ContactState::unstressed(model.problem);
};

TEST_P(Pushed, TangentsAreTheSlopesOfSmallSteps) {
  const TangentStiffnesses tangent = tangent_stiffnesses(model, state, n);
  constexpr double step = 1e-11;  // short of the next event
  EXPECT_NEAR(slope(step), tangent.loading.value(), 1e-4 * *tangent.loading);
  // A few lightly loaded contacts lose their grip at once as the journal turns back; by definition they are stuck.
  EXPECT_NEAR(slope(-step), tangent.unloading.value(), 0.01 * *tangent.unloading);
  EXPECT_GT(*tangent.unloading, 1.5 * *tangent.loading);
}

TEST_P(Pushed, UnloadingTangentHoldsEveryClosedContact) {
  std::vector<ContactMode> mode = state.mode;
  for (ContactMode& m : mode) m = m == ContactMode::open ? m : ContactMode::stick;
  const DenseState rate = solve_dense(make_dense(model.problem), loading_rate(model, n), 0.0 * state.x, mode);
  const double expected = force(rate.normal_force);
  EXPECT_NEAR(tangent_stiffnesses(model, state, n).unloading.value(), expected, 1e-9 * expected);
}

INSTANTIATE_TEST_SUITE_P(TangentStiffnesses, Pushed, testing::Values(0.0, pi, 1.0, 4.0));

TEST(TangentStiffnesses, OfUntouchedFoilsAreZero) {
  const FoilModel model = make_bearing_model(case_with_given_constants());
  ContactState state = ContactState::unstressed(model.problem);
  state.mode.assign(78, ContactMode::stick);
  for (std::size_t i = 0; i < 26; ++i) state.mode[3 * i] = ContactMode::open;
  const TangentStiffnesses tangent = tangent_stiffnesses(model, state, unit_vector(0.0));
  EXPECT_EQ(tangent.loading, 0.0);
  EXPECT_EQ(tangent.unloading, 0.0);
}

TEST(TangentStiffnesses, OfFoilsThatNothingHoldsAreAbsent) {
  FoilModel model = make_bearing_model(case_with_given_constants());
  // No spring holds crest 8 along the foil any more.
  model.problem.K.diagonal[7].row(0).setZero();
  model.problem.K.diagonal[7].col(0).setZero();
  model.problem.K.upper[6].col(0).setZero();
  model.problem.K.upper[7].row(0).setZero();
  model.structure.K = model.problem.K;
  ContactState state = ContactState::unstressed(model.problem);
  state.mode.assign(78, ContactMode::open);
  const TangentStiffnesses tangent = tangent_stiffnesses(model, state, unit_vector(0.0));
  EXPECT_EQ(tangent.loading, std::nullopt);
  EXPECT_EQ(tangent.unloading, std::nullopt);
}

/// An increment with these stresses and no others.
Increment stressed(int index, const FoilStress& stress) {
  Increment increment;
  increment.index = index;
  increment.displacement = 1e-6 * index;
  increment.stress = stress;
  return increment;
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

  const StressPeak top = top_foil_peak({stressed(0, low), stressed(1, high), stressed(2, high)}).value();
  EXPECT_EQ(top.stress, 9.0);
  EXPECT_EQ(top.place, StressPlace::crest);
  EXPECT_EQ(top.bump, 1);
  EXPECT_EQ(top.increment, 1);  // where it acts first
  EXPECT_EQ(top.displacement, 1e-6);
  EXPECT_EQ(top_foil_peak({stressed(0, low)})->place, StressPlace::weld);
  EXPECT_EQ(top_foil_peak({stressed(0, low)})->bump, -1);

  const StressPeak crest = bump_foil_peak({stressed(0, low)}).value();
  EXPECT_EQ(crest.place, StressPlace::crest);  // not the arc, which is no larger
  EXPECT_EQ(crest.bump, 1);
  const StressPeak foot = bump_foil_peak({stressed(0, low), stressed(1, high)}).value();
  EXPECT_EQ(foot.place, StressPlace::foot);
  EXPECT_EQ(foot.bump, 1);
  EXPECT_EQ(bump_foil_peak({stressed(0, higher)})->place, StressPlace::arc);
  EXPECT_EQ(bump_foil_peak({stressed(0, FoilStress{})}), std::nullopt);
}

}  // namespace
}  // namespace bumpfoil
