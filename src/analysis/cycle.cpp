#include "bumpfoil/analysis/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "analysis/each_direction.hpp"
#include "bumpfoil/analysis/bearing_model.hpp"
#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/analysis/energy.hpp"
#include "bumpfoil/analysis/former_cycle.hpp"
#include "bumpfoil/analysis/path_solver.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// One direction of a case, increment by increment.
class CycleRunner {
 public:
  CycleRunner(const BearingModel& model, PathSolver& solver, double direction, const CycleSettings& settings)
      : model_(model), solver_(solver), normal_(unit_vector(direction)) {
    cycle_.direction = direction;
    cycle_.amplitude = settings.amplitude;
    cycle_.steps = settings.steps;
    cycle_.increments.reserve(static_cast<std::size_t>(2 * settings.steps + 1));
  }

  /// Takes the next increment. @return false if it failed: the cycle ends with the increment before.
  bool take_increment() {
    const int index = static_cast<int>(cycle_.increments.size());
    const int from_centre = index <= cycle_.steps ? index : 2 * cycle_.steps - index;
    const double displacement = cycle_.amplitude * from_centre / cycle_.steps;
    const Eigen::Vector2d position = displacement * normal_;
    ContactLoading next = loading_at(model_, position);
    const IncrementReport report = index == 0 ? assemble(next) : step(next);
    if (!report.solve.converged) return false;
    loading_ = std::move(next);

    Increment record = record_increment(model_, position, normal_, loading_, begin_of_part_, state_);
    record.index = index;
    record.branch = index <= cycle_.steps ? Branch::loading : Branch::unloading;
    record.displacement = displacement;
    record.work = work_;
    record.dissipated_energy = dissipation_;
    record.solve = report.solve;
    record.substeps = report.substeps;
    if (solver_.is_exact() && !record.residuals.within()) return false;
    cycle_.increments.push_back(std::move(record));
    if (index == cycle_.steps) tangents_ = tangent_stiffnesses(model_, state_, normal_);
    return true;
  }

  /// Derives the quantities of the cycle from its increments.
  Cycle finish() {
    if (!cycle_.increments.empty() && cycle_.increments.front().solve.converged) {
      cycle_.first_contact =
          first_contact_displacement(model_.bearing, model_.phi, cycle_.increments.front().top_displacement, normal_);
    }
    derive_quantities(cycle_, tangents_);
    return std::move(cycle_);
  }

 private:
  /// Increment 0: solved in one step from the unstressed foils.
  IncrementReport assemble(const ContactLoading& loading) {
    const ContactState unstressed = ContactState::unstressed(model_.problem);
    const SolveReport report = solver_.assemble(loading, unstressed, state_);
    begin_of_part_ = unstressed.x;
    cycle_.assembly_dissipation = friction_dissipation(model_.problem, state_.normal_force, unstressed.x, state_.x);
    return {.solve = report, .substeps = 0};
  }

  IncrementReport step(const ContactLoading& to) {
    std::vector<ContactEvent> events;
    const auto visit = [this](const ContactState& begin, const ContactState& end) {
      begin_of_part_ = begin.x;
      work_ += gap_work(model_.problem, begin, end);
      // Forces vary linearly from event to event; an increment carries the friction of its end throughout.
      const Vector p =
          solver_.follows_events() ? Vector(0.5 * (begin.normal_force + end.normal_force)) : end.normal_force;
      dissipation_ += friction_dissipation(model_.problem, p, begin.x, end.x);
    };
    const IncrementReport report = solver_.advance(loading_, to, state_, visit, events);
    const Increment& last = cycle_.increments.back();
    const double begin = last.displacement;
    const double end = begin + cycle_.amplitude / cycle_.steps * (last.index < cycle_.steps ? 1.0 : -1.0);
    for (const ContactEvent& event : events) {
      cycle_.events.push_back(located(event, last.index < cycle_.steps ? Branch::loading : Branch::unloading,
                                      begin + event.fraction * (end - begin)));
    }
    return report;
  }

  CycleEvent located(const ContactEvent& event, Branch branch, double displacement) const {
    const auto pairs = static_cast<int>(model_.problem.pairs.size());
    const int bump = event.contact / pairs;
    const int pair = event.contact % pairs;
    CycleEvent out{.branch = branch,
                   .displacement = displacement,
                   .interface = Interface::journal_top,
                   .index = bump,
                   .from = event.from,
                   .to = event.to};
    if (pair == BearingModel::top_bump) out.interface = Interface::top_bump;
    if (pair >= BearingModel::first_foot) {
      out.interface = Interface::bump_sleeve;
      out.index = bump * model_.feet_per_bump() + pair - BearingModel::first_foot;
    }
    return out;
  }

  const BearingModel& model_;
  PathSolver& solver_;
  Eigen::Vector2d normal_;
  Cycle cycle_;
  ContactState state_;
  ContactLoading loading_;
  std::optional<TangentStiffnesses> tangents_;
  Vector begin_of_part_;
  double work_{};
  double dissipation_{};
};

}  // namespace

double Cycle::initial_journal_load() const {
  return increments.empty() ? 0.0 : increments.front().journal_top.normal_force.sum();
}

double Cycle::max_residual() const {
  double largest = 0.0;
  for (const Increment& increment : increments) largest = std::max(largest, increment.residuals.equilibrium);
  return largest;
}

SolveReport Cycle::total() const {
  SolveReport sum;
  for (const Increment& increment : increments) sum += increment.solve;
  return sum;
}

int Cycle::substeps() const {
  int sum = 0;
  for (const Increment& increment : increments) sum += increment.substeps;
  return sum;
}

bool CycleResult::converged() const {
  return std::all_of(cycles.begin(), cycles.end(), [](const Cycle& cycle) { return cycle.converged; });
}

CycleResult run_cycles(const Case& input, const ProgressCallback& progress) {
  if (input.bump_foil.model == BumpFoilModel::former) return run_former_cycles(input, progress);
  const BearingModel model = make_bearing_model(input);
  PathSolver solver(input.solver, model.problem);
  return run_each_direction(input, progress,
                            [&](double direction) { return CycleRunner(model, solver, direction, input.cycle); });
}

}  // namespace bumpfoil
