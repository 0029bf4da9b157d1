#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/structure/frame.hpp"

namespace bumpfoil {
namespace {

/// A flat strip of bumps between two rigid flat plates, compressed by 20 um in 20 increments. The loads are those of a
/// continuum: CalculiX 2.20, plane strain, 36 elements along half a bump; bumps of the reference bearing with a
/// mid-surface rise of 0.508 mm, clamped at the start of the first arc.
struct Strip {
  std::string name;
  double friction_coefficient;
  std::vector<double> loads;        ///< of the upper plate on each bump from the weld on, small displacements, N
  std::vector<double> large_loads;  ///< the same with large displacements
};

const std::vector<Strip> continuum_strips{
    {"one bump", 0.0, {36.61}, {36.356}},
    {"one bump with friction", 0.1, {38.525}, {38.162}},
    {"three bumps", 0.0, {50.527, 39.522, 27.133}, {50.223, 39.266, 26.928}},
    {"three bumps with friction", 0.1, {63.017, 46.187, 28.832}, {61.959, 45.562, 28.537}},
    {"ten bumps",
     0.0,
     {50.53, 39.333, 39.505, 39.503, 39.503, 39.503, 39.503, 39.5, 39.692, 27.131},
     {50.226, 39.077, 39.249, 39.246, 39.246, 39.246, 39.246, 39.243, 39.435, 26.926}},
    {"ten bumps with friction",
     0.1,
     {134.663, 113.35, 99.78, 87.765, 77.194, 67.887, 59.699, 52.491, 46.345, 28.83},
     {127.604, 107.648, 95.258, 84.228, 74.48, 65.856, 58.231, 51.488, 45.721, 28.535}},
};

constexpr int unknowns_per_bump = 9;  ///< of the bump foil alone, the first of frame_dofs()
constexpr Eigen::Index pairs_per_bump = 3;

/// Elastic law of the bump foil by itself.
ElasticLaw large_displacements(const FrameModel& model) {
  const ElementChain chain = place_elements(model, unknowns_per_bump);
  BlockTridiagonal covered(static_cast<int>(model.arcs.size()), unknowns_per_bump);
  hold_covered_node(model, covered);
  return {.forces =
              [=](const Vector& x) {
                Vector forces = covered.multiply(x);
                add_corotational_forces(chain, x, forces);
                return forces;
              },
          .tangent =
              [=](const Vector& x) {
                BlockTridiagonal K = covered;
                add_corotational_tangent(chain, x, K);
                return K;
              },
          .stable_tangent =
              [=](const Vector& x) {
                BlockTridiagonal K = covered;
                add_stable_tangent(chain, x, K);
                return K;
              }};
}

/// Frame model of the bump foil without a top foil, in contact with both plates.
ContactProblem make_strip(const Strip& strip, Geometry geometry) {
  Case input = reference_case();
  input.bump_foil.height_reference = HeightReference::midsurface;
  input.bump_foil.weld_at = WeldPosition::arc_start;
  input.bump_foil.bumps = static_cast<int>(strip.loads.size());
  const ElasticLaw law = large_displacements(make_frame_model(input));

  ContactProblem problem;
  problem.K = law.tangent(Vector::Zero(Eigen::Index{input.bump_foil.bumps} * unknowns_per_bump));
  if (geometry == Geometry::nonlinear) problem.law = law;
  const BumpDofs dofs = frame_dofs();
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
  const Eigen::Index bumps = problem.K.blocks();
  NewtonSolver solver(problem);
  ContactState state = ContactState::unstressed(problem);
  ContactLoading loading{.initial_gap = Vector::Zero(problem.contacts()), .load = Vector::Zero(problem.K.rows())};
  for (int i = 1; i <= increments; ++i) {
    loading.initial_gap(Eigen::seqN(0, bumps, pairs_per_bump)).setConstant(-compression * i / increments);
    const ContactState previous = state;
    EXPECT_TRUE(solver.solve(loading, previous, state).converged);
    const Vector elastic = problem.law ? problem.law->forces(state.x) : problem.K.multiply(state.x);
    EXPECT_TRUE(contact_residuals(problem, elastic, loading, previous.x, state).within());
  }
  return state.normal_force(Eigen::seqN(0, bumps, pairs_per_bump));
}

TEST(FrameStrip, MeetsTheContinuumBumpByBump) {
  for (const Strip& strip : continuum_strips) {
    const Vector loads = compress(make_strip(strip, Geometry::linear));
    const auto continuum = Eigen::Map<const Vector>(strip.loads.data(), loads.size());
    for (Eigen::Index n = 0; n < loads.size(); ++n) {
      // The beam neglects shear and the thickness against the radius (0.102 mm to 3.4 mm): errors below 1 %.
      EXPECT_NEAR(loads[n], continuum[n], 0.01 * continuum[n]) << strip.name << ", bump " << n + 1;
    }
    EXPECT_NEAR(loads.sum(), continuum.sum(), 0.005 * continuum.sum()) << strip.name;
  }
}

TEST(FrameStrip, MeetsTheContinuumAtLargeDisplacements) {
  for (const Strip& strip : continuum_strips) {
    const Vector loads = compress(make_strip(strip, Geometry::nonlinear));
    const auto continuum = Eigen::Map<const Vector>(strip.large_loads.data(), loads.size());
    for (Eigen::Index n = 0; n < loads.size(); ++n) {
      // As above, and the contacts stay at the nodes of the mid-surface while the continuum rolls on its skin.
      EXPECT_NEAR(loads[n], continuum[n], 0.015 * continuum[n]) << strip.name << ", bump " << n + 1;
    }
    EXPECT_NEAR(loads.sum(), continuum.sum(), 0.008 * continuum.sum()) << strip.name;
  }
}

/// What large displacements change is seen, and in the right size: with friction a strip of ten is 3.8 % softer.
TEST(FrameStrip, SoftensLikeTheContinuum) {
  for (const Strip& strip : continuum_strips) {
    const double linear = compress(make_strip(strip, Geometry::linear)).sum();
    const double large = compress(make_strip(strip, Geometry::nonlinear)).sum();
    const double softening = 1.0 - large / linear;
    double continuum_linear = 0.0;
    double continuum_large = 0.0;
    for (const double load : strip.loads) continuum_linear += load;
    for (const double load : strip.large_loads) continuum_large += load;
    const double expected = 1.0 - continuum_large / continuum_linear;
    EXPECT_NEAR(softening, expected, 0.25 * expected) << strip.name;  // one element per half bump, as above
  }
}

}  // namespace
}  // namespace bumpfoil
