#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/optimise/optimise.hpp"

namespace bumpfoil {

class PointRunner;

/// The evaluation of a point: the case with values of the chosen keys, run by the command of [optimise].
class OptimiseModel {
 public:
  /// @throws Error (input) with every error of aims, limits and starts
  explicit OptimiseModel(const Case& input);
  ~OptimiseModel();

  [[nodiscard]] const OptimiseSettings& settings() const { return settings_; }
  [[nodiscard]] const std::vector<OptimiseAim>& aims() const { return aims_; }
  [[nodiscard]] const std::vector<OptimiseLimit>& limits() const { return limits_; }
  [[nodiscard]] const std::vector<std::string>& key_units() const { return key_units_; }
  /// Start of the searches.
  [[nodiscard]] const std::vector<double>& start() const { return start_; }

  /// The case with these values, without [optimise]. @throws Error (input) if it is invalid
  [[nodiscard]] Case case_with(const std::vector<double>& values) const;

  /// Evaluates a point. Thread-safe. @param warnings  receives those of its run, unless null
  /// @return nothing if `progress` stopped it
  [[nodiscard]] std::optional<OptimisePoint> evaluate(const std::vector<double>& values,
                                                      const ProgressCallback& progress,
                                                      std::vector<std::string>* warnings = nullptr) const;

 private:
  void read_aims(std::vector<InputError>& errors);
  void read_limits(std::vector<InputError>& errors);
  void find_start(const Case& bare, std::vector<InputError>& errors);

  OptimiseSettings settings_;
  std::string text_;  ///< the case without [optimise]
  std::unique_ptr<const PointRunner> runner_;
  std::vector<std::string> key_units_;
  std::vector<OptimiseAim> aims_;
  std::vector<OptimiseLimit> limits_;
  std::vector<double> start_;
};

}  // namespace bumpfoil
