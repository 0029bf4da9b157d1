#pragma once

#include <optional>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/analysis/foil_model.hpp"

namespace bumpfoil {

/// Displacement (m) at which the direct force first rises through `threshold` (N) on the loading branch, linear between
/// increments; 0 if it lies above from the start, absent if it never gets there.
std::optional<double> clearance_at(const std::vector<Increment>& increments, double threshold);

/// Displacement (m) along the unit vector `direction` at which the journal first touches the top foil,
/// (C_r + u_t,i) / (n_i . n) smallest over the bumps that face the direction n, with the displacements u_t of the
/// top foil at the centred journal and C_r the `clearance`; 0 if it touches already, absent if no bump faces the
/// direction.
std::optional<double> first_contact_displacement(double clearance, const Eigen::Matrix2Xd& normals,
                                                 const Vector& top_displacement, const Eigen::Vector2d& direction);

/// Loop energy over 2 pi times the elastic energy stored between start and turning point; absent if none was stored.
std::optional<double> loss_factor(double loop_energy, double elastic_energy_stored);

/// Tangent stiffnesses at a state, from the modes of its contacts and the tangent of the foils.
/// @param state      converged; its modes count, and under large displacements its unknowns
/// @param direction  unit vector n of the journal's motion
TangentStiffnesses tangent_stiffnesses(const FoilModel& model, const ContactState& state,
                                       const Eigen::Vector2d& direction);

/// Largest stress of the top foil over all increments; absent where none is known.
std::optional<StressPeak> top_foil_peak(const std::vector<Increment>& increments);

/// The same of the bump foil.
std::optional<StressPeak> bump_foil_peak(const std::vector<Increment>& increments);

/// Fills in what follows from the increments of a cycle, as far as they got: whether it converged, clearances, turning
/// point, loop energy, loss factor and largest stresses.
/// @param tangents  at the turning point; absent if it was not reached
void derive_quantities(Cycle& cycle, const std::optional<TangentStiffnesses>& tangents);

}  // namespace bumpfoil
