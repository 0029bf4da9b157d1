#pragma once

#include <optional>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Compares states of a bearing with those on another mesh, see estimate_mesh_errors(). Several threads may share it.
class MeshComparison {
 public:
  /// @param bearing  of the case
  MeshComparison(const Case& input, SharedBearing bearing);

  /// @param state  that was found   @return nothing where none is found on the other mesh
  [[nodiscard]] std::optional<MeshError> estimate(const RunningState& state) const;

 private:
  SharedBearing bearing_, other_;
  double part_;             ///< of the difference to the other mesh that the own one is off by; finer: negative
  double thickness_floor_;  ///< over c
};

/// Estimates the discretisation error of the states that were found (RunningState::mesh_error). The scheme is of second
/// order: with q on the mesh of the case and q' on a mesh that is coarser by r in columns and rows, q is off by
///
///     (q' - q) / (r^2 - 1)
///
/// (Richardson). The search on the other mesh starts from the known state, takes a few iterations and stays near it;
/// friction refers to the known state. A mesh that cannot be made coarser (columns_per_pitch = 4, or three rows or
/// less) is compared with a finer one. If no state is found on the other mesh, there is no estimate.
/// @param result  of run_equilibrium() with this case
void estimate_mesh_errors(const Case& input, EquilibriumResult& result);

}  // namespace bumpfoil
