#include <algorithm>

#include "bumpfoil/results/quantity.hpp"
#include "experiments/fit/fit_columns.hpp"
#include "experiments/fit/measured_data.hpp"

namespace bumpfoil {

FittedData measured_table(const FitData& data) {
  FittedData measured{.experiment = data.experiment};
  for (const FitColumn column : fitted_columns(data)) {
    measured.quantities.push_back({.column = column, .noise = *data.column(column).std});
  }
  return measured;
}

void add_table_points(FittedData& measured, const FitData& data, const std::vector<double>& at,
                      const std::vector<std::string>& series) {
  for (const std::string& name : series) {
    if (std::find(measured.series.begin(), measured.series.end(), name) == measured.series.end()) {
      measured.series.push_back(name);
    }
  }
  for (std::size_t q = 0; q < measured.quantities.size(); ++q) {
    const std::vector<double>& values = data.column(measured.quantities[q].column).values;
    for (std::size_t row = 0; row < values.size(); ++row) {
      const auto place = std::find(measured.series.begin(), measured.series.end(), series[row]);
      measured.points.push_back({.quantity = q,
                                 .series = static_cast<std::size_t>(place - measured.series.begin()),
                                 .at = at[row],
                                 .measured = values[row],
                                 .fitted = absent,
                                 .std = measured.quantities[q].noise});
    }
  }
}

Eigen::Vector2d load_in_row(const FitData& data, std::size_t row) {
  const auto along = [&data, row](FitColumn column) {
    const std::vector<double>& values = data.column(column).values;
    return values.empty() ? 0.0 : values[row];
  };
  return {along(FitColumn::load_x), along(FitColumn::load_y)};
}

}  // namespace bumpfoil
