#include "bumpfoil/bearing/film_fields.hpp"

namespace bumpfoil {

BearingState foil_state(const FilmBearing& bearing, const BearingState& state) {
  const Foils& foils = *bearing.foils;
  BearingState dry = BearingState::unstressed(foils);
  ContactState& contacts = dry.contacts;
  const Eigen::Index size = foils.structure.dofs.size;
  const Eigen::Index film_size = bearing.problem.K.block_size();
  const Eigen::Index stride = foils.contacts_per_block();
  const Eigen::Index pairs = stride - foils.top_bump();
  Eigen::Index b = 0;  // through all pads
  for (const FilmPad& pad : bearing.pads) {
    Eigen::Index block = pad.first_block;
    for (const int crest : pad.foil.supports) {
      contacts.x.segment(b * size, size) = state.contacts.x.segment(block * film_size, size);
      contacts.gap[b * stride] = bearing.scales.thickness * state.film.thickness(0, pad.first_column + crest);
      contacts.mode[static_cast<std::size_t>(b * stride)] = ContactMode::open;
      for (Eigen::Index i = 0; i < pairs; ++i) {
        const Eigen::Index to = b * stride + foils.top_bump() + i;
        const Eigen::Index from = block * pairs + i;
        contacts.gap[to] = state.contacts.gap[from];
        contacts.normal_force[to] = state.contacts.normal_force[from];
        contacts.friction_force[to] = state.contacts.friction_force[from];
        contacts.mode[static_cast<std::size_t>(to)] = state.contacts.mode[static_cast<std::size_t>(from)];
      }
      ++b;
      ++block;
    }
  }
  dry.slip_origin = contacts.x;
  return dry;
}

}  // namespace bumpfoil
