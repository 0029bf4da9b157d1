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

ContactLoading interpolate(const ContactLoading& from, const ContactLoading& to, double fraction) {
  return {.initial_gap = from.initial_gap + fraction * (to.initial_gap - from.initial_gap),
          .load = from.load + fraction * (to.load - from.load)};
}

IncrementReport advance(ContactSolver& solver, const ContactLoading& from, const ContactLoading& to,
                        ContactState& state, const PartVisitor& visit, int max_halvings) {
  IncrementReport report;
  ContactState next;
  report.solve = solver.solve(to, state, next);
  if (report.solve.converged) {
    if (visit) visit(state, next);
    std::swap(state, next);
    return report;
  }
  if (max_halvings == 0) return report;
  const ContactLoading middle = interpolate(from, to, 0.5);
  for (const auto& [begin, end] : {std::pair(&from, &middle), std::pair(&middle, &to)}) {
    const IncrementReport half = advance(solver, *begin, *end, state, visit, max_halvings - 1);
    report.solve += half.solve;
    report.substeps += 1 + half.substeps;
    if (!half.solve.converged) break;
  }
  return report;
}

}  // namespace bumpfoil
