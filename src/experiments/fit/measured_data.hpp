#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// Values of the model at the points of some data.
struct DataAnswer {
  std::vector<double> fitted;   ///< as read by the rig, SI
  std::vector<double> std;      ///< standard deviation of what was measured
  std::vector<double> weights;  ///< standard deviation of residuals
};

/// Measured data of one kind, and the corresponding model values.
class MeasuredData {
 public:
  MeasuredData() = default;
  MeasuredData(const MeasuredData&) = delete;
  MeasuredData& operator=(const MeasuredData&) = delete;
  virtual ~MeasuredData() = default;

  /// Measured values, without model values: each point is a residual.
  [[nodiscard]] const FittedData& measured() const { return measured_; }

  /// The case under the conditions of these data, with settings of their experiment alone.
  [[nodiscard]] virtual Case case_for(Case input) const = 0;

  /// Absent if a run fails. Thread-safe.
  /// @param input  case_for() with some values   @param rig  with the stiffness of its machine
  /// @throws Error (input) if the case cannot be built
  [[nodiscard]] virtual std::optional<DataAnswer> answer(const Case& input, const Rig& rig) const = 0;

 protected:
  FittedData measured_;
};

/// @param input  the case to which the data belong
std::unique_ptr<const MeasuredData> measured_loop(const FitData& data, const Case& input);
std::unique_ptr<const MeasuredData> measured_vibrations(const FitData& data, const Case& input);
std::unique_ptr<const MeasuredData> measured_equilibria(const FitData& data);

/// Data from a table, without points.
FittedData measured_table(const FitData& data);

/// Adds points of all columns, each with the axis coordinate and the series of its row.
void add_table_points(FittedData& measured, const FitData& data, const std::vector<double>& at,
                      const std::vector<std::string>& series);

/// Load of a row, N; zero in a direction that has no column.
Eigen::Vector2d load_in_row(const FitData& data, std::size_t row);

/// Model values at these points. @param values  of a column in every row
template <typename Values>
DataAnswer table_answer(const FittedData& measured, Values values) {
  DataAnswer all;
  for (const FittedQuantity& quantity : measured.quantities) {
    const std::vector<double> column = values(quantity.column);
    all.fitted.insert(all.fitted.end(), column.begin(), column.end());
    all.std.insert(all.std.end(), column.size(), quantity.noise);
  }
  all.weights = all.std;
  return all;
}

}  // namespace bumpfoil
