#include "bumpfoil/bearing/bearing_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

TEST(BearingModel, HasThreeContactsPerBumpOfTheTruss) {
  Case input = case_with_given_constants();
  input.friction = {.top_bump = 0.2, .bump_sleeve = 0.3};
  const SharedBearing foils = make_bearing_foils(input);
  EXPECT_EQ(foils->bumps(), 26);
  EXPECT_EQ(foils->feet_per_block(), 1);
  ASSERT_EQ(foils->contacts_per_block(), 3);
  EXPECT_EQ(foils->problem.contacts(), 78);
  const BumpDofs& dofs = foils->structure.dofs;
  const ContactSite& journal = foils->problem.sites[0];
  EXPECT_EQ(journal.plus, dofs.top_u);
  EXPECT_EQ(journal.minus, -1);
  EXPECT_EQ(journal.tangential, -1);
  const ContactSite& crest = foils->problem.sites[1];
  EXPECT_EQ(crest.plus, dofs.crest_v);
  EXPECT_EQ(crest.minus, dofs.top_u);
  EXPECT_EQ(crest.tangential, dofs.crest_u);
  EXPECT_EQ(crest.friction_coefficient, 0.2);
  const ContactSite& foot = foils->problem.sites[2];
  EXPECT_EQ(foot.plus, -1);
  EXPECT_EQ(foot.minus, dofs.foot_v[0]);
  EXPECT_EQ(foot.tangential, dofs.foot_u[0]);
  EXPECT_EQ(foot.friction_coefficient, 0.3);
}

TEST(BearingModel, GapsCarryHeightErrorsSleeveGapsAndTheJournal) {
  Case input = case_with_given_constants();
  input.bump_foil.height_errors.assign(26, 0.0);
  input.bump_foil.height_errors[4] = 3e-6;
  input.bump_foil.sleeve_gaps.assign(26, 0.0);
  input.bump_foil.sleeve_gaps[7] = 2e-6;
  const SharedBearing foils = make_bearing_foils(input);
  const ContactLoading loading = loading_under(*foils, {.position = {1e-5, 2e-5}});
  ASSERT_EQ(loading.initial_gap.size(), 78);
  EXPECT_EQ(loading.load, Vector::Zero(foils->problem.K.rows()));
  for (Eigen::Index i = 0; i < 26; ++i) {
    // Default weld at 180 degrees, clockwise: r = C_r + x cos(theta) - y sin(theta).
    const double theta = (static_cast<double>(i) + 0.5) * input.bump_foil.pitch.values.front() / input.bearing.radius;
    const double gap = input.bearing.radial_clearance + 1e-5 * std::cos(theta) - 2e-5 * std::sin(theta);
    EXPECT_NEAR(loading.initial_gap[3 * i], gap, 1e-19);
    EXPECT_EQ(loading.initial_gap[3 * i + 1], i == 4 ? -3e-6 : 0.0);  // a taller bump has interference
    EXPECT_EQ(loading.initial_gap[3 * i + 2], i == 7 ? 2e-6 : 0.0);
  }
}

TEST(BearingModel, FollowsAWavySleeve) {
  Case input = case_with_given_constants();
  input.bump_foil.height_errors.assign(26, 1e-6);
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    input.bump_foil.model = model;
    input.bearing.sleeve.waves.clear();
    const Vector round = make_bearing_foils(input)->assembled_gap;
    input.bearing.sleeve.waves = {{.harmonic = 3, .amplitude = 5e-6, .phase = 0.7}};
    const SharedBearing foils = make_bearing_foils(input);
    const Vector added = foils->assembled_gap - round;
    const Vector feet = polar_angles(input.bearing, foot_angles(input));
    for (Eigen::Index i = 0; i < 26; ++i) {
      const Eigen::Index first = (foils->structure.first_bump + i) * foils->contacts_per_block();
      // Default weld at 180 degrees, clockwise.
      const double phi = std::numbers::pi -
                         (static_cast<double>(i) + 0.5) * input.bump_foil.pitch.values.front() / input.bearing.radius;
      EXPECT_NEAR(added[first], 5e-6 * std::cos(3.0 * phi - 0.7), 1e-19);
      EXPECT_NEAR(added[first + 1], 0.0, 1e-19);
      for (Eigen::Index k = 0; k < foils->feet_per_block(); ++k) {
        // The sum of the gaps from journal to sleeve increases by the wave under the foot.
        const double under_foot = 5e-6 * std::cos(3.0 * feet[i * foils->feet_per_block() + k] - 0.7);
        EXPECT_NEAR(added[first] + added[first + foils->first_foot() + k], under_foot, 1e-19);
      }
    }
  }
}

TEST(BearingModel, TapersWithTheSleeveAndGivesWayToTheJournal) {
  Case input = case_with_given_constants();
  const Vector round = make_bearing_foils(input)->assembled_gap;
  input.bearing.taper = 8e-6;
  input.bearing.journal.waves = {{.harmonic = 2, .amplitude = 3e-6, .phase = 0.4}};
  const SharedBearing foils = make_bearing_foils(input);
  const Vector added = foils->assembled_gap - round;
  for (Eigen::Index i = 0; i < 26; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / 26.0;  // relative position between weld and free end
    const double phi = std::numbers::pi - 26.0 * part * input.bump_foil.pitch.values.front() / input.bearing.radius;
    const Eigen::Index first = (foils->structure.first_bump + i) * foils->contacts_per_block();
    EXPECT_NEAR(added[first], 8e-6 * part - 3e-6 * std::cos(2.0 * phi - 0.4), 1e-19);
    // The foot of a truss is half a pitch further along.
    EXPECT_NEAR(added[first + foils->first_foot()], 8e-6 * 0.5 / 26.0, 1e-19);
  }
}

TEST(BearingModel, HasALawWhereDisplacementsAreLarge) {
  Case input = case_with_given_constants();
  input.bump_foil.model = BumpFoilModel::frame;
  EXPECT_FALSE(make_bearing_foils(input)->problem.law);
  input.bump_foil.geometry = Geometry::nonlinear;
  const SharedBearing foils = make_bearing_foils(input);
  ASSERT_TRUE(foils->problem.law);
  const Vector x = 1e-5 * Vector::LinSpaced(foils->problem.K.rows(), 0.3, 40.0).array().sin();
  EXPECT_EQ(foils->problem.law->forces(x), internal_forces(foils->structure, x));
  EXPECT_EQ(foils->problem.law->tangent(x).dense(), tangent_stiffness(foils->structure, x).dense());
  EXPECT_EQ(foils->problem.law->stable_tangent(x).dense(), stable_tangent_stiffness(foils->structure, x).dense());
}

TEST(BearingModel, LoadingRateIsTheDerivativeOfTheLoading) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  const Eigen::Vector2d direction = unit_vector(0.7);
  const ContactLoading rate = loading_rate(*foils, direction);
  const ContactLoading far = loading_under(*foils, {.position = 8e-5 * direction});
  const ContactLoading near = loading_under(*foils, {.position = 3e-5 * direction});
  EXPECT_LT((far.initial_gap - near.initial_gap - 5e-5 * rate.initial_gap).cwiseAbs().maxCoeff(), 1e-18);
  EXPECT_EQ(rate.load, Vector::Zero(foils->problem.K.rows()));
  EXPECT_EQ(rate.initial_gap[1], 0.0);
}

TEST(BearingModel, JournalLoadsAreEveryThirdContact) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  const Vector loads = pressing_loads(*foils, Vector::LinSpaced(78, 0.0, 77.0));
  ASSERT_EQ(loads.size(), 26);
  for (Eigen::Index i = 0; i < 26; ++i) EXPECT_DOUBLE_EQ(loads[i], 3.0 * static_cast<double>(i));
}

TEST(BearingModel, ExcitationsMayOffsetGapsAndLoadTheTopFoil) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  Excitation excitation{.position = {1e-5, 2e-5}};
  const ContactLoading plain = loading_under(*foils, excitation);
  excitation.gap_offset = Vector::LinSpaced(78, -1e-6, 1e-6);
  excitation.top_load = Vector::LinSpaced(26, 1.0, 26.0);
  const ContactLoading loading = loading_under(*foils, excitation);
  EXPECT_EQ(loading.initial_gap, plain.initial_gap + excitation.gap_offset);
  const int block = foils->structure.dofs.size;
  for (Eigen::Index i = 0; i < 26; ++i) {
    EXPECT_EQ(loading.load[i * block + foils->structure.dofs.top_u], excitation.top_load[i]);
  }
  EXPECT_DOUBLE_EQ(loading.load.sum(), excitation.top_load.sum());  // no loads elsewhere
}

TEST(BearingModel, RefusesCasesThatCannotBeBuilt) {
  Case input = case_with_given_constants();
  input.bump_foil.height_errors = {1e-6, 2e-6};  // 26 bumps
  EXPECT_THROW((void)make_bearing_foils(input), Error);
}

}  // namespace
}  // namespace bumpfoil
