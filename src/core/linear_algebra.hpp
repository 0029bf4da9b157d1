#pragma once

#include <Eigen/Core>
#include <optional>

/// Products and decompositions of dense matrices by Eigen, compiled here once: a decomposition takes seconds to
/// compile, a new kind of product up to one. For what runs seldom; inner loops call Eigen themselves.
namespace bumpfoil {

Eigen::MatrixXd product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// A^T B
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
/// T^T A T: the matrix of a quadratic form in y where x = T y.
Eigen::MatrixXd congruent(const Eigen::MatrixXd& A, const Eigen::MatrixXd& T);

/// X with A X = B, by elimination with row pivoting. @param A  square and regular
Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
Eigen::VectorXcd solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b);

/// X with A X = B for a symmetric semidefinite A, of which the lower triangle is read, by A = L D L^T.
Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// X with A X = B for a symmetric positive definite A, of which the lower triangle is read, by A = L L^T.
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// The inverse of a symmetric matrix, of which the lower triangle is read, by A = L D L^T; nothing if an entry of D is
/// not above `least`.
std::optional<Eigen::MatrixXd> definite_inverse(const Eigen::MatrixXd& A, double least);

/// Orthonormal columns that span all x with A x = 0. @param A  rows are independent, and fewer than columns
Eigen::MatrixXd null_space(const Eigen::MatrixXd& A);

/// The X that minimises |A X - B|, column by column; of several, the shortest.
/// @param A          any shape and rank
/// @param B          as many rows as A
/// @param threshold  pivots below this fraction of the largest count as zero; by default round-off
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, std::optional<double> threshold = {});

/// Of A = U S V^T, as many as A has columns: any that A lacks rows for are zero.
struct SingularVectors {
  Eigen::VectorXd values;  ///< S, descending
  Eigen::MatrixXd right;   ///< V
};
SingularVectors singular_vectors(const Eigen::MatrixXd& A);

/// Those of a symmetric matrix, of which the lower triangle is read, ascending.
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

/// A phi = square B phi
struct SymmetricModes {
  Eigen::VectorXd squares;  ///< ascending
  Eigen::MatrixXd shapes;   ///< columns phi, phi^T B phi = 1
};
/// @param A  symmetric
/// @param B  symmetric and positive definite
SymmetricModes symmetric_modes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// Those of any square matrix; nothing if the QR algorithm does not converge.
std::optional<Eigen::VectorXcd> eigenvalues(const Eigen::MatrixXd& A);

struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;  ///< columns of unit length
};
std::optional<Eigenpairs> eigenpairs(const Eigen::MatrixXd& A);

}  // namespace bumpfoil
