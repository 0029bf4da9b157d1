#pragma once

#include <Eigen/LU>
#include <string>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// Solvers of Siconos for plane friction contact: all combinations of modes, Lemke's pivots on the equivalent linear
/// complementarity problem, projected Gauss-Seidel, projected conjugate gradients.
enum class SiconosMethod { enumeration, lemke, gauss_seidel, conjugate_gradients };

std::string name_of(SiconosMethod method);

/// Bounds of the iterative methods.
struct SiconosOptions {
  double tolerance{1e-10};  ///< of Siconos' own error measure
  int max_iterations{100000};
};

/// A contact problem handed to Siconos, reduced to its contacts: gaps and slips u, compressions and friction r,
///
///     u = W r + q,   W = B K^-1 B',   0 <= u_n _|_ r_n >= 0,   r_t = -f r_n sign(u_t) where u_t != 0
///
/// Needs the library siconos_numerics, which nothing else in Bumpfoil does.
class SiconosContacts {
 public:
  explicit SiconosContacts(const ContactProblem& problem);

  /// Solves one increment.
  /// @param previous_x  unknowns from which slip is measured
  /// @param state       receives x, gap and forces; modes are unchanged
  /// @return whether Siconos reports success
  [[nodiscard]] bool solve(SiconosMethod method, const ContactLoading& loading, const Vector& previous_x,
                           ContactState& state, const SiconosOptions& options = SiconosOptions());

  /// W; rows 2 c and 2 c + 1 are gap and slip of contact c.
  [[nodiscard]] const Matrix& compliance() const { return W_; }

 private:
  Matrix B_;       ///< 2 contacts x unknowns
  Matrix motion_;  ///< K^-1 B'
  Matrix W_;
  Vector friction_;
  Eigen::PartialPivLU<Matrix> K_;
};

}  // namespace bumpfoil
