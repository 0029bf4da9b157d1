#include "bumpfoil/rotor/matrices.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bumpfoil/rotor/shaft.hpp"

namespace bumpfoil {
namespace {

std::vector<double> rows_of(const Eigen::MatrixXd& A) {
  std::vector<double> rows;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) rows.push_back(A(i, j));
  }
  return rows;
}

const ShaftDesign shaft{.sections = {{0.08, 0.038, 0.02, 210e9, 0.3, 7800.0}, {0.16, 0.03, 0.0, 210e9, 0.3, 7800.0}},
                        .discs = {{.z = 0.23, .mass = 0.3, .transverse_inertia = 1e-4, .polar_inertia = 2e-4}},
                        .bearings = {0.04, 0.2},
                        .planes = {},
                        .longest_element = 0.02};

/// The index of the unknown that is the displacement of a station along an axis.
int unknown_of(const RotorStation& station, int axis) {
  Eigen::Index number = 0;
  station.motion.row(axis).maxCoeff(&number);
  return static_cast<int>(number);
}

MatrixPlace place_of(const RotorStation& station) {
  return {.name = station.name, .z = station.z, .x = unknown_of(station, 0), .y = unknown_of(station, 1)};
}

RotorMatrices matrices_of(const Rotor& rotor) {
  RotorMatrices matrices{.mass = rows_of(rotor.mass),
                         .damping = rows_of(rotor.damping),
                         .gyroscopic = rows_of(rotor.gyroscopic),
                         .stiffness = rows_of(rotor.stiffness),
                         .bearings = {}};
  for (const RotorStation& bearing : rotor.bearings) matrices.bearings.push_back(place_of(bearing));
  for (const RotorStation& station : rotor.stations) matrices.stations.push_back(place_of(station));
  return matrices;
}

std::vector<std::string> wrong_after(const std::function<void(RotorMatrices&, std::size_t n)>& change) {
  const Rotor rotor = make_flexible_rotor(shaft);
  RotorMatrices matrices = matrices_of(rotor);
  change(matrices, static_cast<std::size_t>(rotor.size()));
  std::vector<std::string> keys;
  for (const InputError& error : find_matrix_errors(matrices)) keys.push_back(error.key);
  return keys;
}

using Keys = std::vector<std::string>;

/// Rigid motions, weights and natural frequencies of a shaft given by its matrices only.
TEST(MakeRotor, OfTheMatricesOfAShaftIsThatShaft) {
  const Rotor expected = make_flexible_rotor(shaft);
  const RotorMatrices matrices = matrices_of(expected);
  ASSERT_TRUE(find_matrix_errors(matrices).empty());
  const Rotor rotor = make_rotor(matrices);
  // Displacements under tilt come from a system with a condition number of 1e6.
  EXPECT_LT((rotor.rigid - expected.rigid).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(rotor.total_mass(), expected.total_mass(), 1e-9 * expected.total_mass());
  const auto loads = weights_on_bearings(rotor, {1.0, -9.81});
  const auto expected_loads = weights_on_bearings(expected, {1.0, -9.81});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT((loads[i] - expected_loads[i]).norm(), 1e-8);
  EXPECT_EQ(rotor.stations.size(), expected.stations.size());
  EXPECT_EQ(rotor.stations[1].name, "disc 1");
  EXPECT_EQ(rotor.stations[1].motion, expected.stations[1].motion);
  const ReducedRotor reduced = reduce_rotor(rotor, 5000.0);
  EXPECT_LT(reduced.rotor.size(), 20);
  EXPECT_LT(reduced.frequency_error, 1e-3);
}

/// Unknowns of any kind in any order: here displacements at both bearings instead of position and tilt.
TEST(MakeRotor, TakesARigidRotor) {
  const Rotor rigid =
      make_rigid_rotor({.mass = 2.0, .transverse_inertia = 4e-3, .polar_inertia = 5e-4, .bearings = {-0.06, 0.07}});
  Eigen::Matrix4d B;
  B << rigid.bearings[0].motion, rigid.bearings[1].motion;
  const Eigen::Matrix4d T = B.inverse();
  RotorMatrices matrices{.mass = rows_of(T.transpose() * rigid.mass * T),
                         .damping = std::vector<double>(16, 0.0),
                         .gyroscopic = rows_of(T.transpose() * rigid.gyroscopic * T),
                         .stiffness = std::vector<double>(16, 0.0),
                         .bearings = {{"a", -0.06, 0, 1}, {"b", 0.07, 2, 3}}};
  for (const InputError& error : find_matrix_errors(matrices)) ADD_FAILURE() << format_error(error);
  const Rotor rotor = make_rotor(matrices);
  EXPECT_LT((rotor.rigid - B).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(rotor.total_mass(), 2.0, 1e-12);
  EXPECT_EQ(reduce_rotor(rotor, 1000.0).rotor.size(), 4);
}

TEST(FindMatrixErrors, NamesWhatIsWrong) {
  EXPECT_EQ(wrong_after([](RotorMatrices&, std::size_t) {}), Keys{});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.mass.pop_back(); }), Keys{"M"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.stiffness.pop_back(); }), Keys{"K"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) {
              m.damping.clear();
              m.gyroscopic.clear();
            }),
            (Keys{"C", "G"}));
  EXPECT_EQ(wrong_after([nan](RotorMatrices& m, std::size_t n) { m.stiffness[2 * n + 3] = nan; }), Keys{"K[3][4]"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t n) { m.mass[n] += 1.0; }), Keys{"M[2][1]"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t n) {
              m.stiffness[4 * n] *= 1.001;
              m.gyroscopic[n + 1] = 1e-3;
            }),
            (Keys{"G[2][2]", "K[5][1]"}));
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.mass[0] = 0.0; }), Keys{"M"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.stiffness[0] *= 0.5; }), Keys{"K"});
  // Springs to ground as stiff as a soft bearing.
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t n) {
              for (std::size_t i = 0; i < n; ++i) m.stiffness[i * n + i] += 1e5;
            }),
            Keys{"K"});
  // That of a rotor turning from Y to X.
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) {
              for (double& one : m.gyroscopic) one = -one;
            }),
            Keys{"G"});
}

TEST(FindMatrixErrors, ChecksPlaces) {
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.bearings.pop_back(); }), Keys{"bearing"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t n) { m.bearings[1].x = static_cast<int>(n); }),
            Keys{"bearing[2].x"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.bearings[1].x = m.bearings[0].x; }),
            Keys{"bearing[2].x"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.stations[0].y = m.stations[0].x; }),
            Keys{"station[1].y"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.stations[1].name = "begin"; }), Keys{"station[2].name"});
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.bearings[1].z = m.bearings[0].z; }),
            Keys{"bearing[2].z"});
  // Positions that do not match their unknowns.
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.stations[1].z += 1e-3; }),
            (Keys{"station[2].x", "station[2].y"}));
  EXPECT_EQ(wrong_after([](RotorMatrices& m, std::size_t) { m.stations[1].x += 4; }), Keys{"station[2].x"});
  // Restraining a rotation instead of a displacement is not a bearing.
  EXPECT_FALSE(wrong_after([](RotorMatrices& m, std::size_t) { m.bearings[1].x += 2; }).empty());
}

}  // namespace
}  // namespace bumpfoil
