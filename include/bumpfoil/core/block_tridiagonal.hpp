#pragma once

#include <Eigen/Core>
#include <vector>

namespace bumpfoil {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
/// Stored by rows: for many right-hand sides side by side.
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Block-tridiagonal matrix of `blocks()` square blocks of `block_size()` rows: a plain value. Foil structures are so
/// because bump i is coupled to bumps i-1 and i+1 only. They are symmetric; what a gas film adds to them is not.
///
/// Row `block * block_size() + k` of the whole matrix is row k of a block.
struct BlockTridiagonal {
  std::vector<Matrix> diagonal;  ///< blocks (i, i)
  std::vector<Matrix> upper;     ///< blocks (i, i+1), one fewer than the diagonal ones
  std::vector<Matrix> lower;     ///< blocks (i+1, i); none in a symmetric matrix: they are upper[i] transposed

  BlockTridiagonal() = default;
  /// All blocks zero.
  BlockTridiagonal(int blocks, int block_size);

  [[nodiscard]] int blocks() const { return static_cast<int>(diagonal.size()); }
  [[nodiscard]] int block_size() const { return diagonal.empty() ? 0 : static_cast<int>(diagonal.front().rows()); }
  [[nodiscard]] Eigen::Index rows() const { return Eigen::Index{blocks()} * block_size(); }

  [[nodiscard]] bool is_symmetric() const { return lower.empty(); }

  /// Adds `value` to a symmetric matrix at rows (block_i, i) and (block_j, j) and, off the diagonal, at the mirrored
  /// place. The blocks must be the same or neighbours.
  void add(int block_i, int i, int block_j, int j, double value);

  /// Puts the blocks of another symmetric matrix behind those of this one, coupled to nothing here.
  void append(const BlockTridiagonal& other);

  /// K x in O(blocks). `x` has rows() entries.
  [[nodiscard]] Vector multiply(const Vector& x) const;

  bool operator==(const BlockTridiagonal&) const = default;

  /// The whole matrix written out: for tests and small problems.
  [[nodiscard]] Matrix dense() const;
};

}  // namespace bumpfoil
