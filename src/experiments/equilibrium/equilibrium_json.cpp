#include "experiments/equilibrium/equilibrium_json.hpp"

#include <string>

#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Part of the force carried by each of several pads; null if unknown.
void add_pad_forces(Json& json, const BearingModel& bearing, const RunningState& state, bool known) {
  if (bearing.film->pads.size() == 1) return;
  for (const int axis : {0, 1}) {
    Json& forces = json[axis == 0 ? "pad_forces_x_N" : "pad_forces_y_N"];
    for (Eigen::Index k = 0; k < std::ssize(bearing.film->pads); ++k) {
      forces.push_back(known ? Json(state.outcome->pad_forces(axis, k)) : Json());
    }
  }
}

/// Stiffness and damping at each frequency.
void add_motions(Json& json, const BearingModel& bearing, const RunningState& state) {
  json["motions"] = Json::array();
  for (const FilmWhirl& whirl : state.found() ? state.whirls : std::vector<FilmWhirl>{}) {
    Json& motion = json["motions"].emplace_back(Json{{"frequency_rad_per_s", whirl.frequency}});
    for (const WhirlQuantity& quantity : whirl_quantities(bearing.film->motions())) {
      motion[key_of(quantity.name(), quantity.unit)] = value_json(quantity.value(whirl), {});
    }
  }
}

/// Quantities found for a state, even if it is not the requested one.
Json found_json(const BearingModel& bearing, const RunningState& state) {
  Json json;
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    if (quantity.is(tag::requested)) continue;
    json[quantity.key()] = value_json(quantity.value(bearing, state), quantity.form);
  }
  add_pad_forces(json, bearing, state, true);
  return json;
}

}  // namespace

Json state_json(const BearingModel& bearing, const RunningState& state) {
  Json json;
  json["name"] = name_of_state(state);
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    json[quantity.key()] = value_json(value_of(quantity, bearing, state), quantity.form);
  }
  add_pad_forces(json, bearing, state, state.found());
  if (bearing.bumps() > 0) add_motions(json, bearing, state);
  const std::string failure = running_failure(bearing, state);
  json["reason"] = failure.empty() ? Json() : Json(failure);
  json["last_state"] = Json();
  if (!state.found() && state.outcome) {
    json["last_state"] = found_json(bearing, state);
    json["last_state"]["speed_rad_per_s"] = state.last->speed;
    json["last_state"]["radial_clearance_m"] = bearing.clearance + state.last->clearance_offset;
  }
  return json;
}

Json limit_json(const FilmLimit& limit) {
  const auto point_json = [](const OperatingPoint& point, double h) {
    return Json{{"speed_rad_per_s", point.speed},
                {"load_x_N", point.journal.x()},
                {"load_y_N", point.journal.y()},
                {"h_min_m", value_json(h, {})}};
  };
  const std::string key = limit.kind == FilmLimitKind::lift_off_speed ? "speed_rad_per_s" : "load_N";
  Json unstable = Json::array();
  for (const auto& [from, to] : limit.unstable) unstable.push_back({{"from_" + key, from}, {"to_" + key, to}});
  return {{"kind", name_of(limit.kind)},
          {"status", name_of(limit.status)},
          {key, value_json(limit.value, {})},
          {"bounded_by", limit.found() ? Json(name_of(limit.bounded_by)) : Json()},
          {"jumps", limit.jumps},
          {"stable", limit.stable ? Json(*limit.stable) : Json()},
          {"unstable", unstable},
          {"unknown", limit.unknown},
          {"thick", point_json(limit.thick, limit.h_thick)},
          {"thin", point_json(limit.thin, limit.h_thin)}};
}

}  // namespace bumpfoil
