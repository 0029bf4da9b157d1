#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/structure/frame.hpp"

namespace bumpfoil {
namespace {

/// A flat strip of bumps between two rigid flat plates, compressed by 20 um in 20 increments. The loads are those of a
/// continuum: CalculiX 2.20, plane strain, small displacements, 36 elements along half a bump; bumps of the reference
/// bearing with a mid-surface rise of 0.508 mm, clamped at the start of the first arc.
struct Strip {
  std::string name;
  double friction_coefficient;
  std::vector<double> loads;  ///< of the upper plate on each bump from the weld on, N
};

const std::vector<Strip> continuum_strips{
    {"one bump", 0.0, {36.61}},
    {"one bump with friction", 0.1, {38.525}},
    {"three bumps", 0.0, {50.527, 39.522, 27.133}},
    {"three bumps with friction", 0.1, {63.017, 46.187, 28.832}},
    {"ten bumps", 0.0, {50.53, 39.333, 39.505, 39.503, 39.503, 39.503, 39.503, 39.5, 39.692, 27.131}},
    {"ten bumps with friction", 0.1, {134.663, 113.35, 99.78, 87.765, 77.194, 67.887, 59.699, 52.491, 46.345, 28.83}},
};

/// Frame model of the bump foil without a top foil: its nine unknowns per bump, in contact with both plates.
ContactProblem make_strip(const Strip& strip) {
  Case input = reference_case();
  input.bump_foil.height_reference = HeightReference::midsurface;
  input.bump_foil.weld_at = WeldPosition::arc_start;
  input.bump_foil.bumps = static_cast<int>(strip.loads.size());
  const BumpDofs dofs = frame_dofs();
  BlockTridiagonal whole(input.bump_foil.bumps, dofs.size);
  assemble_frame(make_frame_model(input), whole);

  ContactProblem problem;
  for (const Matrix& block : whole.diagonal) problem.K.diagonal.push_back(block.topLeftCorner(9, 9));
  for (const Matrix& block : whole.upper) problem.K.upper.push_back(block.topLeftCorner(9, 9));
  problem.pairs.push_back(
      {.plus = dofs.crest_v, .tangential = dofs.crest_u, .friction_coefficient = strip.friction_coefficient});
  for (const std::size_t foot : {0U, 1U}) {
    problem.pairs.push_back({.minus = dofs.foot_v[foot],
                             .tangential = dofs.foot_u[foot],
                             .friction_coefficient = strip.friction_coefficient});
  }
  return problem;
}

/// Loads of the upper plate on the crests after the compression.
Vector compress(const ContactProblem& problem) {
  constexpr int increments = 20;
  constexpr double compression = 20e-6;
  constexpr Eigen::Index pairs = 3;
  const Eigen::Index bumps = problem.K.blocks();
  NewtonSolver solver(problem);
  ContactState state = ContactState::unstressed(problem);
  ContactLoading loading{.initial_gap = Vector::Zero(problem.contacts()), .load = Vector::Zero(problem.K.rows())};
  for (int i = 1; i <= increments; ++i) {
    loading.initial_gap(Eigen::seqN(0, bumps, pairs)).setConstant(-compression * i / increments);
    const ContactState previous = state;
    EXPECT_TRUE(solver.solve(loading, previous, state).converged);
  }
  return state.normal_force(Eigen::seqN(0, bumps, pairs));
}

TEST(FrameStrip, MeetsTheContinuumBumpByBump) {
  for (const Strip& strip : continuum_strips) {
    const Vector loads = compress(make_strip(strip));
    const auto continuum = Eigen::Map<const Vector>(strip.loads.data(), loads.size());
    for (Eigen::Index n = 0; n < loads.size(); ++n) {
      // The beam neglects shear and the thickness against the radius (0.102 mm to 3.4 mm): errors below 1 %.
      EXPECT_NEAR(loads[n], continuum[n], 0.01 * continuum[n]) << strip.name << ", bump " << n + 1;
    }
    EXPECT_NEAR(loads.sum(), continuum.sum(), 0.005 * continuum.sum()) << strip.name;
  }
}

}  // namespace
}  // namespace bumpfoil
