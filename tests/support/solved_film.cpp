#include "support/solved_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/residual.hpp"

namespace bumpfoil {
namespace {

/// Checks film and top foil of a pad; their residual over the crests goes to the elastic forces, N.
std::string wrong_pad(const BearingModel& bearing, const FilmPad& pad, const BearingState& state, Vector& elastic) {
  const FoilFilm& foil = pad.foil;
  FoilFilmState part;
  read_part(pad, state.film, part);
  FoilFilmResidual residual;
  const ReynoldsEquation equation = film_equation(*bearing.film, pad, state.speed);
  foil_film_residual(foil, equation, part, residual);
  const double area = foil.mesh.dtheta * foil.mesh.dzeta;
  // Errors are relative to the flows that balance.
  const double flow = std::max(1.0, part.pressure.cwiseProduct(part.thickness).maxCoeff());
  const double film = foil.mesh.unknown(residual.film).cwiseAbs().maxCoeff() / (area * flow);
  if (!(film <= 1e-8 * std::max(1.0, std::abs(equation.bearing_number)))) return fmt::format("film by {:.2g}", film);
  const double lift = std::max(1.0, part.deflection.cwiseAbs().maxCoeff());
  const double compatibility = residual.compatibility.cwiseAbs().maxCoeff();
  if (!(compatibility <= 1e-9 * lift)) return fmt::format("bending of the top foil by {:.2g}", compatibility);
  if (!(residual.membrane.norm() <= 1e-9 * lift)) return fmt::format("membrane by {:.2g}", residual.membrane.norm());
  const double unit = foil.stiffness * bearing.film->scales.thickness;
  const int size = bearing.problem.K.block_size();
  elastic.segment(Eigen::Index{pad.first_block + pad.bumps()} * size, size).setZero();
  for (std::size_t i = 0; i < foil.supports.size(); ++i) {
    const int crest = foil.supports[i];
    for (int s = 0; s < bearing.crest_contacts(); ++s) {
      const Eigen::Index place =
          (pad.first_block + static_cast<Eigen::Index>(i)) * size + bearing.place(s, bearing.structure.dofs.top_u);
      double& balance = residual.balance(s, crest);
      elastic[place] = balance * unit;
      balance = 0.0;
    }
  }
  const double pressing = std::max({1.0, unit * part.moment.cwiseAbs().maxCoeff(), elastic.cwiseAbs().maxCoeff()});
  const double balance = residual.balance.cwiseAbs().maxCoeff() * unit;
  if (!(balance <= 1e-8 * pressing)) return fmt::format("balance of the top foil by {:.2g} N", balance);
  return {};
}

}  // namespace

std::string wrong_film(const BearingModel& bearing, const BearingState& state) {
  // Negated so that NaN fails.
  if (!(state.film.pressure.minCoeff() > 0.0)) return "a pressure below 0";
  if (!(state.film.thickness.minCoeff() > 0.0)) return "a thickness below 0";
  Matrix H = undeformed_thickness(bearing, bearing.film->journal_of(state), state.clearance_offset);
  H += bearing.film->over_the_width(state.film.deflection);
  const double apart = (H - state.film.thickness).cwiseAbs().maxCoeff();
  if (!(apart <= 1e-11 * std::max(1.0, H.maxCoeff()))) return fmt::format("thickness by {:.2g}", apart);
  Vector elastic = bearing.problem.K.multiply(state.contacts.x);
  for (const FilmPad& pad : bearing.film->pads) {
    if (std::string wrong = wrong_pad(bearing, pad, state, elastic); !wrong.empty()) return wrong;
  }
  const ContactLoading loading{.initial_gap = bearing.assembled_gap, .load = Vector::Zero(elastic.size())};
  const ContactResiduals r = contact_residuals(bearing.problem, elastic, loading, state.slip_origin, state.contacts);
  if (r.within(1e-7, 1e-11)) return {};
  return fmt::format(
      "equilibrium {:.2g}, penetration {:.2g} m, slip in stick {:.2g} m, complementarity {:.2g}, cone {:.2g}",
      r.equilibrium, r.penetration, r.slip_in_stick, r.complementarity, r.cone);
}

}  // namespace bumpfoil
