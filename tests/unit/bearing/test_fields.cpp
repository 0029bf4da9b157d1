#include "bumpfoil/bearing/fields.hpp"

#include <gtest/gtest.h>

#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// A made-up state of the reference bearing: bump 3 pressed, everything else open. Recorded as increment 1 of 2.
struct Example {
  Foils foils = *make_bearing_foils(case_with_given_constants());
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
  EXPECT_EQ(fields.stress.bump_crest.cols(), 0);  // the truss knows none
}

TEST(Fields, ReportAContactWithoutLoadAsOpen) {
  const FoilFields fields = Example().recorded();
  EXPECT_EQ(fields.bump_sleeve.mode(1, 2), ContactMode::open);  // 1e-12 N is below 1e-9 of 20 N
  EXPECT_EQ(fields.bump_sleeve.normal_force(1, 2), 0.0);
}

TEST(Fields, FrictionlessContactsSlipTheWayTheyMove) {
  Example example;
  for (ContactPair& pair : example.foils.problem.pairs) pair.friction_coefficient = 0.0;
  example.state.contacts.mode[7] = ContactMode::stick;  // what a solver keeps for a frictionless contact
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

}  // namespace
}  // namespace bumpfoil
