#include "bumpfoil/analysis/path_solver.hpp"

#include <utility>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/uzawa.hpp"

namespace bumpfoil {

PathSolver::PathSolver(const SolverSettings& settings, const ContactProblem& problem)
    : exact_(settings.name != SolverName::uzawa) {
  if (settings.name == SolverName::uzawa) {
    const UzawaParameters& given = settings.uzawa;
    increments_ = std::make_unique<UzawaSolver>(
        problem,
        UzawaOptions{.eps_alm = given.eps_alm, .eps_f = given.eps_f, .eps_r = given.eps_r, .tau_f = given.tau_f});
  } else {
    increments_ = std::make_unique<NewtonSolver>(problem);
  }
  if (settings.name == SolverName::events) events_ = std::make_unique<EventStepper>(problem);
}

SolveReport PathSolver::assemble(const ContactLoading& loading, const ContactState& unstressed, ContactState& state) {
  return increments_->solve(loading, unstressed, state);
}

void PathSolver::set_out(const ContactLoading& from, const ContactLoading& to, const ContactState& state) {
  if (events_) {
    events_->set_out(from, to, state);
    return;
  }
  from_ = from;
  to_ = to;
  reached_ = from;
}

IncrementReport PathSolver::advance_to(double fraction, ContactState& state, const PartVisitor& visit,
                                       std::vector<ContactEvent>& events) {
  if (events_) return events_->advance_to(fraction, state, visit, events);
  ContactLoading next = interpolate(from_, to_, fraction);
  const IncrementReport report = bumpfoil::advance(*increments_, reached_, next, state, visit);
  if (report.solve.converged) reached_ = std::move(next);
  return report;
}

}  // namespace bumpfoil
