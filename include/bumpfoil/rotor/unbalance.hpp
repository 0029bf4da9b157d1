#pragma once

#include <Eigen/Core>

#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// Mass times distance from the axis, in a plane of a rotor.
struct Unbalance {
  double amount{};  ///< U, kg m
  double phase{};   ///< delta, of the heavy place from X towards Y when the rotor stands at angle 0, rad
};

/// The largest unbalance that a balance quality grade allows a rotor [Iso2016]: U = G m / |Omega|, with the grade
/// G = e |Omega|, e the displacement of the centre of mass.
/// @param grade  m/s: 2.5e-3 for G 2.5
/// @param speed  Omega at which the rotor runs, rad/s
/// @return kg m
double unbalance_of_grade(double grade, double mass, double speed);

/// Force of an unbalance in the plane of a station,
///
///     f = U Omega^2 motion^T (cos a, sin a) = Re(F e^{i |Omega| t}),   a = Omega t + delta
///
/// @param speed  Omega, rad/s
/// @return F, N, on the unknowns of the rotor
Eigen::VectorXcd unbalance_force(const RotorStation& plane, const Unbalance& unbalance, double speed);

/// The same at an instant of a rotor whose speed changes,
///
///     f = U motion^T (Omega^2 cos a + Omega' sin a, Omega^2 sin a - Omega' cos a),   a = angle + delta
///
/// @param angle         through which the rotor has turned, rad
/// @param speed         Omega, rad/s
/// @param acceleration  Omega', rad/s^2
/// @return N, on the unknowns of the rotor
Eigen::VectorXd unbalance_force(const RotorStation& plane, const Unbalance& unbalance, double angle, double speed,
                                double acceleration);

}  // namespace bumpfoil
