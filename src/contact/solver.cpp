#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

SolveCost& SolveCost::operator+=(const SolveCost& other) {
  iterations += other.iterations;
  factorisations += other.factorisations;
  outer_iterations += other.outer_iterations;
  return *this;
}

}  // namespace bumpfoil
