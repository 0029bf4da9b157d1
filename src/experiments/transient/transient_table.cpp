#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "experiments/transient/transient_quantities.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_turns_shown = 24;
constexpr std::size_t most_rubs_shown = 10;

/// The bearing place with the largest motion.
const PlaceTurn& widest(const TransientTurn& revolution) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < revolution.bearings.size(); ++i) {
    const auto size = [&](std::size_t k) { return revolution.places[k].orbit.half_peak_to_peak.maxCoeff(); };
    if (size(i) > size(at)) at = i;
  }
  return revolution.places[at];
}

/// Revolutions, with the motion of the journal that moves most.
Table table_of_turns(const std::vector<const TransientTurn*>& turns) {
  Table table;
  const auto add = [&](VariableMeaning meaning, const auto& value) {
    table.add(std::move(meaning),
              each(turns, [&value](const TransientTurn* turn) { return static_cast<double>(value(*turn)); }));
  };
  const auto add_worst = [&](const std::string& label, const ShownUnit& unit, double sign,
                             double BearingRecord::*member) {
    add(shown_column(label, unit), [sign, member](const TransientTurn& turn) {
      double worst = sign * turn.bearings.front().*member;
      for (const BearingRecord& bearing : turn.bearings) worst = std::max(worst, sign * bearing.*member);
      return sign * worst;
    });
  };
  add({"revolution", "1", "", whole_number, "revolution"}, [](const TransientTurn& turn) { return turn.number; });
  add(shown_column("time", {"ms", 1e-3}), [](const TransientTurn& turn) { return turn.time; });
  add(shown_column("speed", shown::revolutions), [](const TransientTurn& turn) { return turn.speed; });
  add(shown_column("1x", shown::micrometres),
      [](const TransientTurn& turn) { return widest(turn).orbit.once.cwiseAbs().maxCoeff(); });
  add(shown_column("1/2x", shown::micrometres), [](const TransientTurn& turn) {
    const auto& at_half = widest(turn).half;
    return at_half ? at_half->cwiseAbs().maxCoeff() : absent;
  });
  add(shown_column("half peak-to-peak", shown::micrometres),
      [](const TransientTurn& turn) { return widest(turn).orbit.half_peak_to_peak.maxCoeff(); });
  add_worst("minimum film thickness", shown::micrometres, -1.0, &BearingRecord::thinnest);
  add_worst("load of asperities", shown::newtons, 1.0, &BearingRecord::asperity_load);
  add(shown_column("friction loss", {"uJ", 1e-6}), [](const TransientTurn& turn) { return turn.energy.friction; });
  return table;
}

}  // namespace

std::string transient_table(const TransientReading& reading) {
  const std::vector<TransientTurn>& turns = reading.turns;
  const std::size_t shown_turns = std::min(turns.size(), most_turns_shown);
  std::vector<const TransientTurn*> some;
  for (std::size_t i = 0; i < shown_turns; ++i) {
    some.push_back(&turns[shown_turns < 2 ? 0 : i * (turns.size() - 1) / (shown_turns - 1)]);
  }
  std::string out;
  if (!turns.empty()) out = "Journal that moves most, along X or Y\n" + table_lines(table_of_turns(some));
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
