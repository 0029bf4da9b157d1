#include "bumpfoil/analysis/increment.hpp"

#include <algorithm>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// A contact is reported open where its load is below this part of the largest, or below that part of the scale of
/// forces: where nothing is loaded, the largest is a rounding itself.
constexpr double open_load = 1e-9;
constexpr double rounded_load = 1e-12;

/// Copies the entries of one unknown of every bump.
Vector pick(const FoilStructure& structure, const Vector& x, int unknown) {
  const Eigen::Index size = structure.dofs.size;
  return x(Eigen::seqN(structure.first_bump * size + unknown, Eigen::Index{structure.bumps()}, size));
}

/// Copies the entries of the unknowns of the feet, foot by foot.
Vector pick_feet(const Vector& x, int block_size, const std::vector<int>& unknowns) {
  const auto feet = static_cast<Eigen::Index>(unknowns.size());
  Vector out(x.size() / block_size * feet);
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out[i] = x[i / feet * block_size + unknowns[static_cast<std::size_t>(i % feet)]];
  }
  return out;
}

/// Modes as they are reported: contacts without load are open, frictionless ones slip where they move.
std::vector<ContactMode> reported_modes(const ContactProblem& problem, const ContactState& state,
                                        const Vector& previous_x) {
  std::vector<ContactMode> mode = state.mode;
  const double threshold = std::max(open_load * state.normal_force.maxCoeff(), rounded_load * problem.force_scale);
  for_each_contact(problem, [&](const CoulombContact& contact) {
    ContactMode& m = mode[static_cast<std::size_t>(contact.index)];
    if (state.normal_force[contact.index] <= threshold) {
      m = ContactMode::open;
    } else if (contact.pair.tangential >= 0 && contact.f == 0.0) {
      const double slip = contact.tangential(state.x) - contact.tangential(previous_x);
      m = slip > displacement_resolution    ? ContactMode::slip_forward
          : slip < -displacement_resolution ? ContactMode::slip_backward
                                            : ContactMode::stick;
    }
  });
  return mode;
}

/// Contacts `first` .. `first + count - 1` of every block from `first_block` on.
InterfaceFields interface_fields(const ContactProblem& problem, const ContactState& state,
                                 const std::vector<ContactMode>& mode, int first_block, int first, int count) {
  const auto pairs = static_cast<int>(problem.pairs.size());
  const Eigen::Index size = Eigen::Index{problem.K.blocks() - first_block} * count;
  InterfaceFields fields{.gap = Vector(size), .normal_force = Vector(size), .friction_force = Vector(size), .mode = {}};
  fields.mode.reserve(static_cast<std::size_t>(size));
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index contact = (first_block + i / count) * pairs + first + i % count;
    const ContactMode m = mode[static_cast<std::size_t>(contact)];
    const bool open = m == ContactMode::open;
    fields.gap[i] = open ? std::max(0.0, state.gap[contact]) : 0.0;
    fields.normal_force[i] = open ? 0.0 : state.normal_force[contact];
    fields.friction_force[i] = open ? 0.0 : state.friction_force[contact];
    fields.mode.push_back(m);
  }
  return fields;
}

}  // namespace

Increment record_increment(const FoilModel& model, const Eigen::Vector2d& position, const Eigen::Vector2d& direction,
                           const ContactLoading& loading, const Vector& previous_x, const ContactState& state) {
  Increment next;
  next.x = position.x();
  next.y = position.y();
  const Eigen::Vector2d force = holding_force(model, state.normal_force);
  next.force_x = force.x();
  next.force_y = force.y();
  next.force_direct = force.dot(direction);
  next.force_cross = force.dot(Eigen::Vector2d(-direction.y(), direction.x()));

  const ElasticResponse elastic = elastic_response(model.structure, state.x);
  next.elastic_energy = elastic.energy;
  next.residuals = contact_residuals(model.problem, elastic.forces, loading, previous_x, state);

  const int block = model.problem.K.block_size();
  const BumpDofs& dofs = model.structure.dofs;
  if (model.has_top_foil()) next.top_displacement = pick(model.structure, state.x, dofs.top_u);
  next.crest_u = pick(model.structure, state.x, dofs.crest_u);
  next.crest_v = pick(model.structure, state.x, dofs.crest_v);
  next.foot_u = pick_feet(state.x, block, dofs.foot_u);
  next.foot_v = pick_feet(state.x, block, dofs.foot_v);

  const std::vector<ContactMode> mode = reported_modes(model.problem, state, previous_x);
  const auto fields = [&](int first_block, int first, int count) {
    return interface_fields(model.problem, state, mode, first_block, first, count);
  };
  const int first_bump = model.structure.first_bump;
  if (model.has_top_foil()) next.journal_top = fields(first_bump, 0, 1);
  next.top_bump = fields(first_bump, model.top_bump(), 1);
  next.bump_sleeve = fields(0, model.first_foot(), dofs.feet());
  next.stress = foil_stress(model.stress, state.x);
  return next;
}

}  // namespace bumpfoil
