#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// Nodes of the film of a bearing: columns k along theta, rows j across, from the plane of symmetry (j = 0) to the side
/// (j = rows), or from one side (j = 0) to the other. A node carries the volume around it: half of every interval next
/// to it.
///
/// A field over the nodes is a Matrix with a row for each j and a column for each k.
struct FilmMesh {
  int columns{};       ///< intervals along theta
  int rows{};          ///< intervals across
  double dtheta{};     ///< unit of the lengths along theta, rad
  double dzeta{};      ///< length of an interval across, in radii
  bool closed{};       ///< full circle: column 0 follows the last one; else columns 0 and `columns` are open edges
  WidthPart width{};   ///< that the rows cover
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
  /// Rows whose pressures are unknown: first_unknown_row() and unknown_rows() - 1 after it.
  [[nodiscard]] int first_unknown_row() const { return width == WidthPart::half ? 0 : 1; }
  [[nodiscard]] int unknown_rows() const { return rows - first_unknown_row(); }
  /// Whether a row lies at a side of the bearing.
  [[nodiscard]] bool is_side(int j) const { return j == rows || (width == WidthPart::whole && j == 0); }
  /// What integrals over the mesh count for the whole width.
  [[nodiscard]] double copies() const { return width == WidthPart::half ? 2.0 : 1.0; }
  /// Place of a row over the width: -1 and 1 at the sides, 0 in the mid-plane.
  [[nodiscard]] double zeta(int j) const {
    const double part = static_cast<double>(j) / rows;
    return width == WidthPart::half ? part : 2.0 * part - 1.0;
  }
  /// Half the axial length, in radii.
  [[nodiscard]] double half_width() const { return 0.5 * copies() * rows * dzeta; }

  /// What a field has at the nodes whose pressure is unknown. @param before  columns of the field before the mesh's own
  template <typename Field>
  [[nodiscard]] auto unknown(Field& field, int before = 0) const {
    return field.block(first_unknown_row(), before + first_unknown(), unknown_rows(), unknown_columns());
  }

  /// theta of all columns of nodes, rad.
  [[nodiscard]] Vector angles() const;
  /// A field that is `value` everywhere.
  [[nodiscard]] Matrix field(double value) const;
};

/// A film around the full circumference.
/// @param columns         three or more
/// @param half_width      half the axial length over the radius
FilmMesh make_closed_mesh(int columns, int rows, double half_width, WidthPart width = WidthPart::half);

/// A film from 0 to theta_end (rad), open at both ends.
FilmMesh make_slotted_mesh(int columns, int rows, double half_width, double theta_end,
                           WidthPart width = WidthPart::half);

/// The same with intervals of given lengths. @param intervals  in units of dtheta (rad), two or more
FilmMesh make_slotted_mesh(Vector intervals, double dtheta, int rows, double half_width,
                           WidthPart width = WidthPart::half);

}  // namespace bumpfoil
