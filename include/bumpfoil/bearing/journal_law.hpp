#pragma once

#include <Eigen/Core>

#include "bumpfoil/film/gas.hpp"

namespace bumpfoil {

/// How a journal is displaced, m: along X and Y in the mid-plane of the bearing and, where the film covers the whole
/// width, along X and Y at the side zeta = 1 in addition to that: the slope of its axis times half the width. Or what
/// does work on these: the force, and its moment about the mid-plane over half the width, N.
using JournalVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
/// Derivatives of the one by the other, two or four rows and columns.
using JournalMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

/// Conditions on the journal, as additional rows of the equations of film and foils:
///
///     A (q* - q) + B (F* - F) = 0
///
/// q place of the journal, m; F force on it that balances the film, N. A journal that is held has A = 1 and B = 0, one
/// that carries a load A = 0 and B = 1; a journal on a linear structure has the dynamic stiffness of the structure for
/// A.
struct JournalLaw {
  JournalMatrix by_position;  ///< A
  JournalMatrix by_force;     ///< B
  JournalVector position;     ///< q*, m
  JournalVector force;        ///< F*, N
  JournalVector units;        ///< of the rows: residuals count as multiples of them
  double round_off{};         ///< residuals up to this are none, in the unit of the rows
  double longest_step{};      ///< of the journal in one step of Newton's method, m

  /// Remaining distance, in the unit of the rows.
  [[nodiscard]] JournalVector residual(const JournalVector& q, const JournalVector& F) const;
  /// Matrix of the rows where the film answers with dF/dq = K.
  [[nodiscard]] JournalMatrix matrix(const JournalMatrix& K) const;
  /// Whether the law is a position alone.
  [[nodiscard]] bool holds_position() const { return by_force.isZero(0.0); }
};

/// The journal is held at a place, m.
JournalLaw held_journal(const JournalVector& position, const FilmScales& scales);

/// The journal carries a load, N, and moves to where the bearing balances it.
JournalLaw loaded_journal(const JournalVector& load, const FilmScales& scales);

/// Two laws one behind the other: of the place of the journal in the mid-plane, and of its tilt.
JournalLaw with_tilt(const JournalLaw& in_mid_plane, const JournalLaw& of_tilt);

}  // namespace bumpfoil
