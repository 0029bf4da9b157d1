#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/bearing/journal_law.hpp"

namespace bumpfoil {

/// Conditions on the journals of several bearings that one body connects, as rows in addition to the equations of their
/// films and foils:
///
///     A (y* - y) + sum B_i (F*_i - F_i) = 0,      q_i = N_i y + q_0i
///
/// y unknowns of the body, q_i place of journal i (m, JournalVector), F_i force on it that balances its film (N). A
/// rotor in a step of time has its dynamic stiffness for A and N_i^T for B_i. A plain value.
struct JointLaw {
  struct Journal {
    Eigen::MatrixXd motion;    ///< N
    Eigen::MatrixXd by_force;  ///< B
    JournalVector force;       ///< F*, N
    JournalVector origin{};    ///< q_0, m; empty: 0

    /// q
    [[nodiscard]] JournalVector place(const Eigen::VectorXd& y) const;
  };

  Eigen::MatrixXd by_place;         ///< A
  Eigen::VectorXd place{};          ///< y*
  std::vector<Journal> journals{};  ///< in the order of the bearings
  Eigen::VectorXd units{};          ///< of the rows: residuals count as multiples of them
  double round_off{};               ///< residuals up to this are none, in the unit of the rows
  double longest_step{};            ///< of any journal in one step of Newton's method, m

  /// Remaining distance, in the units of the rows. @param forces  F_i, N
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& y, const std::vector<JournalVector>& forces) const;
  /// Matrix of the rows where the films answer with dF_i/dq_i = K_i.
  [[nodiscard]] Eigen::MatrixXd matrix(const std::vector<JournalMatrix>& K) const;
  /// Whether the law is a place alone.
  [[nodiscard]] bool holds_place() const;
  /// The largest displacement of a journal, m.
  [[nodiscard]] double displacement(const Eigen::VectorXd& step) const;
};

/// That of one bearing: y is the place of its journal.
JointLaw law_of_one(const JournalLaw& law);

}  // namespace bumpfoil
