#include "bumpfoil/contact/wedging.hpp"

#include <cmath>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "contact/eliminated_system.hpp"

namespace bumpfoil {

std::optional<Wedge> strongest_wedge(const ContactProblem& problem) {
  const std::vector<std::size_t> first = first_sites(problem);
  const std::vector<Elimination> order = elimination_order(problem);
  std::optional<Wedge> strongest;
  double most = 1.0;  // friction coefficient, in units of the onset of wedging
  for (std::size_t b = 0; b < problem.K.diagonal.size(); ++b) {
    Matrix rows = problem.K.diagonal[b];
    for (std::size_t i = first[b]; i < first[b + 1]; ++i) {
      const Elimination& e = order[i];
      // The balance of the owner yields the normal force, which is subtracted from that of the other unknown.
      if (e.other >= 0) rows.row(e.other) += rows.row(e.owner);
      const ContactSite& site = problem.sites[e.site];
      if (is_frictionless(site)) continue;
      const double resistance = problem.K.diagonal[b](site.tangential, site.tangential);
      const double change = std::abs(rows(e.owner, site.tangential));
      if (!(site.friction_coefficient * change >= most * resistance)) continue;
      most = site.friction_coefficient * change / resistance;
      strongest = {.contact = static_cast<int>(e.site), .friction = resistance / change};
    }
  }
  return strongest;
}

}  // namespace bumpfoil
