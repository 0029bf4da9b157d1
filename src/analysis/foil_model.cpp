#include "bumpfoil/analysis/foil_model.hpp"

#include <memory>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/structure/single_bump.hpp"

namespace bumpfoil {
namespace {

/// @param input  its gaps and friction, of the bumps of `foils`
FoilModel make_foil_model(const Case& input, const FoilDesign& foils) {
  FoilModel model;
  model.structure = make_foil_structure(foils);
  model.stress = make_stress_model(foils);

  const BumpDofs& dofs = model.structure.dofs;
  model.problem.K = model.structure.K;
  model.problem.law = elastic_law(model.structure);
  model.problem.force_scale = bump_force_scale(foils);
  if (foils.top_foil) model.problem.pairs.push_back({.plus = dofs.top_u});
  model.problem.pairs.push_back({.plus = dofs.crest_v,
                                 .minus = dofs.top_u,
                                 .tangential = dofs.crest_u,
                                 .friction_coefficient = input.friction.top_bump});
  for (std::size_t foot = 0; foot < dofs.foot_u.size(); ++foot) {
    model.problem.pairs.push_back({.minus = dofs.foot_v[foot],
                                   .tangential = dofs.foot_u[foot],
                                   .friction_coefficient = input.friction.bump_sleeve});
  }

  // All gaps of a block before bump 1 stay zero: its foot rests on the base, and the rest of it stays in place.
  model.assembled_gap.setZero(model.problem.contacts());
  const Eigen::Index stride = model.contacts_per_block();
  for (Eigen::Index bump = 0; bump < model.bumps(); ++bump) {
    const Eigen::Index first = (model.structure.first_bump + bump) * stride;
    const auto i = static_cast<std::size_t>(bump);
    if (!input.bump_foil.height_errors.empty()) {
      model.assembled_gap[first + model.top_bump()] = -input.bump_foil.height_errors[i];
    }
    if (!input.bump_foil.sleeve_gaps.empty()) {
      model.assembled_gap.segment(first + model.first_foot(), dofs.feet()).setConstant(input.bump_foil.sleeve_gaps[i]);
    }
  }
  return model;
}

}  // namespace

std::optional<ElasticLaw> elastic_law(const FoilStructure& structure) {
  if (!structure.large_displacements) return std::nullopt;
  const auto shared = std::make_shared<const FoilStructure>(structure);
  return ElasticLaw{.forces = [shared](const Vector& x) { return internal_forces(*shared, x); },
                    .tangent = [shared](const Vector& x) { return tangent_stiffness(*shared, x); },
                    .stable_tangent = [shared](const Vector& x) { return stable_tangent_stiffness(*shared, x); }};
}

FoilModel make_bearing_model(const Case& input) {
  require_valid(input);
  FoilModel model = make_foil_model(input, make_bearing_foils(input));
  model.clearance = input.bearing.radial_clearance;
  model.normals = outward_normals(polar_angles(input.bearing, crest_angles(input)));
  return model;
}

FoilModel make_strip_model(const Case& input) {
  require_valid(input);
  if (!input.strip) throw Error(ErrorKind::input, {{"", 0, "strip", "", "this table is missing", "add [strip]"}});
  FoilModel model = make_foil_model(cut_to_strip(input), make_strip_foils(input));
  model.normals = outward_normals(Vector::Zero(model.bumps()));
  return model;
}

ContactLoading loading_at(const FoilModel& model, const Eigen::Vector2d& position) {
  ContactLoading loading{.initial_gap = model.assembled_gap, .load = Vector::Zero(model.problem.K.rows())};
  loading.initial_gap(model.pressed()) += journal_gaps(model.clearance, model.normals, position);
  return loading;
}

ContactLoading loading_rate(const FoilModel& model, const Eigen::Vector2d& direction) {
  const ContactLoading moved = loading_at(model, direction);
  const ContactLoading centred = loading_at(model, Eigen::Vector2d::Zero());
  return {.initial_gap = moved.initial_gap - centred.initial_gap, .load = moved.load - centred.load};
}

Vector pressing_loads(const FoilModel& model, const Vector& normal_force) {
  return normal_force(model.pressed());
}

Eigen::Vector2d holding_force(const FoilModel& model, const Vector& normal_force) {
  return journal_force(model.normals, pressing_loads(model, normal_force));
}

}  // namespace bumpfoil
