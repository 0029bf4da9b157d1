#include "core/linear_algebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

namespace bumpfoil {

Eigen::MatrixXd product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A * B;
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.transpose() * B;
}

Eigen::MatrixXd congruent(const Eigen::MatrixXd& A, const Eigen::MatrixXd& T) {
  return product(transposed_product(T, A), T);
}

Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.partialPivLu().solve(B);
}

Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.partialPivLu().solve(b);
}

Eigen::VectorXcd solve(const Eigen::MatrixXcd& A, const Eigen::VectorXcd& b) {
  return A.partialPivLu().solve(b);
}

Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.ldlt().solve(B);
}

Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  return A.llt().solve(B);
}

std::optional<Eigen::MatrixXd> definite_inverse(const Eigen::MatrixXd& A, double least) {
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(A);
  if (!(ldlt.vectorD().minCoeff() > least)) return std::nullopt;
  return ldlt.solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
}

Eigen::MatrixXd null_space(const Eigen::MatrixXd& A) {
  // The last columns of Q in A^T = Q R. Eigen's QR without pivoting would take 5 s to compile.
  const Eigen::Index n = A.cols();
  const Eigen::Index rank = A.rows();
  Eigen::MatrixXd R = A.transpose();
  Eigen::VectorXd tau(rank);
  Eigen::VectorXd work(n);
  for (Eigen::Index k = 0; k < rank; ++k) {
    R.col(k).tail(n - k).makeHouseholderInPlace(tau[k], R(k, k));
    R.bottomRightCorner(n - k, rank - k - 1).applyHouseholderOnTheLeft(R.col(k).tail(n - k - 1), tau[k], work.data());
  }
  Eigen::MatrixXd null = Eigen::MatrixXd::Zero(n, n - rank);
  null.bottomRows(n - rank).setIdentity();
  for (Eigen::Index k = rank; k-- > 0;) {
    null.bottomRows(n - k).applyHouseholderOnTheLeft(R.col(k).tail(n - k - 1), tau[k], work.data());
  }
  return null;
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, std::optional<double> threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  if (threshold) decomposition.setThreshold(*threshold);
  decomposition.compute(A);
  return decomposition.solve(B);
}

SingularVectors singular_vectors(const Eigen::MatrixXd& A) {
  // By Jacobi rotations of the triangle that elimination leaves: A P = Q R.
  const Eigen::Index n = A.cols();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  const Eigen::Index rows = std::min(A.rows(), n);
  Eigen::MatrixXd R = Eigen::MatrixXd::Zero(n, n);
  R.topRows(rows) = qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(R, Eigen::ComputeFullV);
  return {.values = svd.singularValues(), .right = qr.colsPermutation() * svd.matrixV()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

SymmetricModes symmetric_modes(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, B);
  return {.squares = solver.eigenvalues(), .shapes = solver.eigenvectors()};
}

std::optional<Eigen::VectorXcd> eigenvalues(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A, false);
  if (solver.info() != Eigen::Success) return std::nullopt;
  return solver.eigenvalues();
}

std::optional<Eigenpairs> eigenpairs(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
  if (solver.info() != Eigen::Success) return std::nullopt;
  return Eigenpairs{.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

}  // namespace bumpfoil
