#include "experiments/vibration/vibration_csv.hpp"

#include <fmt/format.h>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "results/csv_value.hpp"

namespace bumpfoil {

std::string vibration_csv(const VibrationSettings& settings, const VibrationResult& result) {
  std::string out = fmt::format("load_x_N,load_y_N,{},amplitude_m", motion_key(settings));
  for (const VibrationQuantity& column : vibration_quantities()) out += ',' + column.key();
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    const auto [load, motion, amplitude] = place_of(settings, i);
    out += fmt::format("\n{:.17g},{:.17g},", settings.loads[load].x(), settings.loads[load].y());
    if (settings.orbits()) {
      out += name_of(static_cast<Sense>(motion));
    } else {
      append_csv(out, to_degrees(settings.directions[motion]));
    }
    append_csv(out += ',', settings.amplitudes[amplitude]);
    for (const VibrationQuantity& column : vibration_quantities()) {
      append_csv(out += ',', column.value(result.vibrations[i]), column.form);
    }
  }
  return out + '\n';
}

std::string coefficients_csv(const VibrationSettings& settings, const std::vector<LinearFoils>& all) {
  std::string out = "load_x_N,load_y_N,amplitude_m,frequency_rad_per_s";
  for (const MatrixEntry& entry : matrix_entries) out += fmt::format(",k{}_N_per_m", entry.axes);
  for (const MatrixEntry& entry : matrix_entries) out += fmt::format(",c{}_N_s_per_m", entry.axes);
  for (const LinearQuantity& column : linear_quantities()) out += ',' + column.key();
  for (const LinearFoils& foils : all) {
    for (const double frequency : settings.frequencies) {
      out +=
          fmt::format("\n{:.17g},{:.17g},{:.17g},{:.17g}", foils.load.x(), foils.load.y(), foils.amplitude, frequency);
      for (const Eigen::Matrix2d& matrix : {foils.stiffness, foils.damping(frequency)}) {
        for (const auto& [axes, row, column] : matrix_entries) append_csv(out += ',', matrix(row, column));
      }
      for (const LinearQuantity& column : linear_quantities()) append_csv(out += ',', column.value(foils));
    }
  }
  return out + '\n';
}

}  // namespace bumpfoil
