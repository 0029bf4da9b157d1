#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// A real square matrix U T U^T with U orthogonal and T zero below its diagonal but for the first place below it of
/// each pair of rows that has a pair of eigenvalues [Saad2011].
struct SchurForm {
  Matrix T, U;
};

/// @return nothing if the iteration does not converge
std::optional<SchurForm> schur_form(const Eigen::Ref<const Matrix>& matrix);

/// The solution w of (1 - e T) w = right, in m^2 / 2 real operations for each real column.
Eigen::MatrixXcd solve_shifted(const Eigen::Ref<const Matrix>& T, std::complex<double> e,
                               const Eigen::Ref<const Eigen::MatrixXcd>& right);

/// Eigenvalues of T, and where each stands: the row of the block that has it.
struct SchurEigenvalue {
  std::complex<double> value;
  Eigen::Index row{};
  Eigen::Index size{};  ///< of the block, 1 or 2
};
std::vector<SchurEigenvalue> schur_eigenvalues(const Matrix& T);

/// The eigenvector of T that belongs to an eigenvalue other than zero, of unit length.
Eigen::VectorXcd eigenvector_of(const Matrix& T, const SchurEigenvalue& eigenvalue);

}  // namespace bumpfoil
