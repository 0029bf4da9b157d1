#pragma once

#include <optional>
#include <string>
#include <vector>

namespace bumpfoil {

/// A key that is chosen between two bounds, SI.
struct OptimisedKey {
  std::string key;
  double lower{};
  double upper{};
  std::optional<double> start{};  ///< absent: what the case holds, or the bound that is nearer to it
  bool log{};                     ///< steps are those of the logarithm

  bool operator==(const OptimisedKey&) const = default;
};

/// Which values of some keys are best.
struct OptimiseSettings {
  static constexpr std::string_view table = "optimise";

  std::string command{"equilibrium"};         ///< run at every point: an experiment that can be swept, or "montecarlo"
  std::vector<std::string> maximise{};        ///< quantities; with those to be minimised one or two
  std::vector<std::string> minimise{};        ///< the same
  std::vector<std::string> limits{};          ///< "h_min > 5 um": what the result must meet
  std::vector<std::string> bearing_limits{};  ///< what a bearing of an ensemble must meet to count in its yield
  int evaluations{120};                       ///< points at most
  int starts{3};                              ///< searches, the first from the starts that are given
  double tolerance{1e-3};                     ///< of the keys, relative to the distance between their bounds
  int front{5};                               ///< points between the ends of the front of two aims
  int seed{1};                                ///< of the places among which further starts are the best
  std::vector<OptimisedKey> keys{};

  [[nodiscard]] bool runs_ensembles() const { return command == "montecarlo"; }
  bool operator==(const OptimiseSettings&) const = default;
};

inline constexpr int most_optimised_keys = 5;

}  // namespace bumpfoil
