#include <fmt/format.h>

#include "bumpfoil/results/quantity.hpp"
#include "experiments/unbalance/unbalance_quantities.hpp"
#include "results/csv_value.hpp"

namespace bumpfoil {
namespace {

void add_points(const UnbalanceResult& result, Dataset& data) {
  data.add_dimension({"speed", "rad/s", "speed of the rotor, positive from X to Y"},
                     each(result.points, [](const UnbalancePoint& point) { return point.speed; }));
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

std::string unbalance_csv(const UnbalanceResult& result) {
  std::string out = "speed_rad_per_s,station";
  for (const ResponseQuantity& quantity : response_quantities()) out += ',' + quantity.key();
  out += ",kind,status\n";
  const std::vector<RotorStation> stations = result.machine.places();
  for (const UnbalancePoint& point : result.points) {
    for (const ResponseKind kind : kinds_of(result)) {
      for (std::size_t i = 0; i < stations.size(); ++i) {
        const StationResponse response = response_at(result, point, kind, i);
        append_csv(out, point.speed);
        out += ',' + stations[i].name;
        for (const ResponseQuantity& quantity : response_quantities()) {
          append_csv(out += ',', response.motion ? quantity.value(response) : absent);
        }
        out += fmt::format(",{},{}\n", name_of(kind), name_of(status_of(point, kind)));
      }
    }
  }
  return out;
}

}  // namespace bumpfoil
