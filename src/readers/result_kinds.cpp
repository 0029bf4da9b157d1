#include "readers/result_kinds.hpp"

namespace bumpfoil {

bool is_shown(std::string_view kind) {
  return has_cycles(kind) || has_distributions(kind) || has_states(kind) || has_onsets(kind) || has_peaks(kind) ||
         has_revolutions(kind) || has_parameters(kind) || has_points(kind) || kind == "path" || kind == "sweep" ||
         kind == "vibration";
}

bool has_cycles(std::string_view kind) {
  return kind == "cycle" || kind == "strip";
}

bool has_distributions(std::string_view kind) {
  return kind == "montecarlo";
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
