#include "io/equilibrium_json.hpp"

#include <string>

#include "bumpfoil/io/equilibrium_quantities.hpp"
#include "io/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Quantities that were found out of a state, whether it is the one that was asked for or not.
Json found_json(const FilmBearing& bearing, const RunningState& state) {
  Json json;
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    if (quantity.asked) continue;
    json[key_of(quantity.name, quantity.unit)] = value_json(quantity.value(bearing, state), quantity.form);
  }
  return json;
}

}  // namespace

Json state_json(const FilmBearing& bearing, const RunningState& state) {
  Json json;
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    json[key_of(quantity.name, quantity.unit)] = value_json(value_of(quantity, bearing, state), quantity.form);
  }
  const std::string failure = running_failure(bearing, state);
  json["reason"] = failure.empty() ? Json() : Json(failure);
  json["last_state"] = Json();
  if (!state.found() && state.outcome) {
    json["last_state"] = found_json(bearing, state);
    json["last_state"]["speed_rad_per_s"] = state.last->speed;
  }
  return json;
}

}  // namespace bumpfoil
