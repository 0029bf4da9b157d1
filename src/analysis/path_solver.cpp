#include "bumpfoil/analysis/path_solver.hpp"

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

IncrementReport PathSolver::advance(const ContactLoading& from, const ContactLoading& to, ContactState& state,
                                    const PartVisitor& visit, std::vector<ContactEvent>& events) {
  return events_ ? events_->advance(from, to, state, visit, events)
                 : bumpfoil::advance(*increments_, from, to, state, visit);
}

}  // namespace bumpfoil
