#include "bumpfoil/experiments/vibration/vibration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "bearing/settling.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/motion/march.hpp"
#include "experiments/cycle/orbit_energy.hpp"
#include "experiments/vibration/loaded_foils.hpp"

namespace bumpfoil {
namespace {

constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();

/// Index of a vibration in a result.
std::size_t place_of(const VibrationSettings& vibration, std::size_t load, std::size_t motion, std::size_t amplitude) {
  return (load * vibration.motions() + motion) * vibration.amplitudes.size() + amplitude;
}

/// A full circle from its point on the side of +X.
Program circle(const Eigen::Vector2d& centre, double radius, Sense sense, int steps) {
  const double turn = (sense == Sense::counterclockwise ? 2.0 : -2.0) * std::numbers::pi;
  const auto point = [&](int step) -> Eigen::Vector2d {
    return centre + radius * unit_vector(turn * (step % steps) / steps);
  };
  Program program;
  for (int k = 1; k <= steps; ++k) program.push_back(straight_leg(Control::displacement, point(k - 1), point(k), 1));
  return program;
}

class VibrationRunner {
 public:
  VibrationRunner(const Case& input, const ProgressCallback& progress)
      : vibration_(input.settings.get<VibrationSettings>()),
        progress_(progress),
        foils_(input),
        all_(vibration_.loads.size() * vibration_.motions() * vibration_.amplitudes.size()) {}

  VibrationResult run() {
    for (const Eigen::Vector2d& load : vibration_.loads) {
      result_.loads.push_back(go_to(load));
      for (std::size_t motion = 0; motion < vibration_.motions(); ++motion) {
        for (const double amplitude : vibration_.amplitudes) {
          result_.vibrations.push_back(vibration_.orbits() ? circle_round(static_cast<Sense>(motion), amplitude)
                                                           : vibrate(vibration_.directions[motion], amplitude));
        }
      }
    }
    return std::move(result_);
  }

 private:
  /// Takes the foils to a load.
  StaticLoad go_to(const Eigen::Vector2d& load) {
    if (!stopped_) return foils_.go_to(load);
    StaticLoad out;
    out.load = load;
    out.status = Status::interrupted;
    return out;
  }

  /// Vibrates about the last load.
  Vibration vibrate(double direction, double amplitude) {
    Vibration out;
    out.cycle.status = stopped_ ? Status::interrupted : result_.loads.back().status;
    if (!out.cycle.converged()) {
      out.cycle.direction = direction;
      out.cycle.amplitude = amplitude;
      return out;
    }
    out.cycle = foils_.vibrate(direction, amplitude, [this](double fraction) { return goes_on(fraction); });
    if (out.cycle.converged()) out.harmonic = first_harmonic(out.cycle.curve);
    return out;
  }

  /// Moves on a circle about the position of the last load.
  Vibration circle_round(Sense sense, double radius) {
    const StaticLoad& about = result_.loads.back();
    Vibration out;
    out.sense = sense;
    Cycle& cycle = out.cycle;
    cycle.amplitude = radius;
    cycle.status = stopped_ ? Status::interrupted : about.status;
    if (!cycle.converged()) return out;
    const auto begin = std::chrono::steady_clock::now();
    const Program orbit = circle(about.position, radius, sense, 4 * vibration_.steps);
    BearingState state = foils_.state();
    const Program approach{
        straight_leg(Control::displacement, about.position, orbit.front().line.base, vibration_.steps)};
    take(approach, state, cycle, nullptr);
    for (int loop = 0; loop < most_vibration_loops && cycle.converged() && !cycle.settled; ++loop) {
      const double work = state.work;
      const double dissipated = state.dissipated_energy;
      std::vector<Eigen::Vector2d> forces;
      cycle.curve.clear();
      take(orbit, state, cycle, &forces);
      if (!cycle.converged()) break;
      std::vector<OrbitPoint> points;
      for (std::size_t i = 0; i < forces.size(); ++i)
        points.push_back({orbit[i].line.place(orbit[i].begin), forces[i]});
      const double energy_round_off = foils_.stepper().foils().round_off.energy;
      cycle.loop_energy = orbit_energy(cleared(state.work - work, energy_round_off),
                                       cleared(state.dissipated_energy - dissipated, energy_round_off), points);
      cycle.loop_energies.push_back(*cycle.loop_energy);
      cycle.settled = is_settled(cycle.loop_energies);
      out.harmonic = orbit_harmonic(forces, radius);
      if (!goes_on(static_cast<double>(loop + 1) / most_vibration_loops) && !cycle.settled) {
        cycle.status = Status::interrupted;
      }
    }
    if (!cycle.converged()) out.harmonic.reset();
    cycle.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
  }

  /// Takes foils through a program.
  /// @param forces  receives those at the start of each increment; may be null
  void take(const Program& program, BearingState& state, Cycle& cycle, std::vector<Eigen::Vector2d>* forces) {
    FoilStepper& stepper = foils_.stepper();
    Step step;
    const BearingStepper one_step = stepper_of(stepper, largest_place(program), foils_.reach());
    march(one_step, schedule_of(program), state, step, [&](const Passage& at) {
      if (forces != nullptr) {
        const Vector& loads = at.from.contacts.normal_force;
        forces->push_back(holding_force(stepper.foils(), loads));
        cycle.curve.push_back({at.from.position.x(), forces->back(), pad_forces(stepper.foils(), loads)});
      }
      cycle.cost += at.step.cost;
      cycle.substeps += at.step.substeps;
      cycle.status = at.step.status;
      if (!at.step.converged()) return Verdict::refuse;
      Increment increment;
      check_increment(stepper.foils(), at.step.state, increment);
      const SolverBounds bounds = stepper.bounds();
      if (!increment.residuals.within(bounds.force, bounds.displacement)) cycle.status = Status::residual_above_bound;
      cycle.max_residual = std::max(cycle.max_residual, increment.residuals.equilibrium);
      return cycle.converged() ? Verdict::go_on : Verdict::refuse;
    });
  }

  /// Reports progress. @return whether to continue
  bool goes_on(double fraction) {
    stopped_ = progress_ &&
               !progress_((static_cast<double>(result_.vibrations.size()) + fraction) / static_cast<double>(all_));
    return !stopped_;
  }

  const VibrationSettings& vibration_;
  const ProgressCallback& progress_;
  LoadedFoils foils_;
  std::size_t all_;
  bool stopped_{};
  VibrationResult result_;
};

/// From an orbit in either direction, see orbit_harmonic().
LinearFoils linear_foils_of(const FirstHarmonic& counterclockwise, const FirstHarmonic& clockwise) {
  const FirstHarmonic& a = counterclockwise;
  const FirstHarmonic& b = clockwise;
  LinearFoils foils;
  foils.residual = std::max(a.residual, b.residual);
  foils.loss_factor = {not_computed, not_computed};
  foils.stiffness << 0.5 * (a.stiffness + b.stiffness), 0.5 * (b.loss - a.loss);
  foils.loss << 0.5 * (a.loss + b.loss), 0.5 * (a.stiffness - b.stiffness);
  return foils;
}

/// A vibration with a known response, and its direction.
struct Answer {
  Eigen::Vector2d direction;
  const Vibration& vibration;
};

/// The matrix M with M n = the part of the harmonic, for the direction n of each vibration.
Eigen::Matrix2d matrix_of(const std::vector<Answer>& answers, Eigen::Vector2d FirstHarmonic::*part) {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Constant(answers.size() == 2 ? 0.0 : not_computed);
  for (const auto& [n, vibration] : answers) {
    const Eigen::Vector2d& column = (*vibration.harmonic).*part;
    if (answers.size() == 2) {
      matrix += column * n.transpose();
    } else if (n.x() == 0.0 || n.y() == 0.0) {
      matrix.col(n.x() == 0.0 ? 1 : 0) = column * n.sum();
    }
  }
  return matrix;
}

LinearFoils linear_foils_of(const std::vector<Answer>& answers) {
  LinearFoils foils{.stiffness = matrix_of(answers, &FirstHarmonic::stiffness),
                    .loss = matrix_of(answers, &FirstHarmonic::loss),
                    .residual = not_computed,
                    .loss_factor = {not_computed, not_computed}};
  for (const auto& [n, vibration] : answers) {
    foils.residual = std::fmax(foils.residual, vibration.harmonic->residual);  // ignores NaN
    if (n.x() != 0.0 && n.y() != 0.0) continue;
    foils.loss_factor[n.x() == 0.0 ? 1 : 0] = vibration.cycle.loss_factor.value_or(not_computed);
  }
  return foils;
}

}  // namespace

Vector largest_pad_forces(const Vibration& vibration) {
  if (!vibration.harmonic) return {};
  Vector largest = Vector::Zero(vibration.cycle.curve.front().pad_forces.cols());
  for (const LoopPoint& point : vibration.cycle.curve) {
    largest = largest.cwiseMax(point.pad_forces.colwise().norm().transpose());
  }
  return largest;
}

bool VibrationResult::converged() const {
  return std::all_of(vibrations.begin(), vibrations.end(),
                     [](const Vibration& vibration) { return vibration.cycle.converged(); });
}

VibrationResult run_vibration(const Case& input, const ProgressCallback& progress) {
  return VibrationRunner(input, progress).run();
}

std::vector<LinearFoils> linear_foils(const VibrationSettings& vibration, const VibrationResult& result) {
  std::vector<LinearFoils> all;
  for (std::size_t load = 0; load < vibration.loads.size(); ++load) {
    for (std::size_t amplitude = 0; amplitude < vibration.amplitudes.size(); ++amplitude) {
      std::vector<Answer> answers;
      for (std::size_t motion = 0; motion < vibration.motions(); ++motion) {
        const Vibration& one = result.vibrations[place_of(vibration, load, motion, amplitude)];
        if (one.harmonic) answers.push_back({unit_vector(one.cycle.direction), one});
      }
      const bool orbits = vibration.orbits();
      LinearFoils& foils = all.emplace_back(
          !orbits               ? linear_foils_of(answers)
          : answers.size() == 2 ? linear_foils_of(*answers[0].vibration.harmonic, *answers[1].vibration.harmonic)
                                : linear_foils_of({}));
      foils.load = vibration.loads[load];
      foils.amplitude = vibration.amplitudes[amplitude];
    }
  }
  return all;
}

}  // namespace bumpfoil
