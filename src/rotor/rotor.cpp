#include "bumpfoil/rotor/rotor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Frequencies below this fraction of the highest are those of rigid motions.
constexpr double rigid_frequency = 1e-6;

/// The symmetric part of a matrix that is symmetric up to round-off.
Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& A) {
  return 0.5 * (A + A.transpose());
}

/// Squares of natural frequencies, and the modes.
SymmetricModes modes_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass) {
  return symmetric_modes(symmetric_part(stiffness), symmetric_part(mass));
}

/// Stacks matrices of all bearings.
template <typename MatrixOf>
Eigen::MatrixXd stacked(const Rotor& rotor, const MatrixOf& matrix_of) {
  Eigen::MatrixXd all(0, rotor.size());
  for (const RotorStation& bearing : rotor.bearings) {
    const Eigen::MatrixXd one = matrix_of(bearing);
    all.conservativeResize(all.rows() + one.rows(), Eigen::NoChange);
    all.bottomRows(one.rows()) = one;
  }
  return all;
}

}  // namespace

Eigen::Vector2cd RotorStation::orbit(const Eigen::VectorXcd& y) const {
  return motion * y;
}

Eigen::MatrixXd RotorStation::journal() const {
  if (half_width == 0.0) return motion;
  Eigen::MatrixXd B(motion.rows() + tilt.rows(), motion.cols());
  B << motion, half_width * tilt;
  return B;
}

Eigen::MatrixXcd RotorStation::on_rotor(const Eigen::MatrixXcd& of_journal) const {
  const Eigen::MatrixXd B = journal();
  Eigen::MatrixXcd sum(B.cols(), B.cols());
  sum.real() = congruent(of_journal.real(), B);
  sum.imag() = congruent(of_journal.imag(), B);
  return sum;
}

double Rotor::total_mass() const {
  const Eigen::VectorXd momentum = mass * rigid.col(0);
  return rigid.col(0).dot(momentum);
}

Eigen::VectorXd Rotor::inertia_force(const Eigen::Vector2d& acceleration) const {
  const Eigen::VectorXd accelerations = rigid.leftCols(2) * acceleration;
  return mass * accelerations;
}

Rotor make_point_mass(double mass) {
  Rotor rotor;
  rotor.mass = mass * Eigen::Matrix2d::Identity();
  rotor.gyroscopic = rotor.damping = rotor.stiffness = Eigen::Matrix2d::Zero();
  rotor.bearings.push_back(
      {.name = "bearing 1", .z = 0.0, .motion = Eigen::Matrix2d::Identity(), .tilt = Eigen::Matrix2d::Zero()});
  rotor.rigid = Eigen::Matrix2d::Identity();
  return rotor;
}

Rotor make_rigid_rotor(const RigidRotorDesign& design) {
  Rotor rotor;
  rotor.mass =
      Eigen::Vector4d(design.mass, design.mass, design.transverse_inertia, design.transverse_inertia).asDiagonal();
  rotor.gyroscopic = rotor.damping = rotor.stiffness = Eigen::Matrix4d::Zero();
  rotor.gyroscopic(2, 3) = design.polar_inertia;
  rotor.gyroscopic(3, 2) = -design.polar_inertia;
  rotor.rigid = Eigen::Matrix4d::Identity();
  const auto station_at = [](std::string name, double z) {
    Eigen::MatrixXd motion(2, 4);
    motion << Eigen::Matrix2d::Identity(), z * Eigen::Matrix2d::Identity();
    Eigen::MatrixXd tilt(2, 4);
    tilt << Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Identity();
    return RotorStation{.name = std::move(name), .z = z, .motion = motion, .tilt = tilt};
  };
  for (std::size_t i = 0; i < design.bearings.size(); ++i) {
    rotor.bearings.push_back(station_at("bearing " + std::to_string(i + 1), design.bearings[i]));
  }
  for (std::size_t i = 0; i < design.planes.size(); ++i) {
    rotor.stations.push_back(station_at("plane " + std::to_string(i + 1), design.planes[i]));
  }
  return rotor;
}

std::vector<Eigen::Vector2d> weights_on_bearings(const Rotor& rotor, const Eigen::Vector2d& gravity) {
  const Eigen::MatrixXd motions = stacked(rotor, [](const RotorStation& bearing) { return bearing.motion; });
  const Eigen::MatrixXd balance = product(motions, rotor.rigid).transpose();
  BUMPFOIL_ASSERT(balance.rows() == balance.cols());
  const Eigen::VectorXd weight = rotor.rigid.transpose() * rotor.inertia_force(gravity);
  const Eigen::VectorXd forces = solve(balance, weight);
  std::vector<Eigen::Vector2d> loads;
  for (Eigen::Index i = 0; i < forces.size(); i += 2) loads.emplace_back(forces.segment<2>(i));
  return loads;
}

Eigen::VectorXd free_frequencies(const Rotor& rotor) {
  return modes_of(rotor.stiffness, rotor.mass).squares.cwiseMax(0.0).cwiseSqrt();
}

ReducedRotor reduce_rotor(const Rotor& rotor, double range, double kept) {
  // y = lift q + rest r: lift moves the bearings by q, rest does not move them.
  const Eigen::MatrixXd B = stacked(rotor, [](const RotorStation& bearing) { return bearing.journal(); });
  const Eigen::Index n = rotor.size();
  const Eigen::Index held = B.rows();
  if (n == held) return {rotor, 0.0};
  const Eigen::MatrixXd lift = least_squares(B, Eigen::MatrixXd::Identity(held, held));  // the shortest
  const Eigen::MatrixXd rest = null_space(B);
  const Eigen::MatrixXd inner_stiffness = congruent(rotor.stiffness, rest);
  const SymmetricModes modes = modes_of(inner_stiffness, congruent(rotor.mass, rest));
  const double highest = kept * range;
  const Eigen::Index count = std::count_if(modes.squares.begin(), modes.squares.end(),
                                           [&](double square) { return square <= highest * highest; });
  Eigen::MatrixXd T(n, held + count);
  // With the bearings displaced, the other unknowns follow statically.
  const Eigen::MatrixXd pushed = product(transposed_product(rest, rotor.stiffness), lift);
  T.leftCols(held) = lift - product(rest, solve_symmetric(inner_stiffness, pushed));
  T.rightCols(count) = product(rest, modes.shapes.leftCols(count));

  ReducedRotor reduced;
  reduced.rotor.mass = congruent(rotor.mass, T);
  reduced.rotor.gyroscopic = congruent(rotor.gyroscopic, T);
  reduced.rotor.damping = congruent(rotor.damping, T);
  reduced.rotor.stiffness = congruent(rotor.stiffness, T);
  const auto placed = [&](RotorStation station) {
    station.motion = product(station.motion, T);
    if (station.tilt.size() > 0) station.tilt = product(station.tilt, T);
    return station;
  };
  for (const RotorStation& bearing : rotor.bearings) reduced.rotor.bearings.push_back(placed(bearing));
  for (const RotorStation& station : rotor.stations) reduced.rotor.stations.push_back(placed(station));
  // Rigid motions are static responses to bearing motions: T represents them exactly.
  reduced.rotor.rigid = least_squares(T, rotor.rigid);

  const Eigen::VectorXd before = free_frequencies(rotor);
  const Eigen::VectorXd after = free_frequencies(reduced.rotor);
  for (Eigen::Index i = 0; i < after.size() && before[i] <= range; ++i) {
    if (before[i] < rigid_frequency * before[n - 1]) continue;
    reduced.frequency_error = std::max(reduced.frequency_error, std::abs(after[i] / before[i] - 1.0));
  }
  return reduced;
}

}  // namespace bumpfoil
