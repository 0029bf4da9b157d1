#include "film/foil_span.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace bumpfoil {
namespace {

void fill(ColumnCoupling& coupling, int n, double seed) {
  for (int j = 0; j < n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    coupling.own[i] = j < n - 2 ? std::sin(seed + 3.0 * j) : 0.0;
    coupling.by_lift[i] = std::cos(2.0 * seed + j);
    coupling.by_moment[i] = std::sin(5.0 * seed - j);
  }
}

Matrix dense_coupling(const ColumnCoupling& coupling, int n) {
  Matrix S = Matrix::Zero(n, n);
  for (int j = 0; j < n; ++j) {
    const auto i = static_cast<std::size_t>(j);
    S(j, j) = coupling.own[i];
    S(j, n - 2) += coupling.by_lift[i];
    S(j, n - 1) += coupling.by_moment[i];
  }
  return S;
}

/// A span and the same with its neighbours, densely: the neighbour before, the columns, the neighbour after, whose own
/// blocks are zero.
struct Example {
  std::unique_ptr<FoilSpan> span;
  Matrix A;
};

Example example(int columns, int n, bool has_before, VectorInstructions instructions) {
  Example it{make_foil_span(columns, n, has_before, instructions), Matrix::Zero(n * (columns + 2), n * (columns + 2))};
  FoilSpan& span = *it.span;
  fill(span.of_before(), n, 0.3);
  fill(span.of_after(), n, 0.4);
  for (int c = 0; c < columns; ++c) {
    fill(span.to_before(c), n, 1.0 + c);
    fill(span.to_after(c), n, 2.0 - c);
    for (int i = 0; i < n; ++i) {
      // Heavy one place off the diagonal: without row exchanges the pivots would be poor.
      for (int j = 0; j < n; ++j) span.own(c)(i, j) = std::sin(3.0 * c + i * j) + (j == (i + 1) % n ? 5.0 * n : 0.0);
    }
    const Eigen::Index row = Eigen::Index{n} * (c + 1);
    it.A.block(row, row, n, n) = span.own(c);
    if (c > 0 || has_before) it.A.block(row, row - n, n, n) = dense_coupling(span.to_before(c), n);
    it.A.block(row, row + n, n, n) = dense_coupling(span.to_after(c), n);
  }
  if (has_before) it.A.block(0, n, n, n) = dense_coupling(span.of_before(), n);
  it.A.block(Eigen::Index{n} * (columns + 1), Eigen::Index{n} * columns, n, n) = dense_coupling(span.of_after(), n);
  return it;
}

void expect_like_dense(int columns, int n, bool has_before, VectorInstructions instructions) {
  SCOPED_TRACE(testing::Message() << columns << " columns of " << n << ", " << name_of(instructions));
  const Example it = example(columns, n, has_before, instructions);
  const auto& span = it.span;
  const Matrix& A = it.A;
  const Eigen::Index inside = Eigen::Index{n} * columns;
  const auto own = A.block(n, n, inside, inside).partialPivLu();
  FoilSpan::Condensed condensed;
  ASSERT_TRUE(span->eliminate(condensed));
  const auto outer = [&](Eigen::Index row, Eigen::Index column) -> Matrix {
    return -A.block(row, n, n, inside) * own.solve(A.block(n, column, inside, n));
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

  for (const double scale : {1.0, -2.0}) {  // nothing is left of the right-hand side before
    const Matrix right = scale * Vector::LinSpaced(inside, -1.0, 2.0).reshaped(n, columns);
    Vector before(n), after(n);
    span->condense(right, before, after);
    const Vector held = own.solve(right.reshaped());
    expect_near(before, -A.block(0, n, n, inside) * held);
    expect_near(after, -A.block(end, n, n, inside) * held);

    const Vector x_before = has_before ? Vector(Vector::LinSpaced(n, 0.5, 1.0)) : Vector::Zero(n);
    const Vector x_after = Vector::LinSpaced(n, -0.5, 1.0);
    Matrix solution;
    span->expand(x_before, x_after, solution);
    const Vector expected = own.solve(Vector(right.reshaped()) - A.block(n, 0, inside, n) * x_before -
                                      A.block(n, end, inside, n) * x_after);
    expect_near(solution.reshaped(), expected);
  }
}

TEST(FoilSpan, LeavesItsNeighboursWhatDenseEliminationLeaves) {
  for (const VectorInstructions instructions : vector_instructions()) {
    for (const int n : {3, 10, 18, 21}) {  // of code of their own, and of none
      for (const int columns : {1, 2, 5}) {
        expect_like_dense(columns, n, true, instructions);
        expect_like_dense(columns, n, false, instructions);
      }
    }
  }
}

TEST(FoilSpan, ReportsSingularColumns) {
  for (const int n : {4, 18}) {
    auto [span, A] = example(3, n, true, VectorInstructions::baseline);
    ColumnCoupling& coupling = span->to_before(1);
    coupling.own[1] = coupling.by_lift[1] = coupling.by_moment[1] = 0.0;
    span->own(1).row(1).setZero();
    FoilSpan::Condensed condensed;
    EXPECT_FALSE(span->eliminate(condensed));
  }
}

}  // namespace
}  // namespace bumpfoil
