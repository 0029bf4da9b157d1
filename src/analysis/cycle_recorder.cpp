#include "analysis/cycle_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/program_runner.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// Work that was neither stored nor dissipated in a response that is linear in pieces, as part of the largest work.
constexpr double largest_imbalance = 1e-7;

/// Watches whether W = E - E0 + D holds where it must.
class EnergyBalance {
 public:
  explicit EnergyBalance(double force_scale) : force_scale_(force_scale) {}

  /// An increment whose energy is known.
  void add(const Increment& increment, bool is_linear) {
    if (increment.index == 0) start_ = increment.elastic_energy;
    must_hold_ = must_hold_ && (is_linear || increment.index == 0);
    const double stored = increment.elastic_energy - start_;
    imbalance_ = std::max(imbalance_, std::abs(increment.work - stored - increment.dissipated_energy));
    // Roundings of the energies, and of forces where nothing is loaded.
    const double rounding = 1e-12 * (increment.elastic_energy + force_scale_ * std::abs(increment.displacement));
    scale_ = std::max({scale_, std::abs(increment.work), rounding / largest_imbalance});
  }

  [[nodiscard]] bool holds() const { return !must_hold_ || imbalance_ <= largest_imbalance * scale_; }

 private:
  double force_scale_;
  double start_{};      ///< E0, J
  double imbalance_{};  ///< J
  double scale_{};      ///< J
  bool must_hold_{true};
};

/// Where a contact is, as results count.
CycleEvent located(const Foils& foils, const ContactEvent& event, Branch branch, double displacement) {
  const int block = event.contact / foils.contacts_per_block();
  const int pair = event.contact % foils.contacts_per_block();
  CycleEvent out{.branch = branch,
                 .displacement = displacement,
                 .interface = pair == foils.top_bump() ? Interface::top_bump : Interface::journal_top,
                 .index = block - foils.structure.first_bump,
                 .from = event.from,
                 .to = event.to};
  if (pair >= foils.first_foot()) {
    out.interface = Interface::bump_sleeve;
    out.index = block * foils.feet_per_block() + pair - foils.first_foot();
  }
  return out;
}

/// Watches a cycle pass, and writes it down.
class CycleRecorder {
 public:
  CycleRecorder(FoilStepper& stepper, Recording recording, Cycle cycle)
      : stepper_(stepper),
        everything_(recording == Recording::everything),
        normal_(unit_vector(cycle.direction)),
        balance_(stepper.foils().problem.force_scale),
        cycle_(std::move(cycle)),
        quantities_(cycle_) {
    if (!everything_) return;
    cycle_.increments.reserve(static_cast<std::size_t>(cycle_.due));
    cycle_.fields = make_fields(stepper.foils(), cycle_.due);
  }

  /// The next increment. @return whether the cycle may go on
  /// @param displacement  where it led; if that was prescribed not a rounding beside it
  bool add(const Step& step, Branch branch, bool ends_leg, double displacement) {
    Increment next = step.converged() ? place_increment(foils(), step, normal_) : failed_increment(step, normal_);
    next.index = count_;
    next.branch = branch;
    next.displacement = displacement;
    // The last, too, whose work is the loop's energy.
    const bool judged = step.converged() && (everything_ || ends_leg || count_ == 0);
    if (judged) {
      judge(foils(), step.state, next);
      const SolverBounds bounds = stepper_.bounds();
      if (!next.residuals.within(bounds.force, bounds.displacement)) next.status = Status::residual_above_bound;
    }
    if (next.converged() && judged) balance_.add(next, step.is_linear);
    if (count_ + 1 == cycle_.due && !balance_.holds()) next.status = Status::energy_defect;
    way_.clear();
    for (const Waypoint& point : step.waypoints) {
      way_.push_back({point.position.dot(normal_), cleared(point.force.dot(normal_), foils().roundings.force)});
    }
    quantities_.add(next, judged, ends_leg, way_);
    if (count_ == 0 && step.converged()) {
      cycle_.initial_journal_load = interface_loads(foils(), step.state.contacts, Interface::journal_top).sum();
    }
    if (everything_) write_down(step, next);
    ++count_;
    return next.converged();
  }

  /// The turning point is where the foils are now.
  void turn(const FoilState& state, Control control) {
    if (control == Control::load) cycle_.amplitude = cycle_.turns.front().displacement - cycle_.start->displacement;
    const auto loads = [&](Interface interface) { return interface_loads(foils(), state.contacts, interface); };
    TurningPoint response;
    response.tangent = stepper_.tangents(state).along(normal_);
    response.journal_loads = loads(Interface::journal_top);
    response.bump_loads = loads(Interface::top_bump);
    response.foot_loads = loads(Interface::bump_sleeve);
    quantities_.turn(std::move(response));
  }

  [[nodiscard]] bool turned() const { return cycle_.turning_point.has_value(); }

  Cycle finish(bool interrupted) {
    if (interrupted) cycle_.status = Status::interrupted;
    cycle_.fields.truncate(rows_);
    quantities_.finish();
    return std::move(cycle_);
  }

 private:
  [[nodiscard]] const Foils& foils() const { return stepper_.foils(); }

  void write_down(const Step& step, const Increment& next) {
    const auto displacement = [&](double fraction) {
      return ((1.0 - fraction) * step.path_begin + fraction * step.path_end).dot(normal_);
    };
    for (const ContactEvent& event : step.events) {
      cycle_.events.push_back(located(foils(), event, next.branch, displacement(event.fraction)));
    }
    cycle_.increments.push_back(next);
    if (!step.converged()) return;
    record(foils(), step.state, rows_, cycle_.fields);
    ++rows_;
  }

  FoilStepper& stepper_;
  bool everything_;
  Eigen::Vector2d normal_;
  EnergyBalance balance_;
  Cycle cycle_;
  CycleQuantities quantities_;
  std::vector<LoadingCurve::Point> way_;
  int count_{};          ///< increments that passed
  Eigen::Index rows_{};  ///< of them with fields
};

}  // namespace

Cycle run_cycle(FoilStepper& stepper, const CyclePlan& plan, Cycle cycle, Step& step,
                const ProgressCallback& progress) {
  const int due = increments_of(plan.program);
  const Eigen::Vector2d normal = unit_vector(cycle.direction);
  cycle.due = due;
  if (cycle.course == Course::push && step.converged()) {
    const Foils& foils = stepper.foils();
    cycle.first_contact = first_contact_displacement(step.state.contacts.gap(foils.pressed()), foils.normals, normal);
    if (cycle.first_contact) *cycle.first_contact += step.state.excitation.position.dot(normal);
  }
  CycleRecorder recorder(stepper, plan.recording, std::move(cycle));
  int done = 0;
  const auto stopped = [&] { return progress && !progress(static_cast<double>(++done) / due); };

  step.state.work = step.state.dissipated_energy = 0.0;
  FoilState state = step.state;
  ProgramRunner runner(stepper, plan.program, plan.reach, state);
  bool good = recorder.add(step, runner.leg().branch, false, state.excitation.position.dot(normal));
  bool interrupted = good && stopped();
  while (good && !interrupted && runner.has_next()) {
    const Leg leg = runner.leg();
    const bool ends_leg = runner.ends_leg();
    runner.try_next(step);
    good = recorder.add(step, leg.branch, ends_leg,
                        leg.control == Control::displacement ? leg.line.base.dot(normal) + runner.target()
                                                         : step.state.excitation.position.dot(normal));
    if (!good) break;
    runner.commit(step);
    if (ends_leg && !recorder.turned()) recorder.turn(state, leg.control);
    interrupted = stopped() && runner.has_next();
  }
  step.state = std::move(state);
  return recorder.finish(interrupted);
}

}  // namespace bumpfoil
