#include "experiments/cycle/cycle_recorder.hpp"

#include <utility>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/motion/march.hpp"
#include "experiments/cycle/increment_log.hpp"

namespace bumpfoil {
namespace {

/// Observes and records a cycle.
class CycleRecorder {
 public:
  CycleRecorder(FoilStepper& stepper, Recording recording, Cycle cycle)
      : stepper_(stepper),
        keeps_curve_(recording == Recording::curve),
        normal_(unit_vector(cycle.direction)),
        cycle_(std::move(cycle)),
        log_(stepper, recording, cycle_),
        quantities_(cycle_) {}

  /// Adds the next increment. @return whether the cycle may continue
  /// @param displacement  its end; if prescribed, without round-off
  bool add(const Step& step, Branch branch, bool ends_leg, double displacement) {
    // The residual of a cycle is sampled at the same increments, whatever is recorded. This includes the last: its work
    // is the loop energy.
    const bool checked = ends_leg || !cycle_.start;
    const Increment next = log_.make(step, branch, normal_, displacement, checked);
    between_.clear();
    for (const Waypoint& point : step.waypoints) {
      between_.push_back({point.position.dot(normal_), cleared(point.force.dot(normal_), foils().round_off.force)});
    }
    quantities_.add(next, checked && step.converged(), ends_leg, between_);
    if (next.index == 0 && step.converged()) {
      cycle_.initial_journal_load = interface_loads(foils(), step.state.contacts, Interface::journal_top).sum();
    }
    log_.write_down(step, next, normal_);
    if (keeps_curve_ && next.converged()) draw(step, next);
    return next.converged();
  }

  /// Marks the current state as the turning point.
  void turn(const BearingState& state, Control control) {
    if (control == Control::load) cycle_.amplitude = cycle_.turns.front().displacement - cycle_.start->displacement;
    const auto loads = [&](Interface interface) { return interface_loads(foils(), state.contacts, interface); };
    TurningPoint response;
    response.tangent = stepper_.tangents(state).along(normal_);
    response.journal_loads = loads(Interface::journal_top);
    response.bump_loads = loads(Interface::top_bump);
    response.foot_loads = loads(Interface::bump_sleeve);
    const Eigen::Matrix2Xd forces = pad_forces(foils(), state.contacts.normal_force);
    response.pad_forces_x = forces.row(0);
    response.pad_forces_y = forces.row(1);
    response.strip_loads = strip_loads(foils(), state.contacts);
    quantities_.turn(std::move(response));
  }

  [[nodiscard]] bool turned() const { return cycle_.turning_point.has_value(); }

  Cycle finish(bool interrupted) {
    if (interrupted) cycle_.status = Status::interrupted;
    log_.finish();
    quantities_.finish();
    return std::move(cycle_);
  }

 private:
  [[nodiscard]] const BearingModel& foils() const { return stepper_.foils(); }

  void draw(const Step& step, const Increment& next) {
    for (const Waypoint& point : step.waypoints) {
      cycle_.curve.push_back({point.position.dot(normal_), point.force, point.pad_forces});
    }
    cycle_.curve.push_back(
        {next.displacement, {next.force_x, next.force_y}, pad_forces(foils(), step.state.contacts.normal_force)});
  }

  FoilStepper& stepper_;
  bool keeps_curve_;
  Eigen::Vector2d normal_;
  Cycle cycle_;
  IncrementLog log_;
  CycleQuantities quantities_;
  std::vector<LoadingCurve::Point> between_;
};

}  // namespace

Cycle run_cycle(FoilStepper& stepper, const CyclePlan& plan, Cycle cycle, Step& step,
                const ProgressCallback& progress) {
  const int due = increments_of(plan.program);
  const Eigen::Vector2d normal = unit_vector(cycle.direction);
  cycle.due = due;
  if (cycle.course == Course::one_sided && step.converged()) {
    const BearingModel& foils = stepper.foils();
    const Vector& gap = step.state.contacts.gap;
    for (int line = 0; line < foils.journal_contacts(); ++line) {
      const auto first = first_contact_displacement(gap(foils.pressed(line)), foils.normals_on(line), normal);
      if (first) cycle.first_contact = std::min(cycle.first_contact.value_or(*first), *first);
    }
    if (cycle.first_contact) *cycle.first_contact += step.state.position.dot(normal);
  }
  CycleRecorder recorder(stepper, plan.recording, std::move(cycle));
  int done = 0;
  const auto stopped = [&] { return progress && !progress(static_cast<double>(++done) / due); };

  step.state.work = step.state.dissipated_energy = 0.0;
  BearingState state = step.state;
  const bool good = recorder.add(step, plan.program.front().branch, false, state.position.dot(normal));
  bool interrupted = good && stopped();
  if (good && !interrupted) {
    const BearingStepper take = stepper_of(stepper, largest_place(plan.program), plan.reach);
    march(take, schedule_of(plan.program), state, step, [&](const Passage& at) {
      const double displacement = at.leg.control == Control::displacement ? at.leg.line.base.dot(normal) + at.target
                                                                          : at.step.state.position.dot(normal);
      if (!recorder.add(at.step, at.leg.branch, at.ends_leg, displacement)) return Verdict::refuse;
      if (at.ends_leg && !recorder.turned()) recorder.turn(at.step.state, at.leg.control);
      const bool is_last = at.ends_leg && &at.leg == &plan.program.back();
      interrupted = stopped() && !is_last;
      return interrupted ? Verdict::stop : Verdict::go_on;
    });
  }
  step.state = std::move(state);
  return recorder.finish(interrupted);
}

}  // namespace bumpfoil
