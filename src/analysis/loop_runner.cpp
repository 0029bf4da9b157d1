#include "analysis/loop_runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/analysis/cycle_quantities.hpp"

namespace bumpfoil {
namespace {

/// A load of zero stands for this part of the largest: where nothing is touched the place would not be determined.
constexpr double least_load = 1e-6;

/// Where a contact is, as results count.
CycleEvent located(const FoilModel& model, const ContactEvent& event, Branch branch, double displacement) {
  const int block = event.contact / model.contacts_per_block();
  const int pair = event.contact % model.contacts_per_block();
  CycleEvent out{.branch = branch,
                 .displacement = displacement,
                 .interface = pair == model.top_bump() ? Interface::top_bump : Interface::journal_top,
                 .index = block - model.structure.first_bump,
                 .from = event.from,
                 .to = event.to};
  if (pair >= model.first_foot()) {
    out.interface = Interface::bump_sleeve;
    out.index = block * model.feet_per_block() + pair - model.first_foot();
  }
  return out;
}

}  // namespace

std::vector<LoopStep> push_and_pull(double amplitude, int steps) {
  std::vector<LoopStep> loop;
  for (int k = 0; k <= 2 * steps; ++k) {
    const int from_start = k <= steps ? k : 2 * steps - k;
    loop.push_back({k <= steps ? Branch::loading : Branch::unloading, amplitude * from_start / steps});
  }
  return loop;
}

std::vector<LoopStep> swing(double amplitude, int steps) {
  std::vector<LoopStep> loop;
  for (int k = 0; k <= 4 * steps; ++k) {
    const bool down = k > steps && k <= 3 * steps;
    const int from_middle = k <= steps ? k : down ? 2 * steps - k : k - 4 * steps;
    loop.push_back({down ? Branch::unloading : Branch::loading, amplitude * from_middle / steps});
  }
  return loop;
}

LoopRunner::LoopRunner(PathRunner& path, LoopPlan plan, Cycle cycle)
    : path_(path), plan_(std::move(plan)), cycle_(std::move(cycle)) {
  cycle_.due = static_cast<int>(plan_.steps.size());
  cycle_.increments.reserve(plan_.steps.size());
}

bool LoopRunner::advance(std::size_t index) {
  if (index == 0) {
    const std::optional<double> origin = plan_.begin(path_);
    if (origin) origin_ = *origin;
    if (origin && plan_.assembles) cycle_.assembly_dissipation = path_.assembly_dissipation();
    return origin.has_value();
  }
  const double value = origin_ + plan_.steps[index].value;
  if (!plan_.by_load) return path_.move_to(value * plan_.normal);
  const double largest = origin_ + plan_.steps[static_cast<std::size_t>(cycle_.steps)].value;
  return path_.load_to(plan_.normal, std::max(value, least_load * largest), plan_.reach);
}

bool LoopRunner::take_increment() {
  const std::size_t index = cycle_.increments.size();
  if (!advance(index)) return false;
  Increment next = path_.record(plan_.normal);
  next.index = static_cast<int>(index);
  next.branch = plan_.steps[index].branch;
  if (!plan_.by_load) next.displacement = origin_ + plan_.steps[index].value;
  if (path_.is_exact() && !next.residuals.within()) return false;
  if (index > 0) note_events(cycle_.increments.back(), next);
  cycle_.increments.push_back(std::move(next));
  if (std::cmp_equal(index, cycle_.steps)) {
    tangents_ = tangent_stiffnesses(path_.model(), path_.state(), plan_.normal);
  }
  return true;
}

void LoopRunner::note_events(const Increment& last, const Increment& next) {
  for (const ContactEvent& event : path_.events()) {
    cycle_.events.push_back(located(path_.model(), event, next.branch,
                                    last.displacement + event.fraction * (next.displacement - last.displacement)));
  }
}

Cycle LoopRunner::finish() {
  derive_quantities(cycle_, tangents_);
  return std::move(cycle_);
}

}  // namespace bumpfoil
