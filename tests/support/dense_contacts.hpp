#pragma once

#include <vector>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// A contact problem written out with dense matrices, free of blocks: g = g0 + normal x, slip = tangential (x - x0).
struct DenseContacts {
  Matrix K;           ///< n x n, N/m
  Matrix normal;      ///< contacts x n
  Matrix tangential;  ///< contacts x n; a zero row where frictionless
  Vector friction;    ///< coefficient of each contact
};

DenseContacts make_dense(const ContactProblem& problem);

/// Displacements and forces of a problem solved under given modes.
struct DenseState {
  Vector x, normal_force, friction_force;
};

/// Solves balance and closed gaps, with normal forces and stick forces as multipliers, by Gaussian elimination of the
/// whole system: the simple reference of the block form.
DenseState solve_dense(const DenseContacts& contacts, const ContactLoading& loading, const Vector& previous_x,
                       const std::vector<ContactMode>& mode);

/// All combinations of modes whose solution obeys every inequality: the solutions of the problem, found by
/// enumeration. For a few contacts: the number of combinations is 4^contacts (2^contacts without friction).
/// @param tolerance  inequalities may fail by this much, m and N alike
std::vector<DenseState> enumerate_solutions(const DenseContacts& contacts, const ContactLoading& loading,
                                            const Vector& previous_x, double tolerance);

}  // namespace bumpfoil
