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

TEST(Stiffness, MultipliesAndCopiesRows) {
  const BlockTridiagonal K = make_random_problem(1, 4, 6, 0.0).problem.K;
  const Stiffness<6> fixed(K);
  const Vector x = Vector::LinSpaced(K.rows(), -1.0, 2.0);
  Vector y(K.rows());
  fixed.multiply(x, y);
  EXPECT_LT((y - K.multiply(x)).cwiseAbs().maxCoeff(), 1e-14 * y.cwiseAbs().maxCoeff());
  Stiffness<6>::Rows rows;
  fixed.copy_rows(1, rows);
  EXPECT_LT((rows * x.head(18) - y.segment(6, 6)).cwiseAbs().maxCoeff(), 1e-14 * y.cwiseAbs().maxCoeff());
  fixed.copy_rows(0, rows);
  EXPECT_EQ(rows.leftCols(6).norm(), 0.0);
  fixed.copy_rows(3, rows);
  EXPECT_EQ(rows.rightCols(6).norm(), 0.0);
}

TEST(IsFrictionless, WithoutCoefficientOrDirection) {
  EXPECT_TRUE(is_frictionless({.plus = 0}));
  EXPECT_TRUE(is_frictionless({.plus = 0, .tangential = 1}));
  EXPECT_TRUE(is_frictionless({.plus = 0, .friction_coefficient = 0.1}));
  EXPECT_FALSE(is_frictionless({.plus = 0, .tangential = 1, .friction_coefficient = 0.1}));
}

}  // namespace
}  // namespace bumpfoil
