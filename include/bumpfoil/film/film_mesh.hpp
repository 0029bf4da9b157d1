#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Nodes of the film on half the width of a bearing: columns k at theta_k = k dtheta, rows j at zeta_j = j dzeta from
/// the plane of symmetry (j = 0) to the side (j = rows). A node carries the volume around it: half a cell at ends.
///
/// A field over the nodes is a Matrix with a row for each j and a column for each k.
struct FilmMesh {
  int columns{};    ///< intervals along theta
  int rows{};       ///< intervals from the plane of symmetry to the side
  double dtheta{};  ///< rad
  double dzeta{};   ///< in radii
  bool closed{};    ///< full circle: column 0 follows the last one; else columns 0 and `columns` are open edges

  /// Columns of nodes.
  [[nodiscard]] int nodes() const { return closed ? columns : columns + 1; }
  /// The column after k.
  [[nodiscard]] int next(int k) const { return closed && k + 1 == columns ? 0 : k + 1; }
  /// Part of a cell, 1 or 1/2, that a column of nodes carries.
  [[nodiscard]] double column_weight(int k) const { return !closed && (k == 0 || k == columns) ? 0.5 : 1.0; }
  /// The same of a row.
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

}  // namespace bumpfoil
