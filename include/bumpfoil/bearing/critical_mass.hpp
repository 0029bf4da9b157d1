#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace bumpfoil {

/// A rigid rotor on two equal bearings that neither decays nor grows: m y'' + Z y = 0 per bearing for y ~ e^{i nu t}.
struct CriticalMass {
  double mass{};       ///< m, per bearing, kg
  double frequency{};  ///< nu, rad/s
};

/// All of them between two frequencies (rad/s, positive): where an eigenvalue lambda of Z(i nu) is real and positive,
/// m = lambda / nu^2 [Lund1968]. Both eigenvalues are followed over nu, and each change of sign of an imaginary part is
/// refined to 1e-11 of the higher frequency. Sorted by mass.
///
/// A rotor below the smallest one does not whirl, provided that film and foils stay at the state with the journal held:
/// with a pole of Z in the right half-plane these masses are meaningless.
/// @param impedance  Z(i nu) = dF/d(x, y), N/m, at any frequency in between
std::vector<CriticalMass> critical_masses(const std::function<Eigen::Matrix2cd(double)>& impedance, double lowest,
                                          double highest);

}  // namespace bumpfoil
