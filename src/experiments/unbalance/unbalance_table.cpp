#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/motion/unbalance_response.hpp"
#include "core/number_text.hpp"
#include "experiments/unbalance/unbalance_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_responses_shown = 40;
/// Stations that the terminal shows: the bearings, and the first others.
constexpr std::size_t most_stations_shown = 4;
constexpr int response_cell_width = 12;

std::string response_cell(double number, double size) {
  return fmt::format("{:>{}}", std::isfinite(number) ? number_text(number, size) : "-", response_cell_width);
}

std::string response_lines(const UnbalanceResult& result, ResponseKind kind) {
  std::vector<RotorStation> stations = stations_of(result.machine.rotor);
  stations.resize(std::min(stations.size(), most_stations_shown));
  std::string out =
      fmt::format("{}\n{:>{}}", kind == ResponseKind::linear_stuck ? "Contacts stuck" : "Contacts sliding", "speed",
                  response_cell_width);
  for (const RotorStation& station : stations) out += fmt::format("{:^{}}", station.name, 4 * response_cell_width);
  out += fmt::format("\n{:>{}}", "rpm", response_cell_width);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    for (const char* heading : {"X, um", "phase, deg", "Y, um", "phase, deg"}) {
      out += fmt::format("{:>{}}", heading, response_cell_width);
    }
  }
  out += '\n';
  const std::size_t shown = std::min(result.points.size(), most_responses_shown);
  for (std::size_t i = 0; i < shown; ++i) {
    const UnbalancePoint& point = result.points[i];
    out += response_cell(point.speed, shown::revolutions.size);
    if (point.status != Status::converged) {
      out += fmt::format("  {}\n", name_of(point.status));
      continue;
    }
    for (const RotorStation& station : stations) {
      const StationResponse response = response_at(point, kind, station);
      for (const std::string_view name : {"amplitude_x", "phase_x", "amplitude_y", "phase_y"}) {
        const auto all = response_quantities();
        const auto quantity =
            std::find_if(all.begin(), all.end(), [name](const ResponseQuantity& one) { return one.name == name; });
        out += response_cell(response.motion ? quantity->value(response) : absent, quantity->shown.size);
      }
    }
    out += '\n';
  }
  if (shown < result.points.size()) {
    out += fmt::format("speeds {} to {} are in the files only\n", shown + 1, result.points.size());
  }
  return out;
}

}  // namespace

std::string unbalance_table(const UnbalanceResult& result) {
  std::string out = response_lines(result, ResponseKind::linear_sliding) + '\n' +
                    response_lines(result, ResponseKind::linear_stuck) + '\n';
  const std::vector<ResponsePeak> peaks = peaks_of(result);
  for (const ResponsePeak& peak : peaks) {
    out += fmt::format("peak, contacts {}: orbit of {:.4g} um at {:.6g} rpm, {}\n",
                       peak.kind == ResponseKind::linear_stuck ? "stuck" : "sliding", 1e6 * peak.amplitude,
                       peak.speed / shown::revolutions.size, peak.station);
  }
  if (peaks.empty()) out += "the orbits have no peak between these speeds\n";
  return out;
}

}  // namespace bumpfoil
