#pragma once

#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// One interface at one increment.
struct InterfaceRow {
  Vector gap, normal_force, friction_force;
  std::vector<ContactMode> mode;
};

/// An increment of a cycle together with its row of every field.
struct FullIncrement : Increment {
  Vector top_displacement, crest_u, crest_v, foot_u, foot_v;
  InterfaceRow journal_top, top_bump, bump_sleeve;
};

/// Row `increment` of the fields, with `scalars` as they are.
FullIncrement with_fields(const Increment& scalars, const FoilFields& fields, Eigen::Index increment);

/// @param increment  one that has fields
FullIncrement increment_at(const Cycle& cycle, int increment);

/// All increments with fields.
std::vector<FullIncrement> full_increments(const Cycle& cycle);

/// The increment at full displacement.
FullIncrement turning_increment(const Cycle& cycle);

}  // namespace bumpfoil
