#include "experiments/fit/fit_columns.hpp"

#include <algorithm>

namespace bumpfoil {
namespace {

using Experiments = std::array<std::optional<FittedExperiment>, 2>;

constexpr Experiments of_vibrations{FittedExperiment::vibration};
constexpr Experiments of_equilibria{FittedExperiment::equilibrium};
constexpr Experiments of_both{FittedExperiment::vibration, FittedExperiment::equilibrium};

constexpr std::array loop_rig_keys = std::to_array<std::string_view>(
    {"displacement_origin", "force_origin", "displacement_drift", "force_drift", "machine_stiffness"});
constexpr std::array vibration_rig_keys = std::to_array<std::string_view>({"machine_stiffness"});
constexpr std::array equilibrium_rig_keys = std::to_array<std::string_view>({"x_origin", "y_origin", "torque_origin"});

constexpr FitColumnInfo stiffness_of(FitColumn column, std::string_view title, std::string_view std_key,
                                     std::string_view std_title) {
  return {column,
          true,
          of_equilibria,
          Dimension::stiffness,
          title,
          "dynamic, at the frequency of its row",
          "[\"3 MN/m\", \"4 MN/m\"]",
          "MN/m",
          {},
          std_key,
          std_title,
          "0.1 MN/m"};
}

constexpr FitColumnInfo damping_of(FitColumn column, std::string_view title, std::string_view std_key,
                                   std::string_view std_title) {
  return {column,
          true,
          of_equilibria,
          Dimension::damping,
          title,
          "at the frequency of its row",
          "[\"200 N s/m\", \"150 N s/m\"]",
          "N s/m",
          {},
          std_key,
          std_title,
          "10 N s/m"};
}

constexpr std::array table_columns = std::to_array<FitColumnInfo>({
    {FitColumn::amplitude,
     false,
     of_vibrations,
     Dimension::length,
     "Amplitude",
     "of the vibration, to each side",
     "[\"1 um\", \"2 um\"]",
     "um",
     {"amp"}},
    {FitColumn::direction, false, of_vibrations, Dimension::angle, "Direction",
     "of the vibration; default: that of the data", "[\"90 deg\", \"90 deg\"]", "deg"},
    {FitColumn::load_x, false, of_both, Dimension::force, "Load, X", "static load on the journal",
     "[\"50 N\", \"100 N\"]", "N"},
    {FitColumn::load_y, false, of_both, Dimension::force, "Load, Y", "static load on the journal", "[\"0 N\", \"0 N\"]",
     "N"},
    {FitColumn::speed,
     false,
     of_equilibria,
     Dimension::frequency,
     "Speed",
     "of rotation",
     "[\"30000 rpm\", \"45000 rpm\"]",
     "rpm",
     {"n", "Drehzahl"}},
    {FitColumn::frequency, false, of_equilibria, Dimension::frequency, "Frequency",
     "of the small motions that stiffness and damping were measured with; default: that of the rotation",
     "[\"200 Hz\", \"400 Hz\"]", "Hz"},
    {FitColumn::stiffness,
     true,
     of_vibrations,
     Dimension::stiffness,
     "Stiffness",
     "range of the force over that of the displacement",
     "[\"12 MN/m\", \"10 MN/m\"]",
     "MN/m",
     {"loaded_stiffness", "K"},
     "stiffness_std",
     "Noise of the stiffness",
     "0.2 MN/m"},
    {FitColumn::loss_factor,
     true,
     of_vibrations,
     {},
     "Loss factor",
     "loop energy over pi times stiffness times amplitude squared",
     "[0.4, 0.25]",
     "",
     {"eta"},
     "loss_factor_std",
     "Noise of the loss factor",
     "0.02"},
    {FitColumn::h_min,
     true,
     of_equilibria,
     Dimension::length,
     "Minimum film thickness",
     "",
     "[\"12 um\", \"9 um\"]",
     "um",
     {"film_thickness", "minimum_film_thickness"},
     "h_min_std",
     "Noise of the film thickness",
     "0.5 um"},
    {FitColumn::torque,
     true,
     of_equilibria,
     Dimension::moment,
     "Torque",
     "on the journal, against a positive speed",
     "[\"4.6 N mm\", \"5.2 N mm\"]",
     "N mm",
     {"friction_torque", "Reibmoment"},
     "torque_std",
     "Noise of the torque",
     "0.1 N mm"},
    {FitColumn::x,
     true,
     of_equilibria,
     Dimension::length,
     "Journal, X",
     "position of its centre",
     "[\"5 um\", \"20 um\"]",
     "um",
     {},
     "x_std",
     "Noise of the position, X",
     "0.5 um"},
    {FitColumn::y,
     true,
     of_equilibria,
     Dimension::length,
     "Journal, Y",
     "position of its centre",
     "[\"4 um\", \"8 um\"]",
     "um",
     {},
     "y_std",
     "Noise of the position, Y",
     "0.5 um"},
    stiffness_of(FitColumn::kxx, "Stiffness, xx", "kxx_std", "Noise of the stiffness, xx"),
    stiffness_of(FitColumn::kxy, "Stiffness, xy", "kxy_std", "Noise of the stiffness, xy"),
    stiffness_of(FitColumn::kyx, "Stiffness, yx", "kyx_std", "Noise of the stiffness, yx"),
    stiffness_of(FitColumn::kyy, "Stiffness, yy", "kyy_std", "Noise of the stiffness, yy"),
    damping_of(FitColumn::cxx, "Damping, xx", "cxx_std", "Noise of the damping, xx"),
    damping_of(FitColumn::cxy, "Damping, xy", "cxy_std", "Noise of the damping, xy"),
    damping_of(FitColumn::cyx, "Damping, yx", "cyx_std", "Noise of the damping, yx"),
    damping_of(FitColumn::cyy, "Damping, yy", "cyy_std", "Noise of the damping, yy"),
});

const FitColumnInfo* info_of(FitColumn column) {
  const auto* const found = std::find_if(table_columns.begin(), table_columns.end(),
                                         [column](const FitColumnInfo& one) { return one.column == column; });
  return found == table_columns.end() ? nullptr : found;
}

}  // namespace

std::span<const FitColumnInfo> fit_columns() {
  return table_columns;
}

std::string_view title_of(FitColumn column) {
  const FitColumnInfo* const info = info_of(column);
  if (info != nullptr) return info->title;
  return column == FitColumn::force ? "Force" : "Displacement";
}

std::string_view unit_of(FitColumn column) {
  const FitColumnInfo* const info = info_of(column);
  if (info != nullptr) return info->unit();
  return si_unit(column == FitColumn::force ? Dimension::force : Dimension::length);
}

std::vector<FitColumn> fitted_columns(const FitData& data) {
  std::vector<FitColumn> columns;
  for (const FitColumnInfo& info : table_columns) {
    const FitReadings& readings = data.column(info.column);
    if (info.measured && readings.std && !readings.values.empty()) columns.push_back(info.column);
  }
  return columns;
}

std::size_t rows_of(const FitData& data) {
  return data.column(data.experiment == FittedExperiment::vibration ? FitColumn::amplitude : FitColumn::speed)
      .values.size();
}

std::span<const std::string_view> rig_keys_of(FittedExperiment experiment) {
  switch (experiment) {
    case FittedExperiment::vibration:
      return vibration_rig_keys;
    case FittedExperiment::equilibrium:
      return equilibrium_rig_keys;
    default:
      return loop_rig_keys;
  }
}

}  // namespace bumpfoil
