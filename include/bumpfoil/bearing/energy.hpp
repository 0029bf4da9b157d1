#pragma once

#include <cstddef>
#include <vector>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// Work done on the foils between two states by the journal, which changes their initial gaps; trapezoidal rule, J:
///
///     W = -1/2 sum (p_begin + p_end) (g0_end - g0_begin)
///
/// which is 1/2 (F_begin + F_end).dx for a journal displaced by dx.
/// @param mean_force  1/2 (p_begin + p_end) of each contact, N
/// @param gap_change  g0_end - g0_begin of each, m
double gap_work(const Vector& mean_force, const Vector& gap_change);

/// Energy dissipated by friction between two states, -sum t du with the mean of the forces t at both, J.
double friction_work(const ContactProblem& problem, const ContactState& begin, const ContactState& end);

/// Energy dissipated by the friction of a problem, sum of f p |du|, J. Made once: ensembles ask for it about 400 times
/// a sample.
class FrictionDissipation {
 public:
  explicit FrictionDissipation(const ContactProblem& problem);

  /// @param normal_force  p of each contact, N
  /// @param begin_x       unknowns at the start of the slip
  /// @param end_x         and at its end
  [[nodiscard]] double of(const Vector& normal_force, const Vector& begin_x, const Vector& end_x) const;

 private:
  // Contacts with friction and their tangential unknowns, those of one coefficient together.
  std::vector<Eigen::Index> contacts_, unknowns_;
  std::vector<double> coefficients_;
  std::vector<std::size_t> ends_;  // of each coefficient among the contacts
};

}  // namespace bumpfoil
