#include <fmt/format.h>

#include "bumpfoil/io/summary.hpp"
#include "bumpfoil/io/vibration_files.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"
#include "io/number_text.hpp"
#include "io/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr int column_width = 12;

std::string cell(const VibrationQuantity& quantity, const Vibration& vibration) {
  const double value = quantity.value(vibration);
  if (!quantity.form.words.empty()) return std::string(quantity.form.words[static_cast<std::size_t>(value)]);
  if (quantity.form.kind == Form::whole) return fmt::format("{}", value);
  return number_text(value, quantity.shown.size);
}

}  // namespace

std::string vibration_table(const Case& input, const VibrationResult& result) {
  const VibrationSettings& settings = *input.vibration;
  std::string names;
  std::string units;
  const auto add = [&](std::string_view name, std::string_view unit) {
    names += fmt::format("{:>{}}", name, column_width);
    units += fmt::format("{:>{}}", unit, column_width);
  };
  add("load X", "N");
  add("load Y", "N");
  add(settings.orbits() ? "sense" : "direction", settings.orbits() ? "" : "deg");
  add("amplitude", "um");
  for (const VibrationQuantity& quantity : vibration_quantities()) {
    if (!quantity.label.empty()) add(quantity.label, quantity.shown.name);
  }
  const std::size_t pads = count_pads(input) > 1 ? count_pads(input) : 0;
  for (std::size_t k = 0; k < pads; ++k) add(fmt::format("pad {}, max", k + 1), "N");
  std::string out = names + '\n' + units + '\n' + std::string(names.size(), '-') + '\n';
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    const auto [load, motion, amplitude] = place_of(settings, i);
    const std::string way =
        settings.orbits() ? motion == 0 ? "ccw" : "cw" : fmt::format("{:.6g}", to_degrees(settings.directions[motion]));
    out += fmt::format("{:>{w}.5g}{:>{w}.5g}{:>{w}}{:>{w}.5g}", settings.loads[load].x(), settings.loads[load].y(), way,
                       1e6 * settings.amplitudes[amplitude], fmt::arg("w", column_width));
    for (const VibrationQuantity& quantity : vibration_quantities()) {
      if (!quantity.label.empty()) out += fmt::format("{:>{}}", cell(quantity, result.vibrations[i]), column_width);
    }
    const Vector forces = largest_pad_forces(result.vibrations[i]);
    for (std::size_t k = 0; k < pads; ++k) {
      const auto pad = static_cast<Eigen::Index>(k);
      out += fmt::format("{:>{}}", pad < forces.size() ? number_text(forces[pad], 1.0) : "-", column_width);
    }
    out += '\n';
  }
  return out;
}

}  // namespace bumpfoil
