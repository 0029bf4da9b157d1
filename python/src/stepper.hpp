#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <memory>
#include <mutex>
#include <optional>

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A state of the foils as it was reached, with what is known of it. A plain value, never changed.
struct ReachedState {
  BearingState state;
  Increment increment;  ///< place, forces, energies, status
  FoilFields fields;    ///< one row; none of a step that failed
};
using SharedState = std::shared_ptr<const ReachedState>;

/// Where an increment is to lead: one of position (m) and load (N), or neither to stay in place.
struct Destination {
  std::optional<Eigen::Vector2d> position, load;
  std::optional<Vector> top_load;  ///< N, per bump; without it, that of the state before
};

/// The foils of a bearing, taken from state to state. Several threads may call it, one after the other.
class BearingStepper {
 public:
  /// @throws Error (input) if the case cannot be built
  explicit BearingStepper(const Case& input);
  /// Shares the foils.
  BearingStepper(const BearingStepper& other);
  BearingStepper& operator=(const BearingStepper&) = delete;
  ~BearingStepper() = default;

  /// From the unstressed foils in one step. @throws Error (input) for a load, or if the top loads do not fit
  SharedState assemble(const Destination& to);
  /// @throws Error (input) where there is no such increment
  SharedState advance(const ReachedState& from, const Destination& to);
  [[nodiscard]] TangentMatrices tangents(const ReachedState& state);

 private:
  [[nodiscard]] Excitation excitation_of(Excitation excitation, const Destination& to) const;
  [[nodiscard]] SharedState checked();

  SharedBearing foils_;
  SolverSettings settings_;
  FoilStepper stepper_;
  Step step_;
  std::mutex mutex_;
};

/// Adds BearingStepper and ReachedState to the module.
void add_stepper(pybind11::module_& m);

}  // namespace bumpfoil
