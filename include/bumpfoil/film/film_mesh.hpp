#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Nodes of the film on half the width of a bearing: columns k along theta, rows j at zeta_j = j dzeta from the plane
/// of symmetry (j = 0) to the side (j = rows). A node carries the volume around it: half of every interval next to it.
///
/// A field over the nodes is a Matrix with a row for each j and a column for each k.
struct FilmMesh {
  int columns{};       ///< intervals along theta
  int rows{};          ///< intervals from the plane of symmetry to the side
  double dtheta{};     ///< unit of their lengths, rad
  double dzeta{};      ///< in radii
  bool closed{};       ///< full circle: column 0 follows the last one; else columns 0 and `columns` are open edges
  Vector intervals{};  ///< length of each interval along theta, in units of dtheta: 1 where all are equal
  Vector weights{};    ///< of each column of nodes, see column_weight()

  /// Columns of nodes.
  [[nodiscard]] int nodes() const { return closed ? columns : columns + 1; }
  /// The column after k.
  [[nodiscard]] int next(int k) const { return closed && k + 1 == columns ? 0 : k + 1; }
  /// Length that a column of nodes carries, in units of dtheta: half of both intervals next to it.
  [[nodiscard]] double column_weight(int k) const { return weights[k]; }
  /// Length of the interval from column k to the next, rad.
  [[nodiscard]] double interval(int k) const { return dtheta * intervals[k]; }
  /// Part of a cell, 1 or 1/2, that a row carries.
  [[nodiscard]] double row_weight(int j) const { return j == 0 || j == rows ? 0.5 : 1.0; }
  /// Columns whose pressures are unknown: first_unknown() and unknown_columns() - 1 after it.
  [[nodiscard]] int first_unknown() const { return closed ? 0 : 1; }
  [[nodiscard]] int unknown_columns() const { return closed ? columns : columns - 1; }
  /// Rows whose pressures are unknown, from 0 on.
  [[nodiscard]] int unknown_rows() const { return rows; }

  /// theta of all columns of nodes, rad.
  [[nodiscard]] Vector angles() const;
  /// A field that is `value` everywhere.
  [[nodiscard]] Matrix field(double value) const;
};

/// A film around the full circumference.
/// @param columns         three or more
/// @param half_width      half the axial length over the radius
FilmMesh make_closed_mesh(int columns, int rows, double half_width);

/// A film from 0 to theta_end (rad), open at both ends.
FilmMesh make_slotted_mesh(int columns, int rows, double half_width, double theta_end);

/// The same with intervals of given lengths. @param intervals  in units of dtheta (rad), two or more
FilmMesh make_slotted_mesh(Vector intervals, double dtheta, int rows, double half_width);

}  // namespace bumpfoil
