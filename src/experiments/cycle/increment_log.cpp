#include "experiments/cycle/increment_log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bumpfoil {
namespace {

/// Largest energy defect of a piecewise linear response, relative to the largest work.
constexpr double largest_imbalance = 1e-7;

/// Bumps times increments kept in memory, if increments are streamed.
constexpr int most_bumps_kept = 32'768;

/// The location of a contact in result numbering.
CycleEvent located(const BearingModel& foils, const StepEvent& event, Branch branch, const Eigen::Vector2d& direction) {
  const int block = event.contact / foils.contacts_per_block();
  const int pair = event.contact % foils.contacts_per_block();
  CycleEvent out{.branch = branch,
                 .displacement = event.position.dot(direction),
                 .interface = pair < foils.top_bump() ? Interface::journal_top : Interface::top_bump,
                 .index = block - foils.structure.first_bump,
                 .from = event.from,
                 .to = event.to};
  if (pair >= foils.first_foot()) {
    out.interface = Interface::bump_sleeve;
    out.index = block * foils.feet_per_block() + (pair - foils.first_foot()) / foils.foot_contacts();
  }
  return out;
}

}  // namespace

void EnergyBalance::add(const Increment& increment, bool is_linear) {
  if (increment.index == 0) start_ = increment.elastic_energy;
  must_hold_ = must_hold_ && (is_linear || increment.index == 0);
  const double stored = increment.elastic_energy - start_;
  imbalance_ = std::max(imbalance_, std::abs(increment.work - stored - increment.dissipated_energy));
  // Round-off of the energies, and of forces without load.
  const double energy_round_off = 1e-12 * (increment.elastic_energy + force_scale_ * std::abs(increment.displacement));
  scale_ = std::max({scale_, std::abs(increment.work), energy_round_off / largest_imbalance});
}

bool EnergyBalance::holds() const {
  return !must_hold_ || imbalance_ <= largest_imbalance * scale_;
}

IncrementLog::IncrementLog(FoilStepper& stepper, Recording recording, Cycle& cycle, std::function<void()> pass_on)
    : stepper_(stepper),
      everything_(recording == Recording::everything),
      cycle_(cycle),
      pass_on_(std::move(pass_on)),
      capacity_(pass_on_ ? std::clamp(most_bumps_kept / stepper.foils().bumps(), 1, cycle.due) : cycle.due),
      balance_(stepper.foils().problem.force_scale) {
  if (!everything_) return;
  cycle_.increments.reserve(static_cast<std::size_t>(capacity_));
  cycle_.fields = make_fields(stepper.foils(), capacity_);
}

Increment IncrementLog::make(const Step& step, Branch branch, const Eigen::Vector2d& direction, double displacement,
                             bool checked) {
  Increment next = step.converged() ? place_increment(foils(), step, direction) : failed_increment(step, direction);
  next.index = count_++;
  next.branch = branch;
  next.displacement = displacement;
  if (step.converged() && (everything_ || checked)) {
    check_increment(foils(), step.state, next);
    const SolverBounds bounds = stepper_.bounds();
    if (!next.residuals.within(bounds.force, bounds.displacement)) next.status = Status::residual_above_bound;
    if (next.converged()) balance_.add(next, step.is_linear);
  }
  if (count_ == cycle_.due && !balance_.holds()) next.status = Status::energy_defect;
  return next;
}

void IncrementLog::write_down(const Step& step, const Increment& increment, const Eigen::Vector2d& direction) {
  if (!everything_) return;
  if (pass_on_ && std::cmp_equal(cycle_.increments.size(), capacity_)) {
    pass_on_();
    cycle_.increments.clear();
    cycle_.events.clear();
    rows_ = 0;
  }
  for (const StepEvent& event : step.events) {
    cycle_.events.push_back(located(foils(), event, increment.branch, direction));
  }
  cycle_.increments.push_back(increment);
  if (!step.converged()) return;
  record(foils(), step.state, rows_, cycle_.fields);
  ++rows_;
}

void IncrementLog::finish() {
  cycle_.fields.truncate(rows_);
  if (pass_on_) pass_on_();
}

}  // namespace bumpfoil
