#include "film/foil_span.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Unknowns of a column, and how many of them belong to the foil.
struct Sizes {
  int n{}, of_foil{};
};

void fill(ColumnCoupling& coupling, const Sizes& sizes, double seed) {
  for (int j = 0; j < sizes.n; ++j) {
    coupling.own[static_cast<std::size_t>(j)] = j < sizes.n - sizes.of_foil ? std::sin(seed + 3.0 * j) : 0.0;
    for (int t = 0; t < sizes.of_foil; ++t) coupling.by(t)[j] = std::cos((2.0 + 3.0 * t) * seed + j);
  }
}

Matrix dense_coupling(ColumnCoupling& coupling, const Sizes& sizes) {
  Matrix S = Matrix::Zero(sizes.n, sizes.n);
  for (int j = 0; j < sizes.n; ++j) {
    S(j, j) = coupling.own[static_cast<std::size_t>(j)];
    for (int t = 0; t < sizes.of_foil; ++t) S(j, sizes.n - sizes.of_foil + t) += coupling.by(t)[j];
  }
  return S;
}

/// A span, and the same as a dense matrix: the neighbour before, the columns, the neighbour after. Own blocks of the
/// neighbours are zero.
struct Example {
  std::unique_ptr<FoilSpan> span;
  Matrix A;
};

Example example(int columns, const Sizes& sizes, bool has_before, VectorInstructions instructions) {
  const int n = sizes.n;
  Example it{make_foil_span(columns, n, sizes.of_foil, has_before, instructions),
             Matrix::Zero(n * (columns + 2), n * (columns + 2))};
  FoilSpan& span = *it.span;
  fill(span.of_before(), sizes, 0.3);
  fill(span.of_after(), sizes, 0.4);
  for (int c = 0; c < columns; ++c) {
    fill(span.to_before(c), sizes, 1.0 + c);
    fill(span.to_after(c), sizes, 2.0 - c);
    for (int i = 0; i < n; ++i) {
      // Largest next to the diagonal: without row exchanges the pivots would be poor.
      for (int j = 0; j < n; ++j) span.own(c)(i, j) = std::sin(3.0 * c + i * j) + (j == (i + 1) % n ? 5.0 * n : 0.0);
    }
    const Eigen::Index row = Eigen::Index{n} * (c + 1);
    it.A.block(row, row, n, n) = span.own(c);
    if (c > 0 || has_before) it.A.block(row, row - n, n, n) = dense_coupling(span.to_before(c), sizes);
    it.A.block(row, row + n, n, n) = dense_coupling(span.to_after(c), sizes);
  }
  // Without columns it couples to the neighbour after.
  if (has_before) it.A.block(0, n, n, n) = dense_coupling(span.of_before(), sizes);
  it.A.block(Eigen::Index{n} * (columns + 1), Eigen::Index{n} * columns, n, n) = dense_coupling(span.of_after(), sizes);
  return it;
}

void expect_like_dense(int columns, const Sizes& sizes, bool has_before, VectorInstructions instructions) {
  const int n = sizes.n;
  SCOPED_TRACE(testing::Message() << columns << " columns of " << n << ", " << name_of(instructions));
  const Example it = example(columns, sizes, has_before, instructions);
  const auto& span = it.span;
  const Matrix& A = it.A;
  const Eigen::Index inside = Eigen::Index{n} * columns;
  const Matrix own = A.block(n, n, inside, inside);
  FoilSpan::Condensed condensed;
  ASSERT_TRUE(span->eliminate(condensed));
  const auto outer = [&](Eigen::Index row, Eigen::Index column) -> Matrix {
    if (columns == 0) return row == column ? Matrix::Zero(n, n) : Matrix(A.block(row, column, n, n));
    return -A.block(row, n, n, inside) * solve(own, Matrix(A.block(n, column, inside, n)));
  };
  // All matrices of the example have condition numbers near 1.
  const auto expect_near = [](const Matrix& found, const Matrix& expected) {
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-14);
  };
  const Eigen::Index end = n + inside;
  expect_near(condensed.before, outer(0, 0));
  expect_near(condensed.before_by_after, outer(0, end));
  expect_near(condensed.after_by_before, outer(end, 0));
  expect_near(condensed.after, outer(end, end));

  for (const Eigen::Index sides : {1, 3, 2}) {  // no remainder of earlier right-hand sides
    const Vector ramp = Vector::LinSpaced(inside, -1.0, 2.0);
    const Matrix right = ramp * Vector::LinSpaced(sides, 1.0, -2.0).transpose();
    Matrix before(n, sides), after(n, sides);
    span->condense(right.reshaped(n, sides * columns), before, after);
    if (columns == 0) {
      expect_near(before, Matrix::Zero(n, sides));
      expect_near(after, Matrix::Zero(n, sides));
      continue;
    }
    const Matrix held = solve(own, right);
    expect_near(before, -A.block(0, n, n, inside) * held);
    expect_near(after, -A.block(end, n, n, inside) * held);

    Matrix x_before = Matrix::Zero(n, sides);
    if (has_before) x_before = Vector::LinSpaced(n, 0.5, 1.0) * Vector::LinSpaced(sides, 2.0, 1.0).transpose();
    const Matrix x_after = Vector::LinSpaced(n, -0.5, 1.0) * Vector::LinSpaced(sides, 1.0, 3.0).transpose();
    Matrix solution;
    span->expand(x_before, x_after, solution);
    const Matrix known = right - A.block(n, 0, inside, n) * x_before - A.block(n, end, inside, n) * x_after;
    expect_near(solution.reshaped(inside, sides), solve(own, known));
  }
}

TEST(FoilSpan, LeavesItsNeighboursWhatDenseEliminationLeaves) {
  for (const VectorInstructions instructions : vector_instructions()) {
    // Compiled and generic sizes.
    for (const Sizes& sizes : {Sizes{3, 2}, {10, 2}, {18, 2}, {21, 2}, {14, 6}, {22, 6}, {9, 6}, {18, 6}, {39, 8}}) {
      expect_like_dense(0, sizes, true, instructions);  // adjacent neighbours
      for (const int columns : {1, 2, 5}) {
        expect_like_dense(columns, sizes, true, instructions);
        expect_like_dense(columns, sizes, false, instructions);
      }
    }
  }
}

TEST(FoilSpan, ReportsSingularColumns) {
  for (const int n : {4, 18}) {
    auto [span, A] = example(3, {n, 2}, true, VectorInstructions::baseline);
    ColumnCoupling& coupling = span->to_before(1);
    coupling.own[1] = coupling.by(0)[1] = coupling.by(1)[1] = 0.0;
    span->own(1).row(1).setZero();
    FoilSpan::Condensed condensed;
    EXPECT_FALSE(span->eliminate(condensed));
  }
}

}  // namespace
}  // namespace bumpfoil
