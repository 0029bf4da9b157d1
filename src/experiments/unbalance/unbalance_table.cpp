#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bumpfoil/motion/response.hpp"
#include "core/number_text.hpp"
#include "experiments/unbalance/unbalance_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_responses_shown = 40;
/// Stations shown on the terminal: the bearings, and the first others.
constexpr std::size_t most_stations_shown = 4;
constexpr int response_cell_width = 12;

std::string response_cell(double number, double size) {
  return fmt::format("{:>{}}", std::isfinite(number) ? number_text(number, size) : "-", response_cell_width);
}

std::string_view heading_of(ResponseKind kind) {
  constexpr std::array<std::string_view, 3> headings{"Small orbits, contacts sliding", "Small orbits, contacts stuck",
                                                     "Periodic orbits with friction, 1x"};
  return headings.at(static_cast<std::size_t>(kind));
}

std::string response_lines(const UnbalanceResult& result, ResponseKind kind) {
  std::vector<RotorStation> stations = result.machine.places();
  stations.resize(std::min(stations.size(), most_stations_shown));
  std::string out = fmt::format("{}\n{:>{}}", heading_of(kind), "speed", response_cell_width);
  for (const RotorStation& station : stations) out += fmt::format("{:^{}}", station.name, 4 * response_cell_width);
  out += fmt::format("\n{:>{}}", "rpm", response_cell_width);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    for (const char* heading : {"X, um", "phase, deg", "Y, um", "phase, deg"}) {
      out += fmt::format("{:>{}}", heading, response_cell_width);
    }
  }
  out += '\n';
  const std::size_t listed = std::min(result.points.size(), most_responses_shown);
  for (std::size_t i = 0; i < listed; ++i) {
    const UnbalancePoint& point = result.points[i];
    out += response_cell(point.speed, shown::revolutions.size);
    const Status status = status_of(point, kind);
    if (status != Status::converged) {
      out += fmt::format("  {}\n", name_of(status));
      continue;
    }
    for (std::size_t k = 0; k < stations.size(); ++k) {
      const StationResponse response = response_at(result, point, kind, k);
      for (const std::string_view name : {"amplitude_x", "phase_x", "amplitude_y", "phase_y"}) {
        const auto all = response_quantities();
        const auto quantity =
            std::find_if(all.begin(), all.end(), [name](const ResponseQuantity& one) { return one.name == name; });
        out += response_cell(response.motion ? quantity->value(response) : absent, quantity->shown.size);
      }
    }
    out += '\n';
  }
  if (listed < result.points.size()) {
    out += fmt::format("speeds {} to {} are in the files only\n", listed + 1, result.points.size());
  }
  return out;
}

/// Results of the bearings in a turn: the worst, or the sum of all.
std::string orbit_lines(const UnbalanceResult& result) {
  const auto row = [](std::initializer_list<std::string_view> cells) {
    std::string line;
    for (const std::string_view cell : cells) line += fmt::format("{:>{}}", cell, response_cell_width);
    return line + '\n';
  };
  std::string out = row({"speed", "min. film", "friction", "power", "multiplier", "lasts", "turns"});
  out += row({"rpm", "um", "uJ", "W", "", "", ""});
  const std::size_t listed = std::min(result.points.size(), most_responses_shown);
  for (std::size_t i = 0; i < listed; ++i) {
    const UnbalancePoint& point = result.points[i];
    out += response_cell(point.speed, shown::revolutions.size);
    if (!point.orbit || point.orbit->turn.empty()) {
      out += fmt::format("  {}\n", name_of(status_of(point, ResponseKind::orbit)));
      continue;
    }
    BearingTurn all{.thinnest = point.orbit->turn.front().thinnest, .power = 0.0, .friction = 0.0};
    for (const BearingTurn& turn : point.orbit->turn) {
      all.thinnest = std::min(all.thinnest, turn.thinnest);
      all.power += turn.power;
      all.friction += turn.friction;
    }
    const auto& multipliers = point.orbit->multipliers;
    out += response_cell(all.thinnest, 1e-6) + response_cell(all.friction, 1e-6) + response_cell(all.power, 1.0);
    out += response_cell(multipliers.empty() ? absent : std::abs(multipliers.front()), 1.0);
    const std::optional<bool> lasts = lasting(*point.orbit);
    out += fmt::format("{:>{}}", !lasts ? "-" : *lasts ? "yes" : "no", response_cell_width);
    out += fmt::format("{:>{}}\n", point.orbit->turns, response_cell_width);
  }
  return out;
}

}  // namespace

std::string unbalance_table(const UnbalanceResult& result) {
  std::string out;
  for (const ResponseKind kind : kinds_of(result)) out += response_lines(result, kind) + '\n';
  if (kinds_of(result).back() == ResponseKind::orbit) out += orbit_lines(result) + '\n';
  const std::vector<ResponsePeak> peaks = peaks_of(result);
  for (const ResponsePeak& peak : peaks) {
    out += fmt::format("peak, {}: orbit of {:.4g} um at {:.6g} rpm, {}\n", name_of(peak.kind), 1e6 * peak.amplitude,
                       peak.speed / shown::revolutions.size, peak.station);
  }
  if (peaks.empty()) out += "the orbits have no peak between these speeds\n";
  return out;
}

}  // namespace bumpfoil
