#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "case/case_json.hpp"
#include "experiments/run_sampling.hpp"
#include "experiments/unbalance/unbalance_quantities.hpp"
#include "results/result_files.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

RunStatus status_of(const UnbalanceResult& result) {
  return run_status(each(result.points,
                         [](const UnbalancePoint& point) {
                           return point.status == Status::converged ? status_of(point, ResponseKind::orbit)
                                                                    : point.status;
                         }),
                    result.points.size());
}

/// Entries of summary.json: `stations` by their names, `peaks`, and `speeds` with the response of each kind at each.
Json unbalance_lists(const UnbalanceResult& result) {
  const std::vector<RotorStation> stations = result.machine.places();
  const Dataset data = unbalance_dataset(result);
  const auto known = [&result](const auto& quantities) {
    std::vector<std::string> names;
    for (const auto& quantity : quantities) {
      if (!quantity.is(tag::of_orbits) || result.with_orbits) names.emplace_back(quantity.name);
    }
    return names;
  };
  Json json = rows_json(table_of(data, {.columns = known(unbalance_quantities().subspan(1))})).front();
  json.update({{"reduction_error", result.machine.reduction_error},
               {"stations", each(stations, [](const RotorStation& station) { return station.name; })},
               {"peaks", Json::array()},
               {"speeds", Json::array()}});
  for (const ResponsePeak& peak : peaks_of(result)) {
    json["peaks"].push_back({{"kind", name_of(peak.kind)},
                             {"station", peak.station},
                             {"speed_rad_per_s", peak.speed},
                             {"semi_major_m", peak.amplitude}});
  }
  std::vector<std::string> of_speeds = known(point_quantities());
  of_speeds.insert(of_speeds.begin(), "speed");
  std::vector<Json> speeds = rows_json(table_of(data, {.over = {"speed"}, .columns = std::move(of_speeds)}));
  const std::vector<Json> responses = rows_json(table_of(
      data, {.over = {"speed", "kind", "station"}, .columns = names_of(response_quantities(), {"kind", "station"})}));
  std::vector<Json> orbits;
  if (result.with_orbits) {
    orbits = rows_json(table_of(data, {.over = {"speed"}, .columns = names_of(orbit_quantities())}));
  }
  auto response = responses.begin();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const UnbalancePoint& point = result.points[i];
    speeds[i]["responses"] = Json::array();
    for (const ResponseKind kind : kinds_of(result)) {
      for (std::size_t k = 0; k < stations.size(); ++k, ++response) {
        if (response_at(result, point, kind, k).motion) speeds[i]["responses"].push_back(*response);
      }
    }
    if (point.orbit) speeds[i].update(orbits[i]);
  }
  json["speeds"] = std::move(speeds);
  return json;
}

Outcome unbalance_outcome(const Case& input, UnbalanceResult made) {
  const auto result = std::make_shared<const UnbalanceResult>(std::move(made));
  return {.status = status_of(*result),
          .warnings = warning_lines(input, *result),
          .failures = failure_lines(*result),
          .table = [=] { return unbalance_table(*result); },
          .dataset = [=] { return unbalance_dataset(*result); },
          .contents =
              [=](const std::string& /*run_id*/) {
                return ResultContents{.tables = {{"unbalance.csv", response_table(*result)}},
                                      .lists = unbalance_lists(*result)};
              },
          .swept =
              [=](bool /*with_loops*/) {
                return SweptResult{.dataset = unbalance_dataset(*result, false),
                                   .parts = {{"", 0}},
                                   .rows = response_table(*result),
                                   .lists = dump_json(unbalance_lists(*result), -1)};
              }};
}

}  // namespace

ExperimentInfo unbalance_experiment() {
  const std::vector<std::string> speeds{"unbalance.speeds=[\"12000 rpm\", \"13000 rpm\"]", "film.columns_per_pitch=4",
                                        "film.rows=4", "rotor.mass=2 kg", "rotor.unbalance=[{amount=\"2 g mm\"}]"};
  std::vector<std::string> with_orbits = speeds;
  with_orbits[0] = "unbalance.speeds=[\"-11000 rpm\"]";
  with_orbits.emplace_back("unbalance.orbits=true");
  with_orbits.emplace_back("unbalance.steps_per_revolution=30");
  const ExperimentRun run = [](const Case& input, const ProgressCallback& progress) {
    return unbalance_outcome(input, run_unbalance(input, progress));
  };
  const Sweeping sweeping{
      .run = run, .not_begun = [](const Case& input) { return unbalance_outcome(input, unbalance_not_begun(input)); }};
  return {
      .name = "unbalance",
      .summary = "Compute the response of a rotor on its bearings to unbalance, over speed",
      .examples =
          "  bumpfoil unbalance examples/rotor.toml -o unbalance\n"
          "  bumpfoil unbalance examples/rotor.toml -o orbits --orbits --set 'unbalance.speeds=[\"8000 rpm\", \"12000 "
          "rpm\"]'\n"
          "  bumpfoil unbalance examples/rotor.toml -o graded --set 'rotor.unbalance=[{grade=\"2.5 mm/s\", "
          "grade_speed=\"24000 rpm\"}]'\n"
          "  bumpfoil sweep examples/rotor.toml --command unbalance --over 'rotor.mass=[1 kg, 2 kg, 4 kg]' -o masses\n",
      .files = {"summary.json", "unbalance.csv", "result.nc"},
      .advice = "use fewer speeds",
      .switches = {{.name = "orbits",
                    .help = "Also find the periodic orbits with contacts and friction, by steps in time",
                    .key = "unbalance.orbits",
                    .value = "true"}},
      .run = run,
      .sweeping = sweeping,
      .sampling = rotor_sampling("largest_amplitude", sweeping),
      .quantities = meanings_of(unbalance_quantities()),
      .part_quantities = meanings_of(response_quantities(), point_quantities(), orbit_quantities()),
      .small_runs = {speeds, with_orbits}};
}

}  // namespace bumpfoil
