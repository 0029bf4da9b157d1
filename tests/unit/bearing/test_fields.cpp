#include "bumpfoil/bearing/fields.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/bearing_cases.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// An invented state of the reference bearing: bump 3 in contact, all else open. Recorded as increment 1 of 2.
struct Example {
  BearingModel foils = *make_bearing_foils(case_with_given_constants());
  BearingState state = BearingState::unstressed(foils);

  Example() {
    ContactState& contacts = state.contacts;
    contacts.gap.setConstant(5e-6);
    for (const int contact : {6, 7, 8}) contacts.gap[contact] = 0.0;
    contacts.normal_force.segment(6, 3) << 20.0, 15.0, 1e-12;
    contacts.friction_force[7] = -1.5;
    contacts.mode[6] = ContactMode::stick;
    contacts.mode[7] = ContactMode::slip_forward;
    contacts.mode[8] = ContactMode::stick;
    const int block = foils.problem.K.block_size();
    contacts.x[2 * block + foils.structure.dofs.crest_u] = 1e-7;
    contacts.x[2 * block + foils.structure.dofs.foot_v[0]] = -3e-7;
    contacts.x[2 * block + foils.structure.dofs.top_u] = 4e-7;
  }

  FoilFields recorded() const {
    FoilFields fields = make_fields(foils, 2);
    record(foils, BearingState::unstressed(foils), 0, fields);
    record(foils, state, 1, fields);
    return fields;
  }
};

TEST(Fields, AreSortedByInterfaceAndBumpInTheirRow) {
  const FoilFields fields = Example().recorded();
  EXPECT_EQ(fields.increments(), 2);
  EXPECT_EQ(fields.crest_u(1, 2), 1e-7);
  EXPECT_EQ(fields.foot_v(1, 2), -3e-7);
  EXPECT_EQ(fields.top_displacement(1, 2), 4e-7);
  EXPECT_EQ(fields.crest_u.cwiseAbs().sum(), 1e-7);
  EXPECT_EQ(fields.journal_top.normal_force(1, 2), 20.0);
  EXPECT_EQ(fields.top_bump.normal_force(1, 2), 15.0);
  EXPECT_EQ(fields.top_bump.normal_force.sum(), 15.0);
  EXPECT_EQ(fields.top_bump.friction_force(1, 2), -1.5);
  EXPECT_EQ(fields.top_bump.mode(1, 2), ContactMode::slip_forward);
  EXPECT_EQ(fields.top_bump.gap(1, 2), 0.0);
  EXPECT_EQ(fields.top_bump.gap(1, 3), 5e-6);
  EXPECT_EQ(fields.top_bump.mode(1, 3), ContactMode::open);
  EXPECT_EQ(fields.stress.top_crest.cols(), 26);
  EXPECT_EQ(fields.stress.bump_crest.cols(), 0);  // not available with the truss
}

TEST(Fields, ReportAContactWithoutLoadAsOpen) {
  const FoilFields fields = Example().recorded();
  EXPECT_EQ(fields.bump_sleeve.mode(1, 2), ContactMode::open);  // 1e-12 N is below 1e-9 of 20 N
  EXPECT_EQ(fields.bump_sleeve.normal_force(1, 2), 0.0);
}

TEST(Fields, FrictionlessContactsSlipTheWayTheyMove) {
  Example example;
  for (ContactSite& site : example.foils.problem.sites) site.friction_coefficient = 0.0;
  example.state.contacts.mode[7] = ContactMode::stick;  // as solvers set frictionless contacts
  EXPECT_EQ(example.recorded().top_bump.mode(1, 2), ContactMode::slip_forward);
  example.state.slip_origin = example.state.contacts.x;
  EXPECT_EQ(example.recorded().top_bump.mode(1, 2), ContactMode::stick);
}

TEST(Fields, KeepTheFirstIncrementsAlone) {
  FoilFields fields = Example().recorded();
  fields.truncate(1);
  EXPECT_EQ(fields.increments(), 1);
  for (const FieldMatrix* field : {&fields.top_displacement, &fields.foot_v, &fields.bump_sleeve.gap,
                                   &fields.journal_top.normal_force, &fields.stress.top_crest}) {
    EXPECT_EQ(field->rows(), 1);
    EXPECT_EQ(field->cols(), 26);
  }
  EXPECT_EQ(fields.top_bump.mode.rows(), 1);
}

TEST(InterfaceLoads, AreThoseThatARecordShows) {
  const Example example;
  const FoilFields fields = example.recorded();
  const auto loads = [&](Interface interface) {
    return interface_loads(example.foils, example.state.contacts, interface);
  };
  EXPECT_EQ(loads(Interface::journal_top), Vector(fields.journal_top.normal_force.row(1)));
  EXPECT_EQ(loads(Interface::top_bump), Vector(fields.top_bump.normal_force.row(1)));
  EXPECT_EQ(loads(Interface::bump_sleeve), Vector(fields.bump_sleeve.normal_force.row(1)));
}

/// The foils of a running bearing are in balance under the loads of its film.
TEST(FieldsUnderAFilm, AreThoseOfFoilsUnderTheirLoads) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
    input.bump_foil.model = model;
    const BearingModel bearing = make_film_bearing(input);
    FilmStepper stepper(bearing);
    BearingState state;
    ASSERT_EQ(start_from_ambient(stepper, {0.7 * bearing.clearance, 0.0}, speed_of_rpm(45000.0), state).status,
              Status::converged);
    FoilFields fields = make_fields(bearing, 1);
    record(bearing, state, 0, fields);
    EXPECT_EQ((fields.top_bump.normal_force.array() > 0.0).count(), film_bearing_outcome(bearing, state).loaded_bumps);
    for (Eigen::Index b = 0; b < bearing.bumps(); ++b) {
      const int crest = bearing.film->pads.front().foil.supports[static_cast<std::size_t>(b)];
      EXPECT_NEAR(fields.top_displacement(0, b), state.film.deflection(crest) * bearing.film->scales.thickness, 1e-15);
      // The moment over a crest, from the film and from the stress.
      const double moment = bearing.film->pads.front().foil.stiffness * bearing.film->pads.front().foil.pitch *
                            bearing.film->scales.thickness * std::abs(state.film.moment(crest));
      EXPECT_NEAR(fields.stress.top_crest(0, b), moment / bearing.stress.front().top_section_modulus,
                  1e-9 * fields.stress.top_crest.maxCoeff());
    }
    // The bumps transmit their normal loads to the sleeve, except for the part carried by friction.
    EXPECT_NEAR(fields.bump_sleeve.normal_force.sum() / fields.top_bump.normal_force.sum(), 1.0, 0.2);
  }
}

/// Each foil of several pads behaves as it does alone.
TEST(FieldsUnderAFilm, HaveTheBumpsOfAllPadsInARow) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3}, 0.1);
    input.bump_foil.model = model;
    input.bump_foil.bumps = 8;
    input.pads.assign(3, {.lobe = 8e-6});
    const double speed = speed_of_rpm(45000.0);
    const auto fields_of = [speed](const Case& one) {
      const BearingModel bearing = make_film_bearing(one);
      BearingState state;
      FilmStepper stepper(bearing);
      EXPECT_EQ(start_from_ambient(stepper, {12e-6, -4e-6}, speed, state).status, Status::converged);
      FoilFields fields = make_fields(bearing, 1);
      record(bearing, state, 0, fields);
      return fields;
    };
    const FoilFields all = fields_of(input);
    for (std::size_t k = 0; k < 3; ++k) {
      const FoilFields one = fields_of(pad_alone(input, k));
      const auto first = static_cast<Eigen::Index>(8 * k);
      const Eigen::Index feet = one.foot_v.cols();
      // Newton's last step is below 1e-9 of c in both.
      const double length = 1e-12;
      EXPECT_LT((all.crest_v.middleCols(first, 8) - one.crest_v).cwiseAbs().maxCoeff(), length);
      EXPECT_LT((all.top_displacement.middleCols(first, 8) - one.top_displacement).cwiseAbs().maxCoeff(), length);
      EXPECT_LT((all.foot_v.middleCols(static_cast<Eigen::Index>(k) * feet, feet) - one.foot_v).cwiseAbs().maxCoeff(),
                length);
      EXPECT_LT((all.top_bump.normal_force.middleCols(first, 8) - one.top_bump.normal_force).cwiseAbs().maxCoeff(),
                1e-5);
    }
  }
}

}  // namespace
}  // namespace bumpfoil
