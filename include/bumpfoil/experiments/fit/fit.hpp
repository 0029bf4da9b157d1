#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

/// What was done to the foils that were measured.
enum class FittedExperiment : std::uint8_t { cycle, strip, vibration, equilibrium };

template <>
inline constexpr auto enum_names<FittedExperiment> = std::to_array<std::string_view>({"cycle", "strip", "vibration",
                                                                                      "equilibrium"});

/// What is measured, and where: a reading of a loop, or a column of a table.
enum class FitColumn : std::uint8_t {
  displacement,
  force,
  amplitude,
  direction,
  load_x,
  load_y,
  speed,
  frequency,
  stiffness,
  loss_factor,
  h_min,
  torque,
  x,
  y,
  kxx,
  kxy,
  kyx,
  kyy,
  cxx,
  cxy,
  cyx,
  cyy,
};

template <>
inline constexpr auto enum_names<FitColumn> = std::to_array<std::string_view>(
    {"displacement", "force",       "amplitude", "direction", "load_x", "load_y", "speed", "frequency",
     "stiffness",    "loss_factor", "h_min",     "torque",    "x",      "y",      "kxx",   "kxy",
     "kyx",          "kyy",         "cxx",       "cxy",       "cyx",    "cyy"});

/// Contacts in small motions of a running bearing.
enum class FittedContacts : std::uint8_t { sliding, stuck };

template <>
inline constexpr auto enum_names<FittedContacts> = std::to_array<std::string_view>({"sliding", "stuck"});

/// How a rig alters what it measures. With the displacement s and the force F of the foils, and the time tau that runs
/// from -1/2 to 1/2 over the loop, it reads
///
///     s + F / machine_stiffness + displacement_origin + displacement_drift tau,   F + force_origin + force_drift tau.
///
/// Of a vibration it reads the stiffness and the amplitude of foils and machine in series; of an equilibrium position
/// and torque from their origins.
struct Rig {
  double displacement_origin{};               ///< m
  double force_origin{};                      ///< N
  double displacement_drift{};                ///< from the start of the loop to its end, m
  double force_drift{};                       ///< N
  double x_origin{}, y_origin{};              ///< m
  double torque_origin{};                     ///< N m
  std::optional<double> machine_stiffness{};  ///< in series with the foils, N/m; absent: that of all, else rigid

  bool operator==(const Rig&) const = default;
};

/// A column of a measured table.
struct FitReadings {
  std::vector<double> values{};  ///< SI, one for each row; none: there is no such column
  std::optional<double> std{};   ///< of one reading

  bool operator==(const FitReadings&) const = default;
};

/// A measured loop, or a table of what was measured of vibrations or of a running bearing.
struct FitData {
  FittedExperiment experiment{FittedExperiment::cycle};
  double direction{};                                ///< of a cycle, or of vibrations without a column of it, rad
  std::optional<PlaneTarget> preload{};              ///< in place of that of the case; of vibrations their load
  FittedContacts contacts{FittedContacts::sliding};  ///< of an equilibrium, in its stiffness and damping
  std::string columns{};                             ///< names of the columns of its file, see parse_column_names()
  std::vector<double> displacements{};               ///< of one cycle, in the order of measurement, m
  std::vector<double> forces{};                      ///< N
  std::optional<double> force_std{};                 ///< of one reading, N; absent: from the scatter of neighbours
  double displacement_std{};                         ///< m
  int points{100};                                   ///< of equal arc length at which residuals are taken
  Rig rig;
  std::array<FitReadings, enum_names<FitColumn>.size()> table{};  ///< of vibrations and equilibria

  bool operator==(const FitData&) const = default;

  [[nodiscard]] bool is_loop() const {
    return experiment == FittedExperiment::cycle || experiment == FittedExperiment::strip;
  }
  [[nodiscard]] FitReadings& column(FitColumn one) { return table.at(static_cast<std::size_t>(one)); }
  [[nodiscard]] const FitReadings& column(FitColumn one) const { return table.at(static_cast<std::size_t>(one)); }
};

/// A key that is fitted: of the case, or of the rig ("fit.data[1].force_origin", "fit.machine_stiffness").
struct FitParameter {
  std::string key;
  double start{};  ///< SI, as all numbers
  double lower{};
  double upper{};
  std::optional<double> mean{};  ///< of what is known of it before
  std::optional<double> std{};

  bool operator==(const FitParameter&) const = default;
};

struct FitSettings {
  static constexpr std::string_view table = "fit";

  std::vector<FitData> data{};
  std::vector<FitParameter> parameters{};
  std::optional<double> machine_stiffness{};  ///< of all data without its own, N/m
  int starts{5};                              ///< minimisations, the first from the starts that are given
  std::optional<double> huber{};              ///< residuals beyond so many standard deviations count linearly
  bool profile{};                             ///< whether profiles of all parameters are computed

  bool operator==(const FitSettings&) const = default;
};

/// The best minimum with a parameter held at a value.
struct FitProfilePoint {
  double value{};
  double cost{};  ///< increase of what is minimised; scaled, so that a linear model has 1 at one standard error
};

/// What was found of a parameter, SI.
struct FittedValue {
  double value{};
  std::optional<double> standard_error{};  ///< absent at a bound and at a jump, and where the data do not determine it
  std::optional<double> lower_95{};
  std::optional<double> upper_95{};
  bool at_bound{};
  bool at_jump{};  ///< beside it the model jumps, as contacts there are others
  /// On request, in rising order of values: three standard errors to both sides, or without one all between the bounds.
  std::vector<FitProfilePoint> profile{};
  /// Where the profile rises by the square of Student's t, as that of a linear model does at the ends of its interval;
  /// absent where it does not on this side.
  std::optional<double> profile_lower_95{};
  std::optional<double> profile_upper_95{};
};

/// A number that was measured, and what the model gives for it. Of a loop: means of the readings in a part of equal arc
/// length.
struct FittedPoint {
  std::size_t quantity{};  ///< among those of its data
  std::size_t series{};    ///< that it belongs to, among those of its data
  double at{};             ///< place along the axis of its data, SI
  double measured{};       ///< SI
  double fitted{};
  double std{};     ///< of what was measured
  int readings{1};  ///< that it is the mean of
};

struct FittedQuantity {
  FitColumn column{};
  double noise{};     ///< standard deviation of one reading: given, or of a loop from the scatter of neighbours, SI
  double residual{};  ///< root mean square of measured minus fitted
};

/// One measurement, with the values of the model.
struct FittedData {
  FittedExperiment experiment{};
  std::string axis{};                 ///< what its curves are drawn over: "displacement"
  std::string axis_unit{};            ///< SI
  std::vector<std::string> series{};  ///< "push" and "pull"; "load (0, -50) N, along 90 deg"
  std::vector<FittedQuantity> quantities{};
  std::vector<FittedPoint> points{};
};

/// Where a minimisation ended.
struct FitMinimum {
  std::vector<double> values;  ///< of the parameters, SI
  double cost{};               ///< what was minimised: squares of residuals in standard deviations
};

struct FitResult {
  FitSettings settings;
  std::vector<std::string> units;  ///< of the parameters
  Status status{Status::converged};
  std::vector<FittedValue> parameters;
  Eigen::MatrixXd correlation;  ///< not a number where a standard error is absent
  double chi_square{};          ///< squares of measured minus fitted over their standard deviations, priors included
  int degrees_of_freedom{};
  /// Of the sensitivities of the data, each parameter's scaled to length 1: 1 / smallest singular value [Brun2001].
  double collinearity{};
  std::vector<std::string> directions;  ///< what the data hardly determine, in words
  std::vector<FitMinimum> minima;       ///< that differ, the best first
  std::vector<FittedData> data;
  std::size_t runs{};  ///< evaluations of the model
  Case fitted;         ///< the case with these values, without [fit]

  [[nodiscard]] double reduced_chi_square() const { return chi_square / degrees_of_freedom; }
};

/// Finds parameters of a case by bounded least squares from measured loops and tables, from several starts.
///
/// Standard errors are those of linearised least squares, from the noise of the readings; where the residuals are
/// larger than that noise (chi-square per degree of freedom above 1), larger by its root. Intervals are those of
/// Student's t.
/// @throws Error (input) if the case has no fit, or cannot be run at the starts that are given
FitResult run_fit(const Case& input, const ProgressCallback& progress = {});

}  // namespace bumpfoil
