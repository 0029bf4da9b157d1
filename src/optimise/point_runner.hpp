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
  std::vector<double> values{};  ///< of the quantities that were asked for, in their order; not a number where absent
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

  /// Names and units of quantities that there are.
  [[nodiscard]] virtual std::vector<LimitedQuantity> quantities() const = 0;
  /// How the terminal shows one of them; a size of 0 where it does not.
  [[nodiscard]] virtual ShownUnit shown(std::size_t quantity) const = 0;
  /// For several threads at once. @throws Error (input) if there is no such bearing
  [[nodiscard]] virtual PointRun run(const Case& input, const std::vector<OptimisedQuantity>& wanted,
                                     const ProgressCallback& progress) const = 0;
};

/// The runner of the command of [optimise]. @param faults  receives those of the limits of bearings
/// @throws Error (input) if the case cannot be built
std::unique_ptr<const PointRunner> make_point_runner(const Case& input, const OptimiseSettings& settings,
                                                     std::vector<Fault>& faults);

}  // namespace bumpfoil
