#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bumpfoil {

/// A place on the axis of a rotor, and how the rotor moves there.
struct RotorStation {
  std::string name;
  double z{};              ///< along the axis, m
  Eigen::MatrixXd motion;  ///< 2 x n: displacement along X and Y (m) = motion y
  Eigen::MatrixXd tilt{};  ///< 2 x n: inclinations dx/dz and dy/dz of the cross-section (rad) = tilt y
  double half_width{};     ///< of a bearing that resists them by moments, m; 0: it takes forces alone

  /// Amplitudes of the displacements along X and Y, m. @param y  amplitudes of the unknowns of the rotor
  [[nodiscard]] Eigen::Vector2cd orbit(const Eigen::VectorXcd& y) const;
  /// B of a bearing: q = B y with the place q of the journal in it (m, JournalVector): displacements and, where the
  /// bearing resists inclinations, these times half the width.
  [[nodiscard]] Eigen::MatrixXd journal() const;
  /// B^T Z B: what relates forces on the journal to its place q, for the unknowns of the rotor.
  [[nodiscard]] Eigen::MatrixXcd on_rotor(const Eigen::MatrixXcd& of_journal) const;
};

/// A rotor that turns at Omega, as its small motions y(t) about the axis of rotation see it:
///
///     M y'' + (Omega G + C) y' + K y = f(t) - sum B_i^T F_i
///
/// F_i is the force on the journal in bearing i that holds it in equilibrium, so that its film acts with -F_i. Journal
/// i is displaced by B_i y, B_i = bearings[i].journal(). Omega > 0 turns X to Y (docs/theory/conventions.md). M, C and
/// K are symmetric, G is skew. The unknowns are whatever the maker chose. A plain value.
struct Rotor {
  Eigen::MatrixXd mass;        ///< M
  Eigen::MatrixXd gyroscopic;  ///< G
  Eigen::MatrixXd damping;     ///< C: does not turn with the rotor
  Eigen::MatrixXd stiffness;   ///< K
  std::vector<RotorStation> bearings;
  std::vector<RotorStation> stations;  ///< other places: ends, discs, planes of unbalance
  /// y of a rigid motion: columns for displacements along X and Y (m) of the place z = 0, then, where the rotor can
  /// tilt, for the inclinations dx/dz and dy/dz.
  Eigen::MatrixXd rigid;

  [[nodiscard]] Eigen::Index size() const { return mass.rows(); }
  /// Mass in these equations, kg: of a point mass what one bearing carries.
  [[nodiscard]] double total_mass() const;
  /// Force on the unknowns, N, that gives the whole rotor an acceleration along X and Y (m/s^2): of gravity, its
  /// weight.
  [[nodiscard]] Eigen::VectorXd inertia_force(const Eigen::Vector2d& acceleration) const;
};

/// Half of a rotor on two equal bearings that moves without tilting: one of the bearings is computed.
/// @param mass  of the half, kg
Rotor make_point_mass(double mass);

/// A rigid rotor. The places of its bearings and stations are measured from its centre of mass.
struct RigidRotorDesign {
  double mass{};                   ///< kg
  double transverse_inertia{};     ///< about a diameter through the centre of mass, kg m^2
  double polar_inertia{};          ///< about the axis, kg m^2
  std::vector<double> bearings{};  ///< z, m
  std::vector<double> planes{};    ///< z of unbalances, m: its stations
};

/// Its unknowns are (X, Y, dx/dz, dy/dz) of the centre of mass: M = diag(m, m, I_t, I_t),
/// G[dx/dz, dy/dz] = I_p = -G[dy/dz, dx/dz].
Rotor make_rigid_rotor(const RigidRotorDesign& design);

/// Loads on the bearings (N, X and Y, the force that the journal puts on its bearing) by the weight of the rotor.
/// @param gravity  acceleration along X and Y, m/s^2
/// @pre one bearing of a rotor that cannot tilt, or two at different places of one that can: more share the weight by
///      their stiffness
std::vector<Eigen::Vector2d> weights_on_bearings(const Rotor& rotor, const Eigen::Vector2d& gravity);

/// Undamped natural frequencies at rest, rad/s, rising: of the rotor alone, held by nothing.
Eigen::VectorXd free_frequencies(const Rotor& rotor);

/// A rotor with fewer unknowns.
struct ReducedRotor {
  Rotor rotor;
  /// Largest change of a natural frequency of the free rotor within the range, relative; 0 where there is none.
  double frequency_error{};
};

/// Reduces a rotor to the motions of its journals and the modes with these held [Craig1968]: y = T q with q the places
/// of all journals (RotorStation::journal()) and the amplitudes of the modes up to `kept` times the range, at rest.
/// @param range  frequencies of interest end here, rad/s
ReducedRotor reduce_rotor(const Rotor& rotor, double range, double kept = 10.0);

}  // namespace bumpfoil
