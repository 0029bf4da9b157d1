#include "bumpfoil/contact/coulomb_contact.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace bumpfoil {
namespace {

/// Two blocks of three unknowns with a contact between the first two, sliding on the third, and a frictionless one.
ContactProblem two_blocks() {
  return {.K = BlockTridiagonal(2, 3),
          .sites = in_every_block({{.plus = 0, .minus = 1, .tangential = 2, .friction_coefficient = 0.3},
                                   {.plus = 1, .friction_coefficient = 0.7}},
                                  2)};
}

TEST(CoulombContact, VisitsContactsInTheOrderOfTheirArrays) {
  const ContactProblem problem = two_blocks();
  std::vector<Eigen::Index> rows;
  std::vector<double> coefficients;
  Eigen::Index next = 0;
  for_each_contact(problem, [&](const CoulombContact& contact) {
    EXPECT_EQ(contact.index, next++);
    rows.push_back(contact.row);
    coefficients.push_back(contact.f);
  });
  EXPECT_EQ(rows, (std::vector<Eigen::Index>{0, 0, 3, 3}));
  // A coefficient without a tangential unknown has no effect.
  EXPECT_EQ(coefficients, (std::vector<double>{0.3, 0.0, 0.3, 0.0}));
}

TEST(CoulombContact, ReadsGapAndSlipAndAddsForcesInItsBlock) {
  const ContactProblem problem = two_blocks();
  Vector x(6);
  x << 1.0, 2.0, 4.0, 8.0, 16.0, 32.0;
  std::vector<double> gaps;
  std::vector<double> tangential;
  Vector force = Vector::Zero(6);
  for_each_contact(problem, [&](const CoulombContact& contact) {
    gaps.push_back(contact.gap(x));
    tangential.push_back(contact.tangential(x));
    contact.add_forces(10.0 + static_cast<double>(contact.index), 0.5, 2.0, force);
  });
  EXPECT_EQ(gaps, (std::vector<double>{-1.0, 2.0, -8.0, 16.0}));
  EXPECT_EQ(tangential, (std::vector<double>{4.0, 0.0, 32.0, 0.0}));
  Vector expected(6);
  expected << 20.0, -20.0 + 22.0, 1.0, 24.0, -24.0 + 26.0, 1.0;
  EXPECT_EQ(force, expected);
}

}  // namespace
}  // namespace bumpfoil
