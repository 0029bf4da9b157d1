#include "bumpfoil/analysis/bearing_model.hpp"

#include <memory>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {
namespace {

using Stride = Eigen::InnerStride<Eigen::Dynamic>;

}  // namespace

std::optional<ElasticLaw> elastic_law(const FoilStructure& structure) {
  if (!structure.large_displacements) return std::nullopt;
  const auto shared = std::make_shared<const FoilStructure>(structure);
  return ElasticLaw{.forces = [shared](const Vector& x) { return internal_forces(*shared, x); },
                    .tangent = [shared](const Vector& x) { return tangent_stiffness(*shared, x); },
                    .stable_tangent = [shared](const Vector& x) { return stable_tangent_stiffness(*shared, x); }};
}

BearingModel make_bearing_model(const Case& input) {
  require_valid(input);
  BearingModel model;
  model.bearing = input.bearing;
  model.structure = make_foil_structure(input);
  model.stress = make_stress_model(input);
  model.phi = polar_angles(input.bearing, crest_angles(input));

  const BumpDofs& dofs = model.structure.dofs;
  model.problem.K = model.structure.K;
  model.problem.law = elastic_law(model.structure);
  model.problem.pairs = {
      {.plus = dofs.top_u},
      {.plus = dofs.crest_v,
       .minus = dofs.top_u,
       .tangential = dofs.crest_u,
       .friction_coefficient = input.friction.top_bump},
  };
  for (std::size_t foot = 0; foot < dofs.foot_u.size(); ++foot) {
    model.problem.pairs.push_back({.minus = dofs.foot_v[foot],
                                   .tangential = dofs.foot_u[foot],
                                   .friction_coefficient = input.friction.bump_sleeve});
  }

  const Eigen::Index stride = static_cast<Eigen::Index>(model.problem.pairs.size());
  model.assembled_gap.setZero(model.problem.contacts());
  for (Eigen::Index bump = 0; bump < model.bumps(); ++bump) {
    const auto i = static_cast<std::size_t>(bump);
    if (!input.bump_foil.height_errors.empty()) {
      model.assembled_gap[bump * stride + BearingModel::top_bump] = -input.bump_foil.height_errors[i];
    }
    if (!input.bump_foil.sleeve_gaps.empty()) {
      model.assembled_gap.segment(bump * stride + BearingModel::first_foot, dofs.feet())
          .setConstant(input.bump_foil.sleeve_gaps[i]);
    }
  }
  return model;
}

ContactLoading loading_at(const BearingModel& model, const Eigen::Vector2d& position) {
  ContactLoading loading{.initial_gap = model.assembled_gap, .load = Vector::Zero(model.problem.K.rows())};
  const auto stride = static_cast<Eigen::Index>(model.problem.pairs.size());
  Eigen::Map<Vector, 0, Stride>(loading.initial_gap.data() + BearingModel::journal_top, model.bumps(), Stride(stride)) =
      journal_gaps(model.bearing, model.phi, position);
  return loading;
}

ContactLoading loading_rate(const BearingModel& model, const Eigen::Vector2d& direction) {
  const ContactLoading moved = loading_at(model, direction);
  const ContactLoading centred = loading_at(model, Eigen::Vector2d::Zero());
  return {.initial_gap = moved.initial_gap - centred.initial_gap, .load = moved.load - centred.load};
}

Vector journal_loads(const BearingModel& model, const Vector& normal_force) {
  const auto stride = static_cast<Eigen::Index>(model.problem.pairs.size());
  return Eigen::Map<const Vector, 0, Stride>(normal_force.data() + BearingModel::journal_top, model.bumps(),
                                             Stride(stride));
}

}  // namespace bumpfoil
