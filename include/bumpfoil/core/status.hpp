#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bumpfoil/core/enum_names.hpp"

namespace bumpfoil {

/// How a solve, an increment or a run of increments ended: the same in memory, in result files, on the terminal and in
/// the report.
enum class Status : std::uint8_t {
  converged,             ///< the state obeys every equation and inequality within the bounds of its solver
  no_modes,              ///< no combination of contact modes was found whose exact solution satisfies all inequalities
  no_tangent,            ///< large displacements: no tangents led to elastic forces that balance the contact forces
  iterations_spent,      ///< `uzawa`: a loop ended before its residual had fallen to its tolerance
  energy_defect,         ///< `events`: a part of the path that had to be taken blindly breaks W = E - E0 + D
  residual_above_bound,  ///< the solver called the state converged, but ContactResiduals exceeds its bounds
  load_out_of_reach,     ///< the load is not met before the journal (or plate) has reached its limit
  load_not_met,          ///< the load was bracketed, but the search ended before it was met
  interrupted,           ///< the run was stopped from outside
  unstable,              ///< under load control: the tangent stiffness with sliding contacts is not positive: unstable
  not_unique,            ///< under load control: that tangent stiffness vanishes; other positions meet the load too
  not_converged,         ///< of a film: the iterations were spent, or the equations became singular
  touchdown,             ///< converged, but the film is thinner than it may be somewhere
  no_room,               ///< the undeformed gap is closed somewhere at the start
  fold,                  ///< of a path: the branch of states ends, and the film settles to no other state from there
  not_reached,           ///< of a path: an earlier state was not found
};

/// As files spell it.
template <>
inline constexpr auto enum_names<Status> = std::to_array<std::string_view>(
    {"converged", "no_modes", "no_tangent", "iterations_spent", "energy_defect", "residual_above_bound",
     "load_out_of_reach", "load_not_met", "interrupted", "unstable", "not_unique", "not_converged", "touchdown",
     "no_room", "fold", "not_reached"});

/// Foils without a film have the statuses before this one, with their own numbers in files.
inline constexpr auto foil_statuses = static_cast<std::size_t>(Status::not_converged);

/// Those of running bearings, in the order of their numbers in files.
inline constexpr std::array running_statuses{Status::converged,  Status::not_converged, Status::touchdown,
                                             Status::no_room,    Status::fold,          Status::not_reached,
                                             Status::interrupted};

/// What happened, in words that complete "increment 37: ...".
std::string_view explanation(Status status);

}  // namespace bumpfoil
