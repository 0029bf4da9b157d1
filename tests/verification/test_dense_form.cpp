#include <gtest/gtest.h>

#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "bumpfoil/structure/truss.hpp"
#include "support/dense_contacts.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

/// Compares states of the reference cycles with dense matrices: truss and inverted compliance of the top foil, unknowns
/// foil by foil, contact forces as multipliers. Nothing of the block form is used.
namespace bumpfoil {
namespace {

/// Unknowns: crest u, crest v, foot u, foot v of every bump, then the top foil.
DenseContacts dense_bearing(const Case& input) {
  const int bumps = input.bump_foil.bumps;
  const BumpDofs dofs{.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};
  BlockTridiagonal bump_foil(bumps, 4);
  assemble_springs(make_truss_springs(make_truss_constants(make_bearing_design(input)), dofs), bump_foil);
  const Eigen::Index n = Eigen::Index{5} * bumps;
  const Eigen::Index contacts = Eigen::Index{3} * bumps;
  DenseContacts dense{.K = Matrix::Zero(n, n),
                      .normal = Matrix::Zero(contacts, n),
                      .tangential = Matrix::Zero(contacts, n),
                      .friction = Vector::Zero(contacts)};
  dense.K.topLeftCorner(4 * bumps, 4 * bumps) = bump_foil.dense();
  dense.K.bottomRightCorner(bumps, bumps) = top_foil_stiffness(make_top_foil_beam(make_bearing_design(input)));
  for (Eigen::Index i = 0; i < bumps; ++i) {
    const Eigen::Index top = 4 * bumps + i;
    dense.normal(3 * i, top) = 1.0;
    dense.normal(3 * i + 1, 4 * i + 1) = 1.0;
    dense.normal(3 * i + 1, top) = -1.0;
    dense.tangential(3 * i + 1, 4 * i) = 1.0;
    dense.normal(3 * i + 2, 4 * i + 3) = -1.0;
    dense.tangential(3 * i + 2, 4 * i + 2) = 1.0;
    dense.friction[3 * i + 1] = input.friction.top_bump;
    dense.friction[3 * i + 2] = input.friction.bump_sleeve;
  }
  return dense;
}

/// The order of contacts in a block: journal, crest, foot.
template <typename List>
auto interleave(const List& journal, const List& crest, const List& foot) {
  std::vector<typename List::value_type> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(journal.size()); ++i) {
    for (const List* list : {&journal, &crest, &foot}) all.push_back(*(list->begin() + static_cast<std::ptrdiff_t>(i)));
  }
  return all;
}

Vector to_vector(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Unknowns of dense_bearing at an increment.
Vector displacements(const FullIncrement& increment) {
  const Eigen::Index bumps = increment.crest_u.size();
  Vector x(5 * bumps);
  for (Eigen::Index i = 0; i < bumps; ++i) {
    x.segment(4 * i, 4) << increment.crest_u[i], increment.crest_v[i], increment.foot_u[i], increment.foot_v[i];
  }
  x.tail(bumps) = increment.top_displacement;
  return x;
}

class DenseForm : public testing::TestWithParam<std::size_t> {};

TEST_P(DenseForm, SolvesTheSameModesToTheSameState) {
  const Case& input = reference_cycles().at(GetParam()).input;
  const Cycle cycle = run_cycles(input).cycles.front();
  ASSERT_TRUE(cycle.converged());
  const BearingModel foils = *make_bearing_foils(input);
  const DenseContacts dense = dense_bearing(input);
  const double largest_force = turning_increment(cycle).journal_top.normal_force.maxCoeff();
  const double largest_displacement = displacements(turning_increment(cycle)).cwiseAbs().maxCoeff();
  for (std::size_t k = 9; k < cycle.increments.size(); k += 16) {
    const FullIncrement now = increment_at(cycle, static_cast<int>(k));
    const std::vector<ContactMode> mode = interleave(now.journal_top.mode, now.top_bump.mode, now.bump_sleeve.mode);
    const ContactLoading at = loading_under(foils, {.position = {now.x, now.y}});
    const ContactLoading loading{.initial_gap = at.initial_gap, .load = Vector::Zero(dense.K.rows())};
    const DenseState expected =
        solve_dense(dense, loading, displacements(increment_at(cycle, static_cast<int>(k) - 1)), mode);
    // Inverting the compliance loses 5 of 16 digits.
    EXPECT_LT(
        (to_vector(interleave(now.journal_top.normal_force, now.top_bump.normal_force, now.bump_sleeve.normal_force)) -
         expected.normal_force)
            .cwiseAbs()
            .maxCoeff(),
        1e-10 * largest_force)
        << "increment " << k;
    EXPECT_LT((to_vector(interleave(now.journal_top.friction_force, now.top_bump.friction_force,
                                    now.bump_sleeve.friction_force)) -
               expected.friction_force)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-10 * largest_force)
        << "increment " << k;
    // The free end of the top foil nearly floats: displacements are a hundred times less accurate than forces.
    EXPECT_LT((displacements(now) - expected.x).cwiseAbs().maxCoeff(), 1e-9 * largest_displacement)
        << "increment " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Reference, DenseForm, testing::Range(std::size_t{0}, std::size_t{9}));

}  // namespace
}  // namespace bumpfoil
