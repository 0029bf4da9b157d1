#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "experiments/fit/measured_data.hpp"

namespace bumpfoil {

/// Predicted readings of a rig, for values of its parameters and those of the case. The journal (or plate) of a loop
/// moves until the rig reads the largest measured displacement; a fully reversed loop, to half the range on both sides.
class FitModel {
 public:
  /// @pre  the case has a fit without errors
  explicit FitModel(const Case& input);

  [[nodiscard]] const FitSettings& settings() const { return settings_; }
  [[nodiscard]] const std::vector<std::unique_ptr<const MeasuredData>>& data() const { return data_; }

  /// One for each data set; absent if the case cannot be built with these values, or a run fails. Thread-safe. @param
  /// values  of the parameters, SI
  [[nodiscard]] std::optional<std::vector<DataAnswer>> answers(const std::vector<double>& values) const;

  /// The case with these values, without its fit.
  /// @throws Error (input) if it cannot be built
  [[nodiscard]] Case case_with(const std::vector<double>& values) const;

  /// The case of data set `i`. @throws Error (input) if it cannot be built
  [[nodiscard]] Case case_of_data(std::size_t i, const std::vector<double>& values) const;

 private:
  [[nodiscard]] std::vector<std::string> overrides(const std::vector<double>& values) const;

  FitSettings settings_;
  std::vector<std::unique_ptr<const MeasuredData>> data_;
  std::string text_;                ///< the case without its fit
  std::vector<std::string> texts_;  ///< the same with the conditions of each data set
};

}  // namespace bumpfoil
