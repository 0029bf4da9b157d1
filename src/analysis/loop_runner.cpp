#include "analysis/loop_runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/analysis/cycle_quantities.hpp"

namespace bumpfoil {
namespace {

/// A load of zero stands for this part of the largest: where nothing is touched the place would not be determined.
constexpr double least_load = 1e-6;

/// Work that was neither stored nor dissipated in a response followed from event to event, as part of the largest work.
constexpr double largest_imbalance = 1e-7;

/// Whether W = E - E0 + D holds at every increment.
bool keeps_energy(const std::vector<Increment>& increments, double force_scale) {
  double scale = 0.0;
  double imbalance = 0.0;
  for (const Increment& k : increments) {
    const double stored = k.elastic_energy - increments.front().elastic_energy;
    imbalance = std::max(imbalance, std::abs(k.work - stored - k.dissipated_energy));
    // Roundings of the energies, and of forces where nothing is loaded.
    const double rounding = 1e-12 * (k.elastic_energy + force_scale * std::abs(k.displacement));
    scale = std::max({scale, std::abs(k.work), rounding / largest_imbalance});
  }
  return imbalance <= largest_imbalance * scale;
}

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

std::vector<Leg> push_and_pull(double amplitude, int steps) {
  return {{Branch::loading, amplitude, steps}, {Branch::unloading, 0.0, steps}};
}

std::vector<Leg> swing(double amplitude, int steps) {
  return {
      {Branch::loading, amplitude, steps}, {Branch::unloading, -amplitude, 2 * steps}, {Branch::loading, 0.0, steps}};
}

LoopRunner::LoopRunner(PathRunner& path, LoopPlan plan, Cycle cycle)
    : path_(path), plan_(std::move(plan)), cycle_(std::move(cycle)) {
  cycle_.due = 1;
  for (const Leg& leg : plan_.legs) cycle_.due += leg.steps;
  cycle_.increments.reserve(static_cast<std::size_t>(cycle_.due));
}

bool LoopRunner::begin() {
  const std::optional<double> origin = plan_.begin(path_);
  if (!origin) return false;
  origin_ = *origin;
  if (plan_.assembles) cycle_.assembly_dissipation = path_.assembly_dissipation();
  return true;
}

/// Goes on to the next step. @return where it leads
double LoopRunner::next_step() {
  if (steps_of_leg_ == plan_.legs[leg_].steps) {
    ++leg_;
    steps_of_leg_ = 0;
  }
  ++steps_of_leg_;
  const Leg& leg = plan_.legs[leg_];
  const double begin = leg_ == 0 ? 0.0 : plan_.legs[leg_ - 1].end;
  return origin_ + (begin * (leg.steps - steps_of_leg_) + leg.end * steps_of_leg_) / leg.steps;
}

bool LoopRunner::advance(double value) {
  if (plan_.by_load) {
    const double largest = origin_ + plan_.legs.front().end;
    return path_.load_to(plan_.normal, std::max(value, least_load * largest), plan_.reach);
  }
  const Leg& leg = plan_.legs[leg_];
  if (steps_of_leg_ == 1) path_.set_out((origin_ + leg.end) * plan_.normal);
  return path_.advance_to(static_cast<double>(steps_of_leg_) / leg.steps);
}

bool LoopRunner::take_increment() {
  const std::size_t index = cycle_.increments.size();
  const double value = index == 0 ? 0.0 : next_step();
  if (!(index == 0 ? begin() : advance(value))) return false;
  Increment next = path_.record(plan_.normal);
  next.index = static_cast<int>(index);
  next.branch = plan_.legs[leg_].branch;
  if (!plan_.by_load) next.displacement = index == 0 ? origin_ : value;
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
  std::vector<Increment>& increments = cycle_.increments;
  if (path_.follows_events() && !keeps_energy(increments, path_.model().problem.force_scale)) {
    increments.back().solve.converged = false;
  }
  derive_quantities(cycle_, tangents_);
  return std::move(cycle_);
}

}  // namespace bumpfoil
