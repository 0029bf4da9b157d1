#include "bumpfoil/bearing/increment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

const Eigen::Vector2d up(0.0, 1.0);

/// An invented step of the reference bearing: bump 3 in contact, all else open.
struct IncrementExample {
  SharedBearing foils = make_bearing_foils(case_with_given_constants());
  Step step;

  IncrementExample() {
    step.state = BearingState::unstressed(*foils);
    step.state.position = {1e-6, 2e-6};
    step.state.contacts.normal_force[6] = 20.0;
    step.state.work = 3.0;
    step.state.dissipated_energy = 2.0;
    step.cost.iterations = 5;
    step.substeps = 1;
  }
};

TEST(PlaceIncrement, ResolvesTheForceOnTheJournal) {
  const IncrementExample example;
  const Increment increment = place_increment(*example.foils, example.step, up);
  const Case input = case_with_given_constants();
  const double phi = polar_angles(input.bearing, crest_angles(input))[2];
  EXPECT_NEAR(increment.force_x, 20.0 * std::cos(phi), 1e-13);
  EXPECT_NEAR(increment.force_y, 20.0 * std::sin(phi), 1e-13);
  EXPECT_EQ(increment.force_direct, increment.force_y);  // n is +Y
  EXPECT_EQ(increment.force_cross, -increment.force_x);  // n turned by +90 deg is -X
}

TEST(PlaceIncrement, CopiesPlaceEnergiesAndCost) {
  const IncrementExample example;
  const Increment increment = place_increment(*example.foils, example.step, up);
  EXPECT_EQ(increment.x, 1e-6);
  EXPECT_EQ(increment.y, 2e-6);
  EXPECT_EQ(increment.displacement, 2e-6);
  EXPECT_EQ(increment.work, 3.0);
  EXPECT_EQ(increment.dissipated_energy, 2.0);
  EXPECT_EQ(increment.cost.iterations, 5);
  EXPECT_EQ(increment.substeps, 1);
  EXPECT_TRUE(std::isnan(increment.elastic_energy));  // not computed yet
  EXPECT_FALSE(increment.residuals.within());
}

TEST(Checks, FindsEnergyAndResiduals) {
  IncrementExample example;
  example.step.state.contacts.x[0] = 1e-6;
  Increment increment = place_increment(*example.foils, example.step, up);
  check_increment(*example.foils, example.step.state, increment);
  const Vector& x = example.step.state.contacts.x;
  EXPECT_DOUBLE_EQ(increment.elastic_energy, elastic_response(example.foils->structure, x).energy);
  // Invented forces are not in balance.
  EXPECT_GT(increment.residuals.equilibrium, 0.1);
}

TEST(FailedIncrement, KnowsItsPlaceAndItsReasonAlone) {
  IncrementExample example;
  example.step.status = Status::no_modes;
  const Increment increment = failed_increment(example.step, up);
  EXPECT_EQ(increment.status, Status::no_modes);
  EXPECT_FALSE(increment.converged());
  EXPECT_EQ(increment.displacement, 2e-6);
  EXPECT_EQ(increment.cost.iterations, 5);
  for (const double value :
       {increment.force_x, increment.force_y, increment.force_direct, increment.force_cross, increment.elastic_energy,
        increment.dissipated_energy, increment.work, increment.residuals.equilibrium}) {
    EXPECT_TRUE(std::isnan(value));
  }
}

}  // namespace
}  // namespace bumpfoil
