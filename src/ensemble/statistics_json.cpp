#include "ensemble/statistics_json.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "results/summary_json.hpp"

namespace bumpfoil {

nlohmann::ordered_json statistics_json(const Statistics& found) {
  nlohmann::ordered_json json{{"count", found.count},
                              {"undefined", found.undefined},
                              {"mean", value_json(found.mean)},
                              {"std", value_json(found.deviation)},
                              {"standard_error", value_json(found.standard_error)},
                              {"mean_interval_95", {value_json(found.mean_low), value_json(found.mean_high)}}};
  for (std::size_t i = 0; i < percentiles.size(); ++i) {
    json[fmt::format("p{}", percentiles[i])] = value_json(found.percentile[i]);
  }
  return json;
}

}  // namespace bumpfoil
