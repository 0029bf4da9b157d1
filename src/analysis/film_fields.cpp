#include "bumpfoil/analysis/film_fields.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

FoilState foil_state(const Foils& foils, const FilmBearing& bearing, const FilmBearingState& state) {
  BUMPFOIL_ASSERT(foils.has_top_foil() && foils.bumps() == std::ssize(bearing.foil.supports));
  FoilState dry = FoilState::unstressed(foils);
  ContactState& contacts = dry.contacts;
  const Eigen::Index size = foils.structure.dofs.size;
  const Eigen::Index film_size = bearing.problem.K.block_size();
  const Eigen::Index stride = foils.contacts_per_block();
  const Eigen::Index pairs = stride - foils.top_bump();
  for (Eigen::Index b = 0; b < foils.bumps(); ++b) {
    contacts.x.segment(b * size, size) = state.contact.x.segment(b * film_size, size);
    const int crest = bearing.foil.supports[static_cast<std::size_t>(b)];
    contacts.gap[b * stride] = bearing.scales.thickness * state.foil.film.thickness(0, crest);
    contacts.mode[static_cast<std::size_t>(b * stride)] = ContactMode::open;
    for (Eigen::Index i = 0; i < pairs; ++i) {
      const Eigen::Index to = b * stride + foils.top_bump() + i;
      const Eigen::Index from = b * pairs + i;
      contacts.gap[to] = state.contact.gap[from];
      contacts.normal_force[to] = state.contact.normal_force[from];
      contacts.friction_force[to] = state.contact.friction_force[from];
      contacts.mode[static_cast<std::size_t>(to)] = state.contact.mode[static_cast<std::size_t>(from)];
    }
  }
  dry.slip_origin = contacts.x;
  return dry;
}

}  // namespace bumpfoil
