#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "bumpfoil/rotor/rotor.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {

/// Positive imaginary parts of all eigenvalues of M y'' + Omega G y' + K y = 0, ascending, rad/s.
inline std::vector<double> whirl_frequencies(const Rotor& rotor, double speed) {
  const Eigen::Index n = rotor.size();
  // In units of the highest frequency: both halves of the matrix then have the same magnitude.
  const Eigen::MatrixXd squares = solve(rotor.mass, rotor.stiffness);
  const double unit = std::sqrt(squares.norm());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  A.topRightCorner(n, n) = unit * Eigen::MatrixXd::Identity(n, n);
  A.bottomLeftCorner(n, n) = -squares / unit;
  A.bottomRightCorner(n, n) = -solve(rotor.mass, Eigen::MatrixXd(speed * rotor.gyroscopic + rotor.damping));
  std::vector<double> frequencies;
  const Eigen::VectorXcd rates = eigenvalues(A).value();
  for (const std::complex<double> s : rates) {
    if (s.imag() > 1e-6) frequencies.push_back(s.imag());
  }
  std::sort(frequencies.begin(), frequencies.end());
  return frequencies;
}

/// The rotor with springs along X and Y (N/m) in place of its bearings.
inline Rotor on_springs(Rotor rotor, double along_x, double along_y) {
  const Eigen::Matrix2d springs = Eigen::Vector2d(along_x, along_y).asDiagonal();
  for (const RotorStation& bearing : rotor.bearings) {
    rotor.stiffness += bearing.motion.transpose() * springs * bearing.motion;
  }
  return rotor;
}

/// The rotor with the unknowns of these indices fixed at zero.
inline Rotor held_at_unknowns(const Rotor& rotor, const std::vector<Eigen::Index>& held) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < rotor.size(); ++i) {
    if (std::find(held.begin(), held.end(), i) == held.end()) free.push_back(i);
  }
  Rotor constrained;
  constrained.mass = rotor.mass(free, free);
  constrained.gyroscopic = rotor.gyroscopic(free, free);
  constrained.damping = rotor.damping(free, free);
  constrained.stiffness = rotor.stiffness(free, free);
  return constrained;
}

}  // namespace bumpfoil
