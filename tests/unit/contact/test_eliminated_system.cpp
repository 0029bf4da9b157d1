#include "contact/eliminated_system.hpp"

#include <gtest/gtest.h>

#include "support/random_problem.hpp"

namespace bumpfoil {
namespace {

/// Order for the contacts of one block.
std::vector<Elimination> order_of(const std::vector<ContactSite>& sites) {
  return elimination_order({.K = BlockTridiagonal(1, 6), .sites = sites});
}

/// Contact 0 acts on unknown 4, on which contact 1 lies: 1 is first, with the unknown that only it touches.
TEST(EliminationOrder, TakesOwnersThatNoLaterContactTouches) {
  const std::vector<Elimination> order = order_of({{.plus = 4}, {.plus = 1, .minus = 4}, {.minus = 3}});
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order[0].site, 1U);
  EXPECT_EQ(order[0].owner, 1);
  EXPECT_EQ(order[0].owner_sign, 1.0);
  EXPECT_EQ(order[0].other, 4);
  EXPECT_EQ(order[1].site, 2U);
  EXPECT_EQ(order[1].owner, 3);
  EXPECT_EQ(order[1].owner_sign, -1.0);
  EXPECT_EQ(order[1].other, -1);
  EXPECT_EQ(order[2].site, 0U);
  EXPECT_EQ(order[2].owner, 4);
}

/// The tangential unknown of a contact belongs to no other contact, not even to a later one.
TEST(EliminationOrder, TakesNoOwnerThatAnotherRubsAlong) {
  const std::vector<Elimination> order = order_of({{.plus = 0, .minus = 1}, {.plus = 2, .tangential = 0}});
  EXPECT_EQ(order[0].site, 0U);
  EXPECT_EQ(order[0].owner, 1);
  EXPECT_EQ(order[0].owner_sign, -1.0);
  EXPECT_EQ(order[0].other, 0);
}

TEST(EliminationOrder, GoesBlockByBlockThroughWhatEachHas) {
  const std::vector<Elimination> order = elimination_order(
      {.K = BlockTridiagonal(3, 6),
       .sites = {{.block = 0, .plus = 4}, {.block = 0, .plus = 1, .minus = 4}, {.block = 2, .minus = 3}}});
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order[0].site, 1U);
  EXPECT_EQ(order[1].site, 0U);
  EXPECT_EQ(order[2].site, 2U);
}

template <int B>
void expect_products_and_rows(const BlockTridiagonal& K) {
  const Stiffness<B> blocks(K);
  const Matrix dense = K.dense();
  const Eigen::Index n = K.block_size();
  const Vector x = Vector::LinSpaced(K.rows(), -1.0, 2.0);
  Vector y(K.rows());
  blocks.multiply(x, y);
  EXPECT_LT((y - dense * x).cwiseAbs().maxCoeff(), 1e-14 * y.cwiseAbs().maxCoeff());
  typename Stiffness<B>::Rows rows(n, 3 * n);
  Matrix between = Matrix::Zero(K.rows(), K.rows() + 2 * n);  // a block of zeros at either side
  between.middleCols(n, K.rows()) = dense;
  for (Eigen::Index b = 0; b < K.blocks(); ++b) {
    blocks.copy_rows(static_cast<std::size_t>(b), rows);
    EXPECT_EQ(Matrix(rows), Matrix(between.block(b * n, b * n, n, 3 * n))) << b;
  }
}

TEST(Stiffness, MultipliesAndCopiesRows) {
  BlockTridiagonal K = make_random_problem(1, 4, 6, 0.0).problem.K;
  for (const bool symmetric : {true, false}) {
    if (!symmetric) {
      for (const Matrix& block : K.upper) K.lower.emplace_back(2.0 * block);
    }
    expect_products_and_rows<6>(K);
    expect_products_and_rows<Eigen::Dynamic>(K);
  }
}

TEST(IsFrictionless, WithoutCoefficientOrDirection) {
  EXPECT_TRUE(is_frictionless({.plus = 0}));
  EXPECT_TRUE(is_frictionless({.plus = 0, .tangential = 1}));
  EXPECT_TRUE(is_frictionless({.plus = 0, .friction_coefficient = 0.1}));
  EXPECT_FALSE(is_frictionless({.plus = 0, .tangential = 1, .friction_coefficient = 0.1}));
}

}  // namespace
}  // namespace bumpfoil
