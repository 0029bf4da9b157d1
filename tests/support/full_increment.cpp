#include "support/full_increment.hpp"

namespace bumpfoil {
namespace {

Vector row_of(const FieldMatrix& field, Eigen::Index row) {
  return field.cols() > 0 ? Vector(field.row(row).transpose()) : Vector();
}

InterfaceRow row_of(const InterfaceFields& fields, Eigen::Index row) {
  InterfaceRow out{.gap = row_of(fields.gap, row),
                   .normal_force = row_of(fields.normal_force, row),
                   .friction_force = row_of(fields.friction_force, row),
                   .mode = {}};
  for (Eigen::Index i = 0; i < fields.mode.cols(); ++i) out.mode.push_back(fields.mode(row, i));
  return out;
}

}  // namespace

FullIncrement with_fields(const Increment& scalars, const FoilFields& fields, Eigen::Index increment) {
  FullIncrement out;
  static_cast<Increment&>(out) = scalars;
  out.top_displacement = row_of(fields.top_displacement, increment);
  out.crest_u = row_of(fields.crest_u, increment);
  out.crest_v = row_of(fields.crest_v, increment);
  out.foot_u = row_of(fields.foot_u, increment);
  out.foot_v = row_of(fields.foot_v, increment);
  out.journal_top = row_of(fields.journal_top, increment);
  out.top_bump = row_of(fields.top_bump, increment);
  out.bump_sleeve = row_of(fields.bump_sleeve, increment);
  return out;
}

FullIncrement increment_at(const Cycle& cycle, int increment) {
  return with_fields(cycle.increments.at(static_cast<std::size_t>(increment)), cycle.fields, increment);
}

std::vector<FullIncrement> full_increments(const Cycle& cycle) {
  std::vector<FullIncrement> out;
  for (int k = 0; k < cycle.fields.increments(); ++k) out.push_back(increment_at(cycle, k));
  return out;
}

FullIncrement turning_increment(const Cycle& cycle) {
  return increment_at(cycle, cycle.steps);
}

}  // namespace bumpfoil
