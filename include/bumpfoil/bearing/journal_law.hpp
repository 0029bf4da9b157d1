#pragma once

#include <Eigen/Core>

#include "bumpfoil/film/gas.hpp"

namespace bumpfoil {

/// What holds the journal, as two more rows of the equations of film and foils:
///
///     A (q* - q) + B (F* - F) = 0
///
/// q position of the journal, m; F force on it that balances the film, N. A journal that is held has A = 1 and B = 0,
/// one that carries a load A = 0 and B = 1; what hangs on a linear structure has its dynamic stiffness for A.
struct JournalLaw {
  Eigen::Matrix2d by_position;  ///< A
  Eigen::Matrix2d by_force;     ///< B
  Eigen::Vector2d position;     ///< q*, m
  Eigen::Vector2d force;        ///< F*, N
  double unit{};                ///< of the rows: residuals count as multiples of it
  double round_off{};           ///< residuals up to this are none, in the unit of the rows
  double longest_step{};        ///< of the journal in one step of Newton's method, m

  /// What is left of the way, in the unit of the rows.
  [[nodiscard]] Eigen::Vector2d residual(const Eigen::Vector2d& q, const Eigen::Vector2d& F) const {
    return by_position * (position - q) + by_force * (force - F);
  }
  /// Matrix of the rows where the film answers with dF/dq = K.
  [[nodiscard]] Eigen::Matrix2d matrix(const Eigen::Matrix2d& K) const { return by_position + by_force * K; }
  /// Whether the law is a position alone.
  [[nodiscard]] bool holds_position() const { return by_force.isZero(0.0); }
};

/// The journal is held at a position, m.
JournalLaw held_journal(const Eigen::Vector2d& position, const FilmScales& scales);

/// The journal carries a load, N, and goes where the bearing balances it.
JournalLaw loaded_journal(const Eigen::Vector2d& load, const FilmScales& scales);

}  // namespace bumpfoil
