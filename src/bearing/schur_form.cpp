#include "bearing/schur_form.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Size of the block whose last row is the one before `end`.
Eigen::Index size_of_block(const Eigen::Ref<const Matrix>& T, Eigen::Index end) {
  return end > 1 && T(end - 1, end - 2) != 0.0 ? 2 : 1;
}

/// Solves (1 - e T) w = right for one block of T. @param right  receives w
void solve_block(const Eigen::Ref<const Matrix>& T, Complex e, Eigen::Index row, Eigen::Index size,
                 std::array<Complex, 2>& right) {
  const auto at = [&](Eigen::Index i, Eigen::Index j) { return (i == j ? 1.0 : 0.0) - e * T(row + i, row + j); };
  if (size == 1) {
    right[0] /= at(0, 0);
    return;
  }
  const Complex determinant = at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0);
  right = {(at(1, 1) * right[0] - at(0, 1) * right[1]) / determinant,
           (at(0, 0) * right[1] - at(1, 0) * right[0]) / determinant};
}

}  // namespace

std::optional<SchurForm> schur_form(const Eigen::Ref<const Matrix>& matrix) {
  const Eigen::RealSchur<Matrix> schur(matrix);
  if (schur.info() != Eigen::Success) return std::nullopt;
  return SchurForm{schur.matrixT(), schur.matrixU()};
}

Eigen::MatrixXcd solve_shifted(const Eigen::Ref<const Matrix>& T, Complex e,
                               const Eigen::Ref<const Eigen::MatrixXcd>& right) {
  Matrix real = right.real();
  Matrix imaginary = right.imag();
  for (Eigen::Index end = T.cols(); end > 0;) {
    const Eigen::Index size = size_of_block(T, end);
    const Eigen::Index k = end - size;
    for (Eigen::Index column = 0; column < right.cols(); ++column) {
      std::array<Complex, 2> w{};
      for (Eigen::Index j = 0; j < size; ++j) {
        w[static_cast<std::size_t>(j)] = {real(k + j, column), imaginary(k + j, column)};
      }
      solve_block(T, e, k, size, w);
      for (Eigen::Index j = 0; j < size; ++j) {
        const Complex found = w[static_cast<std::size_t>(j)];
        const Complex carried = e * found;
        real(k + j, column) = found.real();
        imaginary(k + j, column) = found.imag();
        real.col(column).head(k) += carried.real() * T.col(k + j).head(k);
        imaginary.col(column).head(k) += carried.imag() * T.col(k + j).head(k);
      }
    }
    end = k;
  }
  return real + Complex(0.0, 1.0) * imaginary;
}

std::vector<SchurEigenvalue> schur_eigenvalues(const Matrix& T) {
  std::vector<SchurEigenvalue> found;
  for (Eigen::Index end = T.cols(); end > 0;) {
    const Eigen::Index size = size_of_block(T, end);
    const Eigen::Index k = end - size;
    if (size == 1) {
      found.push_back({T(k, k), k, size});
    } else {
      const double mean = 0.5 * (T(k, k) + T(k + 1, k + 1));
      const double half = 0.5 * (T(k, k) - T(k + 1, k + 1));
      const Complex root = std::sqrt(Complex(half * half + T(k, k + 1) * T(k + 1, k)));
      found.push_back({mean + root, k, size});
      found.push_back({mean - root, k, size});
    }
    end = k;
  }
  return found;
}

Eigen::VectorXcd eigenvector_of(const Matrix& T, const SchurEigenvalue& eigenvalue) {
  const Eigen::Index k = eigenvalue.row;
  Eigen::VectorXcd vector = Eigen::VectorXcd::Zero(T.cols());
  vector[k] = 1.0;
  if (eigenvalue.size == 2) vector[k + 1] = (eigenvalue.value - T(k, k)) / T(k, k + 1);
  // What the block makes of the rows above it.
  const Eigen::VectorXcd right = (T.block(0, k, k, eigenvalue.size) * vector.segment(k, eigenvalue.size)).eval();
  vector.head(k) = solve_shifted(T.topLeftCorner(k, k), 1.0 / eigenvalue.value, right / eigenvalue.value);
  return vector.normalized();
}

}  // namespace bumpfoil
