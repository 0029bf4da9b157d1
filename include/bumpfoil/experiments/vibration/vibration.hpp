#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/first_harmonic.hpp"
#include "bumpfoil/experiments/vibration/vibration_settings.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

/// A static load that the journal vibrates about, reached by one ramp from the unstressed foils.
struct StaticLoad {
  Eigen::Vector2d load{0.0, 0.0};      ///< N
  Status status{Status::converged};    ///< of the way there; `interrupted` where it was not begun
  Eigen::Vector2d position{0.0, 0.0};  ///< of the journal, m; zero where the load was not reached
  TangentMatrices tangents;            ///< there
  Eigen::Matrix2Xd pad_forces{};       ///< what each of several pads takes of the load, N; empty where not reached
};

/// One vibration: about one load, in one direction or one sense, with one amplitude.
struct Vibration {
  Cycle cycle;  ///< the last, with its curve, that of an orbit along X; where there was none its status says why
  std::optional<Sense> sense{};             ///< of an orbit, which has no direction
  std::optional<FirstHarmonic> harmonic{};  ///< of a whole loop
};

/// Largest size of the force that each of several pads takes in the loop, N; nothing without one.
Vector largest_pad_forces(const Vibration& vibration);

struct VibrationResult {
  std::vector<StaticLoad> loads;
  /// About each load, in each direction or sense, with each amplitude: that of the settings, the last running fastest.
  std::vector<Vibration> vibrations;

  [[nodiscard]] bool converged() const;
};

/// Vibrations about the loads of a case. About each load every vibration begins with a copy of the state there, and is
/// repeated until its loop energy changes by less than 1e-6, at most `most_vibration_loops` times. Numerical failures
/// are reported in the result: loads and vibrations beside them are not touched. An orbit has four times `steps`
/// increments, and begins with a straight way of `steps` to its first point on the side of +X.
/// @throws Error (input) if the case cannot be built, or has no vibration.
VibrationResult run_vibration(const Case& input, const ProgressCallback& progress = {});

/// Loops of one vibration at most.
inline constexpr int most_vibration_loops = 100;

/// Linear foils with the same first harmonics as the vibrations about one load with one amplitude: dF = K dx +
/// (H/omega) d(dx)/dt with the applied force F, so that K_ij = dF_i/dx_j. Entries that no vibration determines are NaN:
/// two directions at right angles determine all, as do two orbits of both senses; one direction along an axis
/// determines its column.
struct LinearFoils {
  Eigen::Vector2d load{0.0, 0.0};  ///< N
  double amplitude{};              ///< m
  Eigen::Matrix2d stiffness;       ///< K, N/m
  Eigen::Matrix2d loss;            ///< H = omega c, N/m
  double residual{};               ///< the larger one of the directions, see FirstHarmonic
  Eigen::Vector2d loss_factor;     ///< of a vibration along X and of one along Y, see Cycle

  /// c, N s/m, at `frequency` (rad/s).
  [[nodiscard]] Eigen::Matrix2d damping(double frequency) const { return loss / frequency; }
};

/// About each load with each amplitude, the last running fastest.
std::vector<LinearFoils> linear_foils(const VibrationSettings& vibration, const VibrationResult& result);

}  // namespace bumpfoil
