#include "bumpfoil/analysis/cycle.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "bumpfoil/analysis/bearing_model.hpp"
#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/analysis/energy.hpp"
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

  /// Takes the next increment. @return false if it failed: the cycle ends there.
  bool take_increment(ContactState& state, ContactLoading& loading) {
    const int index = static_cast<int>(cycle_.increments.size());
    const int from_centre = index <= cycle_.steps ? index : 2 * cycle_.steps - index;
    const double displacement = cycle_.amplitude * from_centre / cycle_.steps;
    const Eigen::Vector2d position = displacement * normal_;
    ContactLoading next = loading_at(model_, position);
    const IncrementReport report = index == 0 ? assemble(next, state) : step(loading, next, state);
    if (!state.x.allFinite() || !state.normal_force.allFinite() || !state.friction_force.allFinite()) return false;
    loading = std::move(next);

    Increment record = record_increment(model_, position, normal_, loading, begin_of_part_, state);
    record.index = index;
    record.branch = index <= cycle_.steps ? Branch::loading : Branch::unloading;
    record.displacement = displacement;
    record.work = work_;
    record.dissipated_energy = dissipation_;
    record.solve = report.solve;
    record.substeps = report.substeps;
    cycle_.increments.push_back(std::move(record));
    return report.solve.converged;
  }

  /// Derives the quantities of the cycle from its increments.
  Cycle finish(const std::vector<ContactMode>& modes_at_turning_point) {
    const std::vector<Increment>& increments = cycle_.increments;
    const auto all = static_cast<std::size_t>(2 * cycle_.steps + 1);
    const auto good = static_cast<std::size_t>(std::count_if(
        increments.begin(), increments.end(), [](const Increment& increment) { return increment.solve.converged; }));
    cycle_.converged = good == all;
    if (good > 0) {
      cycle_.first_contact = first_contact_displacement(model_, increments.front().top_displacement, normal_);
      cycle_.clearance_5N = clearance_at(increments, 5.0);
      cycle_.clearance_10N = clearance_at(increments, 10.0);
    }
    if (good > static_cast<std::size_t>(cycle_.steps)) {
      const Increment& turning = cycle_.at_turning_point();
      const TangentStiffnesses tangent = tangent_stiffnesses(model_, modes_at_turning_point, normal_);
      cycle_.turning_point = TurningPoint{.max_force = turning.force_direct,
                                          .cross_force = turning.force_cross,
                                          .elastic_energy = turning.elastic_energy,
                                          .tangent_stiffness_loading = tangent.loading,
                                          .tangent_stiffness_unloading = tangent.unloading,
                                          .secant_stiffness = turning.force_direct / cycle_.amplitude};
    }
    if (good == all) {
      cycle_.loop_energy = increments.back().work;
      cycle_.loss_factor =
          loss_factor(*cycle_.loop_energy, cycle_.turning_point->elastic_energy - increments.front().elastic_energy);
    }
    return std::move(cycle_);
  }

 private:
  /// Increment 0: solved in one step from the unstressed foils.
  IncrementReport assemble(const ContactLoading& loading, ContactState& state) {
    const ContactState unstressed = state;
    const SolveReport report = solver_.assemble(loading, unstressed, state);
    begin_of_part_ = unstressed.x;
    cycle_.assembly_dissipation = friction_dissipation(model_.problem, state.normal_force, unstressed.x, state.x);
    return {.solve = report, .substeps = 0};
  }

  IncrementReport step(const ContactLoading& from, const ContactLoading& to, ContactState& state) {
    std::vector<ContactEvent> events;
    const auto visit = [this](const ContactState& begin, const ContactState& end) {
      begin_of_part_ = begin.x;
      work_ += gap_work(model_.problem, begin, end);
      // Forces vary linearly from event to event; an increment carries the friction of its end throughout.
      const Vector p =
          solver_.follows_events() ? Vector(0.5 * (begin.normal_force + end.normal_force)) : end.normal_force;
      dissipation_ += friction_dissipation(model_.problem, p, begin.x, end.x);
    };
    const IncrementReport report = solver_.advance(from, to, state, visit, events);
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
  const BearingModel model = make_bearing_model(input);
  PathSolver solver(input.solver, model.problem);
  CycleResult result{.solver = input.solver.name, .cycles = {}};
  const auto increments = static_cast<std::size_t>(2 * input.cycle.steps + 1);
  bool stopped = false;
  for (const double direction : input.cycle.directions) {
    const auto start = std::chrono::steady_clock::now();
    CycleRunner runner(model, solver, direction, input.cycle);
    ContactState state = ContactState::unstressed(model.problem);
    ContactLoading loading;
    std::vector<ContactMode> modes_at_turning_point;
    for (std::size_t k = 0; k < increments && !stopped; ++k) {
      if (!runner.take_increment(state, loading)) break;
      if (k == static_cast<std::size_t>(input.cycle.steps)) modes_at_turning_point = state.mode;
      const double done =
          static_cast<double>(result.cycles.size()) + static_cast<double>(k + 1) / static_cast<double>(increments);
      stopped = progress && !progress(done / static_cast<double>(input.cycle.directions.size()));
    }
    result.cycles.push_back(runner.finish(modes_at_turning_point));
    result.cycles.back().wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (stopped) break;
  }
  return result;
}

}  // namespace bumpfoil
