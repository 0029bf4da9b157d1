#pragma once

#include <optional>

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// A contact that friction wedges.
struct Wedge {
  int contact{};
  double friction{};  ///< coefficient from which on it does, at most that of the contact
};

/// The contact that friction wedges most, if it does.
///
/// With all other contacts closed and stuck, let a contact slide by w. The stiffness of its block resists with T w, and
/// its normal force changes by a w. In the direction in which it decreases, friction takes f |a| w from the resistance:
/// from
///
///     f = T / |a|
///
/// on it falls faster than resistance grows. Increments may then have several solutions or none [Klarbring1990].
/// Bumps that rest on fewer contacts wedge no less: T is smaller then.
///
/// @param problem  with linear elastic forces, or the tangent of others
std::optional<Wedge> strongest_wedge(const ContactProblem& problem);

}  // namespace bumpfoil
