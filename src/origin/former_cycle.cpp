#include "origin/former_cycle.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/motion/march.hpp"
#include "bumpfoil/origin/former_model.hpp"

namespace bumpfoil {
namespace {

void record_contacts(const FormerModel& model, const ContactState& state, int contact, Eigen::Index increment,
                     InterfaceFields& fields) {
  for (Eigen::Index i = 0; i < model.bumps(); ++i) {
    const Eigen::Index c = 2 * i + contact;
    const ContactMode mode = state.mode[static_cast<std::size_t>(c)];
    fields.gap(increment, i) = mode == ContactMode::open ? state.gap[c] : 0.0;
    fields.normal_force(increment, i) = state.normal_force[c];
    fields.friction_force(increment, i) = state.friction_force[c];
    fields.mode(increment, i) = mode;
  }
}

void record(const FormerModel& model, const Eigen::Vector2d& position, const ContactState& state,
            Eigen::Index increment, FoilFields& fields) {
  const BumpDofs& dofs = model.structure.dofs;
  const Vector crest_gaps = former_crest_gaps(model, position);
  for (Eigen::Index i = 0; i < model.bumps(); ++i) {
    const auto bump = state.x.segment(i * dofs.size, dofs.size);
    fields.crest_u(increment, i) = bump[dofs.crest_u];
    fields.crest_v(increment, i) = bump[dofs.crest_v];
    fields.foot_u(increment, i) = bump[dofs.foot_u.front()];
    fields.foot_v(increment, i) = bump[dofs.foot_v.front()];
    fields.top_displacement(increment, i) = -std::min(0.0, crest_gaps[i]);
  }
  fields.compression.row(increment) = bump_compression(model.structure, state.x);
  record_contacts(model, state, FormerModel::crest, increment, fields.top_bump);
  record_contacts(model, state, FormerModel::foot, increment, fields.bump_sleeve);
  record_contacts(model, state, FormerModel::crest, increment, fields.journal_top);
  fields.journal_top.friction_force.row(increment).setZero();
  for (Eigen::Index i = 0; i < model.bumps(); ++i) {
    ContactMode& mode = fields.journal_top.mode(increment, i);
    if (mode != ContactMode::open) mode = ContactMode::stick;
  }
}

FoilFields make_former_fields(const FormerModel& model, int increments) {
  FoilFields fields;
  for (FieldMatrix* field : {&fields.top_displacement, &fields.crest_u, &fields.crest_v, &fields.foot_u, &fields.foot_v,
                             &fields.compression}) {
    field->resize(increments, model.bumps());
  }
  for (InterfaceFields* interface : {&fields.journal_top, &fields.top_bump, &fields.bump_sleeve}) {
    interface->resize(increments, model.bumps());
  }
  return fields;
}

Increment make_increment(const FormerModel& model, const Eigen::Vector2d& position, const Eigen::Vector2d& normal,
                         const FormerSolution& solution) {
  Increment next;
  next.x = position.x();
  next.y = position.y();
  const Eigen::Vector2d force = former_journal_force(model, solution.state);
  next.force_x = force.x();
  next.force_y = force.y();
  next.force_direct = force.dot(normal);
  next.force_cross = force.dot(Eigen::Vector2d(-normal.y(), normal.x()));
  next.elastic_energy = elastic_response(model.structure, solution.state.x).energy;
  next.residuals = solution.residuals;
  next.status = solution.report.status;
  next.cost = solution.report.cost;
  return next;
}

/// One direction of a case: push and pull, with the same journal positions as in the present model.
Cycle run_former_cycle(const FormerModel& model, FormerSolver& solver, double direction, const CycleSettings& settings,
                       const ProgressCallback& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const Eigen::Vector2d normal = unit_vector(direction);
  const Line line{.base = Eigen::Vector2d::Zero(), .direction = normal};
  const Program program = one_sided_cycle(Control::displacement, line, 0.0, settings.amplitude.value, settings.steps);
  Cycle cycle;
  cycle.direction = direction;
  cycle.amplitude = settings.amplitude.value;
  cycle.steps = settings.steps;
  for (const double force : settings.clearance_forces) cycle.clearances.push_back({force, {}});
  cycle.due = increments_of(program);
  const Vector gaps = former_crest_gaps(model, Eigen::Vector2d::Zero());
  cycle.first_contact = first_contact_displacement(gaps, model.normals, normal);
  cycle.fields = make_former_fields(model, cycle.due);
  CycleQuantities quantities(cycle);

  FormerSolution solution = solver.solve(line.base);
  const auto add = [&](double displacement, Branch branch, bool ends_leg) {
    const Eigen::Vector2d position = line.place(displacement);
    Increment next = make_increment(model, position, normal, solution);
    next.displacement = displacement;
    next.index = static_cast<int>(cycle.increments.size());
    next.branch = branch;
    if (next.index > 0) {
      const Increment& last = cycle.increments.back();
      next.work = last.work + 0.5 * ((next.force_x + last.force_x) * (next.x - last.x) +
                                     (next.force_y + last.force_y) * (next.y - last.y));
    }
    record(model, position, solution.state, next.index, cycle.fields);
    cycle.increments.push_back(next);
    quantities.add(next, ends_leg || next.index == 0, ends_leg);
    if (next.index == 0 && next.converged()) {
      cycle.initial_journal_load = cycle.fields.journal_top.normal_force.row(0).sum();
    }
    if (ends_leg && next.converged() && !cycle.turning_point) {
      const std::optional<double> tangent = solver.tangent_stiffness(solution.state, normal);
      TurningPoint response;
      response.tangent = {.loading = tangent, .unloading = tangent};
      response.journal_loads = cycle.fields.journal_top.normal_force.row(next.index);
      response.bump_loads = cycle.fields.top_bump.normal_force.row(next.index);
      response.foot_loads = cycle.fields.bump_sleeve.normal_force.row(next.index);
      quantities.turn(std::move(response));
    }
    const bool all = std::cmp_equal(cycle.increments.size(), cycle.due);
    const bool stopped =
        progress && !progress(static_cast<double>(cycle.increments.size()) / static_cast<double>(cycle.due));
    if (next.converged() && stopped && !all) cycle.status = Status::interrupted;
    return cycle.converged();
  };
  if (add(0.0, Branch::loading, false)) {
    // Only the position passes from one increment to the next.
    const auto take = [&](const Leg& leg, int taken, const BearingState&, Step&) {
      solution = solver.solve(line.place(leg.target(taken)));
    };
    BearingState state;
    Step step;
    march(take, schedule_of(program), state, step, [&](const Passage& at) {
      return add(at.target, at.leg.branch, at.ends_leg) ? Verdict::go_on : Verdict::refuse;
    });
  }
  cycle.fields.truncate(std::ssize(cycle.increments));
  quantities.finish();
  cycle.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return cycle;
}

}  // namespace

CycleRun former_cycle_run(const Case& input) {
  const auto model = std::make_shared<const FormerModel>(make_former_model(input));
  return [model, solver = std::make_shared<FormerSolver>(*model), &input](double direction,
                                                                          const ProgressCallback& progress) {
    return run_former_cycle(*model, *solver, direction, input.settings.get<CycleSettings>(), progress);
  };
}

}  // namespace bumpfoil
