#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/vibration/vibration_files.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/number_text.hpp"
#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t vibration_column_width = 12;

std::string cell(const VibrationQuantity& quantity, const Vibration& vibration) {
  const double value = quantity.value(vibration);
  if (!quantity.form.words.empty()) return std::string(quantity.form.words[static_cast<std::size_t>(value)]);
  if (quantity.form.kind == Form::whole) return fmt::format("{}", value);
  return number_text(value, quantity.shown.size);
}

struct Column {
  std::string name;
  std::string_view unit;
  std::vector<std::string> cells;  ///< of the vibrations
};

/// @param cell_of  (vibration, its place) -> text
template <typename CellOf>
Column column_of(const Case& input, const VibrationResult& result, std::string_view name, std::string_view unit,
                 const CellOf& cell_of) {
  Column column{.name = std::string(name), .unit = unit, .cells = {}};
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    column.cells.push_back(cell_of(result.vibrations[i], place_of(*input.vibration, i)));
  }
  return column;
}

std::vector<Column> columns_of(const Case& input, const VibrationResult& result) {
  const VibrationSettings& settings = *input.vibration;
  std::vector<Column> columns;
  const auto add = [&](std::string_view name, std::string_view unit, const auto& cell_of) {
    columns.push_back(column_of(input, result, name, unit, cell_of));
  };
  const auto brief = [](double number) { return fmt::format("{:.5g}", number); };
  add("load X", "N", [&](const Vibration&, const VibrationPlace& at) { return brief(settings.loads[at.load].x()); });
  add("load Y", "N", [&](const Vibration&, const VibrationPlace& at) { return brief(settings.loads[at.load].y()); });
  if (settings.orbits()) {
    add("sense", "",
        [](const Vibration&, const VibrationPlace& at) { return std::string(at.motion == 0 ? "ccw" : "cw"); });
  } else {
    add("direction", "deg", [&](const Vibration&, const VibrationPlace& at) {
      return fmt::format("{:.6g}", to_degrees(settings.directions[at.motion]));
    });
  }
  add("amplitude", "um",
      [&](const Vibration&, const VibrationPlace& at) { return brief(1e6 * settings.amplitudes[at.amplitude]); });
  for (const VibrationQuantity& quantity : vibration_quantities()) {
    if (quantity.label.empty()) continue;
    add(quantity.label, quantity.shown.name,
        [&](const Vibration& vibration, const VibrationPlace&) { return cell(quantity, vibration); });
  }
  const std::size_t pads = count_pads(input) > 1 ? count_pads(input) : 0;
  for (std::size_t k = 0; k < pads; ++k) {
    add(fmt::format("pad {}, max", k + 1), "N", [k](const Vibration& vibration, const VibrationPlace&) {
      const Vector forces = largest_pad_forces(vibration);
      const auto pad = static_cast<Eigen::Index>(k);
      return pad < forces.size() ? number_text(forces[pad], 1.0) : std::string("-");
    });
  }
  return columns;
}

}  // namespace

std::string vibration_table(const Case& input, const VibrationResult& result) {
  const std::vector<Column> columns = columns_of(input, result);
  std::string out;
  for (const Column& column : columns) out += fmt::format("{:>{}}", column.name, vibration_column_width);
  out += '\n';
  for (const Column& column : columns) {
    out += fmt::format("{:>{}}", unit_beside(column.unit, column.cells), vibration_column_width);
  }
  out += '\n' + std::string(columns.size() * vibration_column_width, '-') + '\n';
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    for (const Column& column : columns) out += fmt::format("{:>{}}", column.cells[i], vibration_column_width);
    out += '\n';
  }
  return out;
}

}  // namespace bumpfoil
