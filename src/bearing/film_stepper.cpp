#include "bumpfoil/bearing/film_stepper.hpp"

#include <algorithm>
#include <utility>

#include "bearing/joint_newton.hpp"
#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

/// NewtonAim::most_vain_steps for steps in time: successful ones need two at most in all bearings tested.
constexpr int most_vain_steps_in_time = 4;

}  // namespace

OperatingPoint point_of(const BearingModel& bearing, const BearingState& state, const OperatingPoint& like) {
  OperatingPoint point{.control = like.control,
                       .journal = state.position,
                       .speed = state.speed,
                       .clearance_offset = state.clearance_offset,
                       .tilt = {like.tilt.control, state.tilt}};
  const bool by_moment = bearing.film->tilts() && like.tilt.control == Control::load;
  if (!point.by_load() && !by_moment) return point;
  const JournalVector force = journal_force(*bearing.film, state.film, state.speed);
  if (point.by_load()) point.journal = force.head<2>();
  if (by_moment) point.tilt.value = force.tail<2>();
  return point;
}

FilmStepper::FilmStepper(SharedBearing bearing, const FilmBearingOptions& options)
    : bearing_(std::move(bearing)), options_(options) {
  if (!bearing_->film) {
    throw Error(ErrorKind::input, {{"", 0, "", "", "this bearing has no film", "give one of make_film_bearing()"}});
  }
  newton_ = std::make_unique<FilmNewton>(bearing_, options.newton);
}

FilmStepper::FilmStepper(BearingModel bearing, const FilmBearingOptions& options)
    : FilmStepper(std::make_shared<const BearingModel>(std::move(bearing)), options) {}

FilmStepper::~FilmStepper() = default;

Move FilmStepper::move_to(const OperatingPoint& point, double dt, TimeScheme scheme) const {
  const auto law_of = [&](Control control, const JournalVector& value) {
    const FilmScales& scales = bearing_->film->scales;
    return control == Control::load ? loaded_journal(value, scales) : held_journal(value, scales);
  };
  const JournalLaw in_mid_plane = law_of(point.control, point.journal);
  return {.law = bearing_->film->tilts() ? with_tilt(in_mid_plane, law_of(point.tilt.control, point.tilt.value))
                                         : in_mid_plane,
          .speed = point.speed,
          .clearance_offset = point.clearance_offset,
          .dt = dt,
          .scheme = scheme};
}

FilmReport FilmStepper::solve(const Move& move, BearingState& state, bool stays_near) {
  if (options_.keep_going && !options_.keep_going()) return {.status = Status::interrupted};
  const bool finds_states = move.dt > 0.0 && move.scheme == TimeScheme::implicit_euler;
  const double tolerance = finds_states ? options_.marching_tolerance : options_.newton.step_tolerance;
  const JointMove to{law_of_one(move.law), move.speed, move.clearance_offset, move.dt, move.scheme};
  if (!newton_->set_out(to, state, state)) return {.status = Status::no_room};
  Eigen::VectorXd journal = bearing_->film->journal_of(state);
  NewtonAim aim{.tolerance = tolerance};
  if (finds_states) aim.most_vain_steps = most_vain_steps_in_time;
  if (stays_near) aim.most_vain_steps = 0;
  FilmReport report = solve_jointly({newton_.get()}, to.law, aim, options_.newton.max_iterations, journal);
  if (report.status != Status::converged) return report;
  newton_->finish(journal, state, report);
  state.time += move.dt;
  return report;
}

FilmReport FilmStepper::solve_together(const std::vector<FilmStepper*>& steppers, const JointMove& move,
                                       const std::vector<BearingState>& guesses, Eigen::VectorXd& y,
                                       std::vector<BearingState>& states) {
  std::vector<FilmNewton*> films;
  // A step in time starts so close to its solution that convergence is quadratic: after a full step shorter than this,
  // the remaining error is negligible.
  double tolerance = FilmBearingOptions().marching_tolerance;
  int max_iterations = FilmSolverOptions().max_iterations;
  for (std::size_t i = 0; i < steppers.size(); ++i) {
    const FilmBearingOptions& options = steppers[i]->options_;
    if (options.keep_going && !options.keep_going()) return {.status = Status::interrupted};
    tolerance = std::min(tolerance, move.dt > 0.0 ? options.marching_tolerance : options.newton.step_tolerance);
    max_iterations = std::min(max_iterations, options.newton.max_iterations);
    films.push_back(steppers[i]->newton_.get());
    if (!films.back()->set_out(move, states[i], guesses[i])) return {.status = Status::no_room};
  }
  FilmReport report = solve_jointly(films, move.law, {.tolerance = tolerance}, max_iterations, y);
  if (report.status != Status::converged) return report;
  for (std::size_t i = 0; i < films.size(); ++i) {
    films[i]->finish(move.law.journals[i].place(y), states[i], report);
    states[i].time += move.dt;
  }
  return report;
}

FilmReport FilmStepper::advance(const Move& move, BearingState& state) {
  state.begin_increment();
  return solve(move, state);
}

double FilmStepper::distance(const BearingState& a, const BearingState& b) const {
  return newton_->distance(a, b);
}

std::optional<SlowMotion> FilmStepper::slow_motion(const BearingState& state, bool stuck) {
  return newton_->slow_motion(state, stuck);
}

std::optional<JournalMatrix> FilmStepper::stiffness(const BearingState& state, bool stuck) {
  const std::optional<SlowMotion> motion = slow_motion(state, stuck);
  return motion ? std::optional(motion->stiffness) : std::nullopt;
}

std::optional<FilmImpedance> FilmStepper::impedance(const BearingState& state,
                                                    const std::vector<std::complex<double>>& rates, bool stuck) {
  return newton_->impedance(state, rates, stuck);
}

std::optional<std::vector<JournalMatrixC>> FilmStepper::impedances(const BearingState& state,
                                                                   const std::vector<std::complex<double>>& rates,
                                                                   bool stuck) {
  const std::optional<FilmImpedance> reduced = impedance(state, rates, stuck);
  if (!reduced) return std::nullopt;
  std::vector<JournalMatrixC> found;
  found.reserve(rates.size());
  for (const std::complex<double> rate : rates) found.push_back(reduced->at(rate));
  return found;
}

std::optional<HeldMotion> FilmStepper::held_motion(const BearingState& state, bool stuck) {
  return newton_->held_motion(state, stuck);
}

HeldMotions FilmStepper::held_motions(const BearingState& state) {
  HeldMotions motions;
  motions.sliding = held_motion(state);
  motions.stuck = state.contacts.any_slips() ? held_motion(state, true) : motions.sliding;
  return motions;
}

std::optional<bool> HeldMotions::is_stable() const {
  const auto grows = [](const std::optional<HeldMotion>& motion) { return motion && motion->rate.real() >= 0.0; };
  if (grows(sliding) || grows(stuck)) return false;
  return sliding && stuck ? std::optional(true) : std::nullopt;
}

}  // namespace bumpfoil
