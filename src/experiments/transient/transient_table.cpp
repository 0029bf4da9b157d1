#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"
#include "experiments/transient/transient_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_turns_shown = 24;
constexpr std::size_t most_rubs_shown = 10;
constexpr int turn_cell_width = 11;

std::string turn_cell(double number, double size) {
  return fmt::format("{:>{}}", std::isfinite(number) ? number_text(number, size) : "-", turn_cell_width);
}

std::string heading(std::initializer_list<std::string_view> words) {
  std::string line;
  for (const std::string_view word : words) line += fmt::format("{:>{}}", word, turn_cell_width);
  return line + '\n';
}

/// The bearing place with the largest motion.
const PlaceTurn& widest(const TransientTurn& revolution) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < revolution.bearings.size(); ++i) {
    const auto way = [&](std::size_t k) { return revolution.places[k].orbit.half_peak_to_peak.maxCoeff(); };
    if (way(i) > way(at)) at = i;
  }
  return revolution.places[at];
}

std::string turn_line(const TransientTurn& revolution) {
  const PlaceTurn& place = widest(revolution);
  double thinnest = revolution.bearings.front().thinnest;
  double load = 0.0;
  for (const BearingRecord& bearing : revolution.bearings) {
    thinnest = std::min(thinnest, bearing.thinnest);
    load = std::max(load, bearing.asperity_load);
  }
  return fmt::format("{:>{}}", revolution.number, turn_cell_width) + turn_cell(revolution.time, 1e-3) +
         turn_cell(revolution.speed, shown::revolutions.size) +
         turn_cell(place.orbit.once.cwiseAbs().maxCoeff(), 1e-6) +
         turn_cell(place.half ? place.half->cwiseAbs().maxCoeff() : absent, 1e-6) +
         turn_cell(place.orbit.half_peak_to_peak.maxCoeff(), 1e-6) + turn_cell(thinnest, 1e-6) + turn_cell(load, 1.0) +
         turn_cell(revolution.energy.friction, 1e-6) + '\n';
}

}  // namespace

std::string transient_table(const TransientReading& reading) {
  const std::vector<TransientTurn>& turns = reading.turns;
  std::string out = "Journal that moves most, along X or Y\n";
  out += heading({"revolution", "time", "speed", "1x", "1/2x", "half p-p", "min. film", "asperities", "friction"});
  out += heading({"", "ms", "rpm", "um", "um", "um", "um", "N", "uJ"});
  const std::size_t shown_turns = std::min(turns.size(), most_turns_shown);
  for (std::size_t i = 0; i < shown_turns; ++i) {
    const std::size_t at = shown_turns < 2 ? 0 : i * (turns.size() - 1) / (shown_turns - 1);
    out += turn_line(turns[at]);
  }
  if (turns.size() > shown_turns) out += fmt::format("all {} revolutions are in the files\n", turns.size());
  if (turns.empty()) out += "no whole revolution\n";
  for (std::size_t i = 0; i < std::min(reading.rubs.size(), most_rubs_shown); ++i) {
    const RubEvent& rub = reading.rubs[i];
    out += fmt::format("rub, bearing {}: from {:.5g} to {:.5g} ms, {:.3g} N at most\n", rub.bearing + 1,
                       1e3 * rub.begin, 1e3 * rub.end, rub.load);
  }
  if (reading.rubs.size() > most_rubs_shown) {
    out += fmt::format("{} more rubs are in summary.json\n", reading.rubs.size() - most_rubs_shown);
  }
  if (!turns.empty()) {
    const WorkBalance& sum = reading.energy.sum;
    out += fmt::format(
        "energy of these revolutions, mJ: forces {:.4g}, films {:.4g}, friction of foils {:.4g}, stored {:.4g}; "
        "balance met to {:.2g} %\n",
        1e3 * sum.forces, 1e3 * sum.films(), 1e3 * sum.friction, 1e3 * sum.stored, 100.0 * reading.energy.relative());
  }
  return out;
}

}  // namespace bumpfoil
