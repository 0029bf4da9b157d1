#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "case/units.hpp"

namespace bumpfoil {

/// A column of measured tables, described once: for case files, CSV files and results.
struct FitColumnInfo {
  FitColumn column{};
  bool measured{};  ///< otherwise a coordinate of the measurement
  std::array<std::optional<FittedExperiment>, 2> experiments{};
  std::optional<Dimension> dimension{};  ///< absent for plain numbers
  std::string_view title{}, text{};
  std::string_view example{};                     ///< two readings, in a case file
  std::string_view csv_unit{};                    ///< in advice on column names
  std::array<std::string_view, 3> other_names{};  ///< in CSV files, besides that of the column
  std::string_view std_key{}, std_title{}, std_example{};

  [[nodiscard]] std::string_view name() const { return name_of(column); }
  [[nodiscard]] std::string_view unit() const { return dimension ? si_unit(*dimension) : "1"; }
  [[nodiscard]] bool is_of(FittedExperiment experiment) const {
    return experiments[0] == experiment || experiments[1] == experiment;
  }
};

/// All columns of tables, coordinates first.
std::span<const FitColumnInfo> fit_columns();

/// Name in results: "stiffness", "minimum film thickness".
std::string_view title_of(FitColumn column);

/// SI; "1" for a plain number.
std::string_view unit_of(FitColumn column);

/// Fitted columns of the data: measured, with a standard deviation.
std::vector<FitColumn> fitted_columns(const FitData& data);

/// Number of rows of a table.
std::size_t rows_of(const FitData& data);

/// Rig keys that apply to data of an experiment.
std::span<const std::string_view> rig_keys_of(FittedExperiment experiment);

}  // namespace bumpfoil
