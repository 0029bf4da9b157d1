#include "readers/result_kinds.hpp"

#include <algorithm>

#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

bool is_known(std::string_view kind) {
  const auto& known = experiments();
  return has_axes(kind) || has_distributions(kind) ||
         std::any_of(known.begin(), known.end(), [&](const ExperimentInfo& info) { return info.name == kind; });
}

bool has_cycles(std::string_view kind) {
  return kind == "cycle" || kind == "strip";
}

bool has_distributions(std::string_view kind) {
  return kind == "montecarlo";
}

bool has_axes(std::string_view kind) {
  return kind == "sweep";
}

bool has_states(std::string_view kind) {
  return kind == "equilibrium" || kind == "film";
}

bool has_onsets(std::string_view kind) {
  return kind == "stability";
}

bool has_peaks(std::string_view kind) {
  return kind == "unbalance";
}

bool has_parameters(std::string_view kind) {
  return kind == "fit";
}

bool has_points(std::string_view kind) {
  return kind == "optimise";
}

bool has_revolutions(std::string_view kind) {
  return kind == "transient";
}

}  // namespace bumpfoil
