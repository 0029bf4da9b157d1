#include "bumpfoil/core/dense_kernels.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdint>
#include <limits>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {
namespace {

/// Largest next to the diagonal: without row exchanges the pivots would be poor.
RowMajorMatrix example_matrix(int n, double seed) {
  RowMajorMatrix a(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) a(i, j) = std::sin(seed + 3 * i + 7 * i * j) + (j == (i + 1) % n ? 4.0 * n : 0.0);
  }
  return a;
}

/// A block in the storage of the kernels, with zeros after each row.
template <int B>
LineVector stored(const RowMajorMatrix& a) {
  const Eigen::Index stride = row_stride<B>(a.rows());
  LineVector numbers(static_cast<std::size_t>(a.rows() * stride), 0.0);
  for (Eigen::Index r = 0; r < a.rows(); ++r) {
    for (Eigen::Index c = 0; c < a.cols(); ++c) numbers[static_cast<std::size_t>(r * stride + c)] = a(r, c);
  }
  return numbers;
}

template <int B>
RowMajorMatrix read(const LineVector& numbers, int n) {
  return Eigen::Map<const RowMajorMatrix, 0, Eigen::OuterStride<>>(numbers.data(), n, n,
                                                                   Eigen::OuterStride<>(row_stride<B>(n)));
}

void expect_near(const RowMajorMatrix& found, const RowMajorMatrix& expected) {
  // All matrices of the examples have condition numbers near 1.
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
}

/// Calls check(kernels) with all instructions available for blocks of B rows.
template <int B, typename Check>
void with_each(int n, Check&& check) {
  for (const VectorInstructions instructions : vector_instructions()) {
    SCOPED_TRACE(testing::Message() << n << " rows, " << name_of(instructions));
    if constexpr (has_wide_rows<B>) {
      with_vectors(instructions,
                   [&](auto lanes) BUMPFOIL_ALWAYS_INLINE { check(DenseKernels<B, decltype(lanes)::value>(n)); });
    } else {
      check(DenseKernels<B, 2>(n));
    }
  }
}

template <int B>
void expect_products(int n) {
  const RowMajorMatrix a = example_matrix(n, 0.1), b = example_matrix(n, 0.2), c = example_matrix(n, 0.3);
  const LineVector A = stored<B>(a), rows = stored<B>(b), before = stored<B>(c);
  with_each<B>(n, [&](const auto& kernels) {
    LineVector C = before;
    kernels.products(A.data(), kernels.stride(), rows.data(), n, C.data(), n);
    expect_near(read<B>(C, n), c - a * b);
    kernels.template products<Products::assign>(A.data(), kernels.stride(), rows.data(), n, C.data(), n);
    expect_near(read<B>(C, n), a * b);
    kernels.template products<Products::negate>(A.data(), kernels.stride(), rows.data(), n, C.data(), n);
    expect_near(read<B>(C, n), -a * b);

    RowMajorMatrix sparse = RowMajorMatrix::Zero(n, n);
    sparse.diagonal() = a.diagonal();
    sparse.col(n - 1) = a.col(n - 1);
    C = before;
    kernels.template products<Products::subtract, true>(stored<B>(sparse).data(), kernels.stride(), rows.data(), n,
                                                        C.data(), n);
    expect_near(read<B>(C, n), c - sparse * b);

    const double factors[]{2.0, -3.0};
    const RowMajorMatrix row = c.row(0) - a.row(0).cwiseProduct(b.row(0)) - 2.0 * a.row(0) + 3.0 * a.row(1);
    const auto expect_row = [&](const auto& call) {
      C = before;
      call();
      expect_near(read<B>(C, n).row(0), row);
      expect_near(read<B>(C, n).bottomRows(n - 1), c.bottomRows(n - 1));
    };
    const double* const more = A.data();
    expect_row([&] { kernels.products_of_row(A.data(), rows.data(), factors, more, 2, C.data()); });
    expect_row([&] {
      kernels.template products_of_row<Products::subtract, 2>(A.data(), rows.data(), factors, more, 2, C.data());
    });
  });
}

template <int B>
void expect_solutions(int n) {
  const RowMajorMatrix a = example_matrix(n, 0.1), b = example_matrix(n, 0.2);
  std::vector<int> pivots(static_cast<std::size_t>(n));
  std::vector<double> room(static_cast<std::size_t>(n));
  const RowMajorMatrix solution = a.partialPivLu().solve(b);
  with_each<B>(n, [&](const auto& kernels) {
    LineVector A = stored<B>(a), X = stored<B>(b);
    ASSERT_TRUE(kernels.factor(A.data(), pivots.data()));
    kernels.solve(A.data(), pivots.data(), X.data());
    expect_near(read<B>(X, n), solution);
    A = stored<B>(a);
    ASSERT_TRUE(kernels.invert(A.data(), room.data(), pivots.data()));
    expect_near(read<B>(A, n), a.inverse());

    RowMajorMatrix broken = a;

    broken.row(n - 1).setZero();
    A = stored<B>(broken);
    EXPECT_FALSE(kernels.factor(A.data(), pivots.data()));
    A = stored<B>(broken);
    EXPECT_FALSE(kernels.invert(A.data(), room.data(), pivots.data()));
    broken = a;
    broken(n - 1, n - 1) = std::numeric_limits<double>::quiet_NaN();
    A = stored<B>(broken);
    EXPECT_FALSE(kernels.factor(A.data(), pivots.data()));
    A = stored<B>(broken);
    EXPECT_FALSE(kernels.invert(A.data(), room.data(), pivots.data()));
  });
}

TEST(DenseKernels, AddProductsUpAsMatricesDo) {
  expect_products<6>(6);
  expect_products<10>(10);
  expect_products<11>(11);
  expect_products<18>(18);
  expect_products<22>(22);
  for (const int n : {2, 8, 13, 17}) expect_products<Eigen::Dynamic>(n);
}

TEST(DenseKernels, SolveAndInvertAsMatricesDo) {
  expect_solutions<6>(6);
  expect_solutions<10>(10);
  expect_solutions<11>(11);
  expect_solutions<18>(18);
  expect_solutions<22>(22);
  for (const int n : {2, 8, 13, 17}) expect_solutions<Eigen::Dynamic>(n);
}

TEST(DenseKernels, TakeRowsFromTheBeginningOfALineOn) {
  const LineVector numbers(3);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64, 0U);
  EXPECT_EQ(row_stride<22>(22), 24);
  EXPECT_EQ(row_stride<6>(6), 6);
  EXPECT_EQ(row_stride<Eigen::Dynamic>(13), 13);
}

/// Rows that no vector divides, factors a step apart and some of them zero.
TEST(DenseKernels, AddsRowsOfPanels) {
  constexpr int columns = 11;
  const RowMajorMatrix rows = RowMajorMatrix::Random(5, columns);
  RowMajorMatrix factors = RowMajorMatrix::Random(5, 3);
  factors(2, 1) = 0.0;
  for (const double sign : {1.0, -1.0}) {
    RowMajorMatrix row = RowMajorMatrix::Random(1, columns);
    const RowMajorMatrix expected = row + sign * factors.col(1).transpose() * rows;
    add_rows(sign, factors.data() + 1, factors.cols(), factors.rows(), rows.data(), columns, row.data());
    expect_near(row, expected);
  }
}

}  // namespace
}  // namespace bumpfoil
