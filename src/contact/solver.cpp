#include "bumpfoil/contact/solver.hpp"

#include <utility>

namespace bumpfoil {

SolveReport& SolveReport::operator+=(const SolveReport& other) {
  converged = other.converged;
  iterations += other.iterations;
  factorisations += other.factorisations;
  outer_iterations += other.outer_iterations;
  return *this;
}

IncrementReport advance(ContactSolver& solver, const ContactLoading& from, const ContactLoading& to,
                        ContactState& state, int max_halvings) {
  IncrementReport report;
  ContactState next;
  report.solve = solver.solve(to, state, next);
  if (report.solve.converged) {
    std::swap(state, next);
    return report;
  }
  if (max_halvings == 0) return report;
  const ContactLoading middle{.initial_gap = 0.5 * (from.initial_gap + to.initial_gap),
                              .load = 0.5 * (from.load + to.load)};
  for (const auto& [begin, end] : {std::pair(&from, &middle), std::pair(&middle, &to)}) {
    const IncrementReport half = advance(solver, *begin, *end, state, max_halvings - 1);
    report.solve += half.solve;
    report.substeps += 1 + half.substeps;
    if (!half.solve.converged) break;
  }
  return report;
}

}  // namespace bumpfoil
