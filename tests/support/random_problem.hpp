#pragma once

#include <cstdint>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// A small contact problem with foil-like contacts but arbitrary elastic couplings, and two loadings to pass through.
struct RandomProblem {
  ContactProblem problem;  ///< K symmetric positive definite, 1e5..1e7 N/m
  ContactLoading first, second;
};

/// Deterministic in its arguments. In every block unknown 4 faces a wall (contact 0), 1 rests on 4 and rubs along 0
/// (contact 1), 3 faces another wall and rubs along 2 (contact 2); other unknowns have no contact.
/// @param block_size  unknowns per block, at least 5
/// @param friction    coefficient of contacts 1 and 2
RandomProblem make_random_problem(std::uint64_t seed, int blocks, int block_size, double friction);

/// The same without some of its contacts, and with friction coefficients that differ from block to block.
RandomProblem make_irregular_problem(std::uint64_t seed, int blocks, int block_size, double friction);

/// Random modes for all contacts of a problem; frictionless contacts are open or stick.
std::vector<ContactMode> random_modes(std::uint64_t seed, const ContactProblem& problem);

}  // namespace bumpfoil
