#include "experiments/stability/stability_json.hpp"

#include <iterator>
#include <utility>
#include <vector>

#include "bumpfoil/results/quantity.hpp"
#include "experiments/stability/stability_dataset.hpp"
#include "experiments/stability/stability_quantities.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
using Json = nlohmann::ordered_json;

Json stability_lists(const StabilityResult& result) {
  const Dataset data = stability_dataset(result);
  Json json = rows_json(table_of(data, {.columns = names_of(stability_quantities().subspan(1))})).front();
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
  std::vector<Json> speeds =
      rows_json(table_of(data, {.over = {"speed"}, .columns = names_of(speed_quantities(), {"speed"})}));
  const std::vector<Json> motions = rows_json(
      table_of(data, {.over = motion_dimensions(), .columns = motion_columns(), .rows = motion_rows(result, false)}));
  auto motion = motions.begin();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const auto last = motion + std::ssize(motions_at(result.map.points[i]));
    speeds[i]["motions"] = std::vector<Json>(motion, last);
    motion = last;
  }
  json["speeds"] = std::move(speeds);
  return json;
}

}  // namespace bumpfoil
