#include "bumpfoil/bearing/assembly.hpp"

#include <algorithm>

#include "bumpfoil/contact/newton.hpp"

namespace bumpfoil {
namespace {

PadAssembly assembly_of(const BearingModel& foils, std::size_t k, const Vector& loads, const Vector& deflection) {
  const auto [first, count] = foils.structure.blocks_of(static_cast<int>(k));
  const auto own = loads.segment(first, count);
  PadAssembly pad{.hold_down = own[count - 1], .lifted = 0, .load = own.sum(), .bulge = 0.0, .bulge_theta = 0.0};
  for (Eigen::Index bump = count - 1; bump-- > 0 && own[bump] <= 0.0;) ++pad.lifted;
  Eigen::Index crest = 0;
  pad.bulge = std::max(-deflection.segment(first, count).minCoeff(&crest), 0.0);
  pad.bulge_theta = foils.placed[k].crests[crest];
  return pad;
}

}  // namespace

std::vector<PadAssembly> assemble_without_journal(const BearingModel& foils) {
  ContactLoading loading = loading_under(foils, {});
  for (int line = 0; line < foils.journal_contacts(); ++line) {
    loading.initial_gap(foils.pressed(line)).array() += foils.placed.front().alone.bearing.radius;
  }
  NewtonSolver solver{SharedProblem(foils.problem)};
  ContactState state;
  if (!solver.solve(loading, ContactState::unstressed(foils.problem), state).converged()) return {};
  Vector loads = Vector::Zero(foils.bumps());
  for (Eigen::Index contact = 0; contact < foils.crest_contacts(); ++contact) {
    loads += state.normal_force(
        Eigen::seqN(foils.top_bump() + contact, Eigen::Index{foils.bumps()}, Eigen::Index{foils.contacts_per_block()}));
  }
  const Vector deflection = foils.foil_unknowns(state.x)(
      Eigen::seqN(Eigen::Index{foils.structure.first_bump} * foils.structure.dofs.size + foils.structure.dofs.top_u,
                  Eigen::Index{foils.bumps()}, Eigen::Index{foils.structure.dofs.size}));
  std::vector<PadAssembly> pads;
  pads.reserve(foils.placed.size());
  for (std::size_t k = 0; k < foils.placed.size(); ++k) pads.push_back(assembly_of(foils, k, loads, deflection));
  return pads;
}

}  // namespace bumpfoil
