#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/optimise/optimise.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "results/quantity_limit.hpp"

namespace bumpfoil {

/// Values of quantities in a run.
struct PointRun {
  RunStatus status{};
  std::vector<double> values{};  ///< of the requested quantities, in order; NaN if absent
  std::vector<std::string> failures{};
  std::vector<std::string> warnings{};
};

/// Runs a case and reads quantities off its result.
class PointRunner {
 public:
  PointRunner() = default;
  PointRunner(const PointRunner&) = delete;
  PointRunner& operator=(const PointRunner&) = delete;
  virtual ~PointRunner() = default;

  /// Names and units of the available quantities.
  [[nodiscard]] virtual std::vector<LimitedQuantity> quantities() const = 0;
  /// Format of a quantity on the terminal; size 0 if it is not shown.
  [[nodiscard]] virtual ShownUnit shown(std::size_t quantity) const = 0;
  /// Thread-safe. @throws Error (input) if the bearing is invalid
  [[nodiscard]] virtual PointRun run(const Case& input, const std::vector<OptimisedQuantity>& wanted,
                                     const ProgressCallback& progress) const = 0;
};

/// The runner of the command of [optimise]. @param errors  receives errors of the limits of bearings
/// @throws Error (input) if the case cannot be built
std::unique_ptr<const PointRunner> make_point_runner(const Case& input, const OptimiseSettings& settings,
                                                     std::vector<InputError>& errors);

}  // namespace bumpfoil
