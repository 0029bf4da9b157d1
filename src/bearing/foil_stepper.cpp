#include "bumpfoil/bearing/foil_stepper.hpp"

#include <utility>
#include <vector>

#include "bumpfoil/bearing/energy.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

/// (1 - fraction) begin + fraction end; an empty vector counts as zero.
Vector between(const Vector& begin, const Vector& end, double fraction) {
  if (begin.size() == 0) return end.size() == 0 ? Vector() : Vector(fraction * end);
  if (end.size() == 0) return (1.0 - fraction) * begin;
  return (1.0 - fraction) * begin + fraction * end;
}

Excitation between(const Excitation& begin, const Excitation& end, double fraction) {
  return {.position = (1.0 - fraction) * begin.position + fraction * end.position,
          .gap_offset = between(begin.gap_offset, end.gap_offset, fraction),
          .top_load = between(begin.top_load, end.top_load, fraction)};
}

SharedBearing without_film(SharedBearing foils) {
  if (!foils->film) return foils;
  throw Error(ErrorKind::input, {{"", 0, "", "", "this bearing has a film", "advance it by a FilmStepper"}});
}

}  // namespace

BearingState BearingState::unstressed(const BearingModel& foils) {
  BearingState state;
  state.loading = ContactLoading::none(foils.problem);
  state.contacts = ContactState::unstressed(foils.problem);
  state.begin_increment();
  return state;
}

FoilStepper::FoilStepper(SharedBearing foils, const FollowerMaker& make_follower)
    : foils_(without_film(std::move(foils))),
      modes_(make_mode_system(foils_->problem)),
      follower_(make_follower(SharedProblem({foils_, &foils_->problem}), modes_)),
      dissipation_(foils_->problem),
      rate_(ContactState::unstressed(foils_->problem)) {}

bool FoilStepper::set_foils(const SharedBearing& foils) {
  if (!is_same(foils_->problem, foils->problem)) return false;
  foils_ = foils;
  return true;
}

void FoilStepper::assemble(const Excitation& excitation, Step& step) {
  const BearingState unstressed = BearingState::unstressed(*foils_);
  step.state = unstressed;
  static_cast<Excitation&>(step.state) = excitation;
  step.state.loading = loading_under(*foils_, excitation);
  step.events.clear();
  step.waypoints.clear();
  step.substeps = 0;
  step.is_linear = false;
  const SolveReport solve = follower_->assemble(step.state.loading, unstressed.contacts, step.state.contacts);
  step.status = solve.status;
  step.cost = solve.cost;
  if (!step.converged()) return;
  step.state.dissipated_energy =
      dissipation_.of(step.state.contacts.normal_force, unstressed.contacts.x, step.state.contacts.x);
}

void FoilStepper::set_out(const BearingState& from, const Excitation& end) {
  path_begin_ = from;
  path_end_ = end;
  follower_->set_out({.begin = from.loading, .end = loading_under(*foils_, end)}, from.contacts);
  gap_change_ = follower_->path().end.initial_gap - follower_->path().begin.initial_gap;
  followed_ = 0.0;
}

void FoilStepper::advance_to(double fraction, const BearingState& from, Step& step) {
  BUMPFOIL_ASSERT(&from != &step.state);
  step.state = from;
  static_cast<Excitation&>(step.state) = between(path_begin_, path_end_, fraction);
  step.events.clear();
  step.waypoints.clear();
  step.is_linear = true;
  const auto position_at = [&](double part) -> Eigen::Vector2d {
    return (1.0 - part) * path_begin_.position + part * path_end_.position;
  };
  const auto visit = [&](const ResponsePart& part) {
    const Vector& begin = part.begin.normal_force;
    const Vector& end = part.end.normal_force;
    step.state.slip_origin = part.begin.x;
    step.is_linear = step.is_linear && part.linear;
    if (part.fraction < fraction) {
      step.waypoints.push_back({position_at(part.fraction), holding_force(*foils_, end), pad_forces(*foils_, end)});
    }
    mean_force_ = 0.5 * (begin + end);
    step.state.work += (part.fraction - followed_) * gap_work(mean_force_, gap_change_);
    step.state.work += work_of_moment(*foils_, part.end.x) - work_of_moment(*foils_, part.begin.x);
    followed_ = part.fraction;
    step.state.dissipated_energy += dissipation_.of(part.linear ? mean_force_ : end, part.begin.x, part.end.x);
  };
  events_.clear();
  const FollowReport report = follower_->follow_to(fraction, step.state.contacts, visit, events_);
  for (const ContactEvent& event : events_) {
    step.events.push_back({position_at(event.fraction), event.contact, event.from, event.to});
  }
  step.status = report.status;
  step.cost = report.cost;
  step.substeps = report.substeps;
  step.state.dissipated_energy += report.jump_dissipation;
  if (step.converged()) follower_->path().at(fraction, step.state.loading);
}

void FoilStepper::advance(const BearingState& from, const Excitation& to, Step& step) {
  set_out(from, to);
  advance_to(1.0, from, step);
}

TangentMatrices FoilStepper::tangents(const BearingState& state) {
  const ContactProblem& problem = foils_->problem;
  if (problem.law) modes_->set_elasticity(problem.law->tangent(state.contacts.x));
  const Vector at_rest = Vector::Zero(problem.K.rows());
  const auto stiffness = [&](const std::vector<ContactMode>& modes) -> std::optional<Eigen::Matrix2d> {
    if (!modes_->set_modes(modes)) return std::nullopt;
    Eigen::Matrix2d K;
    for (const int axis : {0, 1}) {
      modes_->solve(loading_rate(*foils_, Eigen::Vector2d::Unit(axis)), at_rest, rate_);
      K.col(axis) = holding_force(*foils_, rate_.normal_force);
    }
    return K;
  };
  std::vector<ContactMode> sticking = state.contacts.mode;
  for (ContactMode& m : sticking) {
    if (m != ContactMode::open) m = ContactMode::stick;
  }
  return {.loading = stiffness(state.contacts.mode), .unloading = stiffness(sticking)};
}

}  // namespace bumpfoil
