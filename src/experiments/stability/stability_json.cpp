#include "experiments/stability/stability_json.hpp"

#include "bumpfoil/results/quantity.hpp"
#include "experiments/stability/stability_quantities.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json motion_json(const SpeedMotion& motion) {
  Json json;
  for (const MotionQuantity& quantity : motion_quantities()) {
    if (quantity.name == "speed" || quantity.name == "status") continue;  // given once for all motions
    json[quantity.key()] = value_json(quantity.value(motion), quantity.form);
  }
  return json;
}

}  // namespace

Json stability_lists(const StabilityResult& result) {
  Json json;
  for (const StabilityQuantity& quantity : stability_quantities()) {
    if (quantity.name != "status") json[quantity.key()] = value_json(quantity.value(result), quantity.form);
  }
  json["onsets"] = Json::array();
  for (const WhirlOnset& found : result.map.onsets) {
    json["onsets"].push_back({{"speed_rad_per_s", found.onset.speed},
                              {"whirl_ratio", found.onset.whirl_ratio},
                              {"contacts", name_of(found.stuck ? ContactMotion::stuck : ContactMotion::sliding)},
                              {"by_coefficients", found.by_coefficients},
                              {"begins", found.begins},
                              {"of_foils", found.of_foils},
                              {"jumps", found.onset.jumps}});
  }
  json["speeds"] = Json::array();
  for (const SpeedPoint& point : result.map.points) {
    Json& entry = json["speeds"].emplace_back(Json{{"speed_rad_per_s", point.speed}});
    for (const SpeedQuantity& quantity : speed_quantities()) {
      const bool is_status = quantity.name == "speed_status";
      entry[is_status ? "status" : quantity.key()] = value_json(quantity.value(result, point), quantity.form);
    }
    entry["motions"] = each(motions_at(point), motion_json);
  }
  return json;
}

}  // namespace bumpfoil
