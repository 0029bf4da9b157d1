#include "bumpfoil/analysis/former_cycle.hpp"

#include <algorithm>
#include <utility>

#include "analysis/run_loops.hpp"
#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/former/former_model.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// One direction of a case.
class FormerRunner {
 public:
  FormerRunner(const FormerModel& model, FormerSolver& solver, double direction, const CycleSettings& settings)
      : model_(model), solver_(solver), normal_(unit_vector(direction)) {
    cycle_.direction = direction;
    cycle_.amplitude = settings.amplitude;
    cycle_.steps = settings.steps;
    cycle_.due = 2 * settings.steps + 1;
    cycle_.first_contact =
        first_contact_displacement(model.bearing.radial_clearance, model.normals, -model.height_errors, normal_);
  }

  bool take_increment() {
    const int index = static_cast<int>(cycle_.increments.size());
    const int from_centre = index <= cycle_.steps ? index : 2 * cycle_.steps - index;
    const double displacement = cycle_.amplitude * from_centre / cycle_.steps;
    const Eigen::Vector2d position = displacement * normal_;
    const FormerSolution solution = solver_.solve(position);
    if (!solution.state.x.allFinite() || !solution.state.normal_force.allFinite()) return false;

    Increment next = record(position, solution);
    next.index = index;
    next.branch = index <= cycle_.steps ? Branch::loading : Branch::unloading;
    next.displacement = displacement;
    if (index > 0) {
      const Increment& last = cycle_.increments.back();
      next.work = last.work + 0.5 * ((next.force_x + last.force_x) * (next.x - last.x) +
                                     (next.force_y + last.force_y) * (next.y - last.y));
    }
    cycle_.increments.push_back(std::move(next));
    if (index == cycle_.steps) {
      const std::optional<double> tangent = solver_.tangent_stiffness(solution.state, normal_);
      tangents_ = TangentStiffnesses{.loading = tangent, .unloading = tangent};
    }
    return solution.report.converged;
  }

  [[nodiscard]] int due() const { return cycle_.due; }

  Cycle finish() {
    derive_quantities(cycle_, tangents_);
    return std::move(cycle_);
  }

 private:
  Increment record(const Eigen::Vector2d& position, const FormerSolution& solution) const {
    const ContactState& state = solution.state;
    Increment next;
    next.x = position.x();
    next.y = position.y();
    const Eigen::Vector2d force = former_journal_force(model_, state);
    next.force_x = force.x();
    next.force_y = force.y();
    next.force_direct = force.dot(normal_);
    next.force_cross = force.dot(Eigen::Vector2d(-normal_.y(), normal_.x()));
    next.elastic_energy = elastic_response(model_.structure, state.x).energy;
    next.residuals = solution.residuals;
    next.solve = solution.report;

    const BumpDofs& dofs = model_.structure.dofs;
    const auto every = [&](int dof) { return state.x(Eigen::seqN(dof, model_.bumps(), dofs.size)); };
    next.crest_u = every(dofs.crest_u);
    next.crest_v = every(dofs.crest_v);
    next.foot_u = every(dofs.foot_u.front());
    next.foot_v = every(dofs.foot_v.front());
    next.top_displacement = -former_crest_gaps(model_, position).cwiseMin(0.0);
    next.top_bump = fields(state, FormerModel::crest);
    next.bump_sleeve = fields(state, FormerModel::foot);
    next.journal_top = next.top_bump;
    next.journal_top.friction_force.setZero();
    for (ContactMode& m : next.journal_top.mode) {
      if (m != ContactMode::open) m = ContactMode::stick;
    }
    return next;
  }

  InterfaceFields fields(const ContactState& state, int contact) const {
    const auto every = Eigen::seqN(contact, model_.bumps(), 2);
    InterfaceFields out{.gap = state.gap(every),
                        .normal_force = state.normal_force(every),
                        .friction_force = state.friction_force(every),
                        .mode = {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(model_.bumps()); ++i) {
      out.mode.push_back(state.mode[2 * i + static_cast<std::size_t>(contact)]);
      if (out.mode.back() != ContactMode::open) out.gap[static_cast<Eigen::Index>(i)] = 0.0;
    }
    return out;
  }

  const FormerModel& model_;
  FormerSolver& solver_;
  Eigen::Vector2d normal_;
  Cycle cycle_;
  std::optional<TangentStiffnesses> tangents_;
};

}  // namespace

CycleResult run_former_cycles(const Case& input, const ProgressCallback& progress) {
  const FormerModel model = make_former_model(input);
  FormerSolver solver(model);
  return run_loops(Experiment::cycle, input, std::ssize(input.cycle.directions), progress,
                   [&](std::size_t i) { return FormerRunner(model, solver, input.cycle.directions[i], input.cycle); });
}

}  // namespace bumpfoil
