#include <utility>

#include "bumpfoil/results/quantity.hpp"
#include "experiments/unbalance/unbalance_quantities.hpp"

namespace bumpfoil {
namespace {

void add_points(const UnbalanceResult& result, Dataset& data) {
  add_speeds(each(result.points, [](const UnbalancePoint& point) { return point.speed; }), data);
  for (const PointQuantity& quantity : point_quantities()) {
    if (quantity.is(tag::of_orbits) && !result.with_orbits) continue;
    data.add(quantity.meaning(), {"speed"},
             each(result.points, [&](const UnbalancePoint& point) { return quantity.value(result, point); }));
  }
  if (result.with_orbits) {
    for (const OrbitQuantity& quantity : orbit_quantities()) {
      data.add(quantity.meaning(), {"speed"}, each(result.points, [&quantity](const UnbalancePoint& point) {
                 return point.orbit ? quantity.value(*point.orbit) : absent;
               }));
    }
  }
  add_journals(result.points, result.machine, data);
}

}  // namespace

Dataset unbalance_dataset(const UnbalanceResult& result, bool with_responses) {
  Dataset data;
  for (const UnbalanceQuantity& quantity : unbalance_quantities()) {
    if (quantity.is(tag::of_orbits) && !result.with_orbits) continue;
    data.add(quantity.meaning(), {}, std::vector<double>{quantity.value(result)});
  }
  add_points(result, data);
  if (!with_responses) return data;
  const std::vector<RotorStation> stations = result.machine.places();
  const std::span<const ResponseKind> kinds = kinds_of(result);
  data.add_dimension({"kind", "", "how the response was found", flags<ResponseKind>}, numbers_from(0.0, kinds.size()));
  data.add({"response_status", "", "how the search for the response ended, that for the equilibrium or for the orbit",
            search_status, "status"},
           {"speed", "kind"}, [&result, kinds] {
             std::vector<double> values;
             for (const UnbalancePoint& point : result.points) {
               for (const ResponseKind kind : kinds) values.push_back(static_cast<double>(status_of(point, kind)));
             }
             return values;
           });
  add_stations(stations, data);
  for (const ResponseQuantity& quantity : response_quantities()) {
    data.add(quantity.meaning(), {"speed", "kind", "station"}, [&result, stations, kinds, quantity] {
      std::vector<double> values;
      values.reserve(result.points.size() * kinds.size() * stations.size());
      for (const UnbalancePoint& point : result.points) {
        for (const ResponseKind kind : kinds) {
          for (std::size_t i = 0; i < stations.size(); ++i) {
            const StationResponse response = response_at(result, point, kind, i);
            values.push_back(response.motion ? quantity.value(response) : absent);
          }
        }
      }
      return values;
    });
  }
  return data;
}

Table response_table(const UnbalanceResult& result) {
  std::vector<std::string> columns = names_of(response_quantities(), {"speed", "station"});
  columns.insert(columns.end(), {"kind", "response_status"});
  return table_of(unbalance_dataset(result), {.over = {"speed", "kind", "station"}, .columns = std::move(columns)});
}

}  // namespace bumpfoil
