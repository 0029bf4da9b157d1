#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// A quantity of one vibration.
using VibrationQuantity = Quantity<double (*)(const Vibration&)>;
std::span<const VibrationQuantity> vibration_quantities();

/// A quantity of the foils about one load with one amplitude.
using LinearQuantity = Quantity<double (*)(const LinearFoils&)>;
std::span<const LinearQuantity> linear_quantities();

/// Entry of a matrix, by the name of the coefficient: kxy is dF_x/dy.
struct MatrixEntry {
  std::string_view axes;
  int row, column;
};
inline constexpr std::array<MatrixEntry, 4> matrix_entries{{{"xx", 0, 0}, {"xy", 0, 1}, {"yx", 1, 0}, {"yy", 1, 1}}};

/// Failures of vibrations, each with load, direction and amplitude.
std::vector<std::string> failure_lines(const VibrationSettings& settings, const VibrationResult& result);

/// Limitations of the results, with advice.
std::vector<std::string> warning_lines(const VibrationSettings& settings, const VibrationResult& result);

/// Dimension of the directions of vibrations, or of the senses of orbits.
inline std::string motion_dimension(const VibrationSettings& settings) {
  return settings.orbits() ? "sense" : "direction";
}

/// Indices of a vibration in a result.
struct VibrationPlace {
  std::size_t load, motion, amplitude;  ///< motion: index of the direction, or of the sense
};
VibrationPlace place_of(const VibrationSettings& settings, std::size_t vibration);

/// A vibration in messages: "load (0, -50) N, 90 deg, 2 um".
std::string name_of_vibration(const VibrationSettings& settings, std::size_t vibration);

}  // namespace bumpfoil
