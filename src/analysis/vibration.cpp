#include "bumpfoil/analysis/vibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/cycle_series.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Where a vibration stands among those of a result.
std::size_t place_of(const VibrationSettings& vibration, std::size_t load, std::size_t direction,
                     std::size_t amplitude) {
  return (load * vibration.directions.size() + direction) * vibration.amplitudes.size() + amplitude;
}

class VibrationRunner {
 public:
  VibrationRunner(const Case& input, const ProgressCallback& progress)
      : vibration_(*input.vibration),
        progress_(progress),
        stepper_(make_bearing_foils(input), input.solver),
        reach_(stepper_.foils().clearance + stepper_.foils().rise),
        all_(vibration_.loads.size() * vibration_.directions.size() * vibration_.amplitudes.size()) {}

  VibrationResult run() {
    for (const Eigen::Vector2d& load : vibration_.loads) {
      result_.loads.push_back(go_to(load));
      for (const double direction : vibration_.directions) {
        for (const double amplitude : vibration_.amplitudes)
          result_.vibrations.push_back(vibrate(direction, amplitude));
      }
    }
    return std::move(result_);
  }

 private:
  /// Takes the foils to a load.
  StaticLoad go_to(const Eigen::Vector2d& load) {
    StaticLoad out;
    out.load = load;
    out.status = Status::interrupted;
    if (stopped_) return out;
    approach(stepper_, {.preload = PlaneTarget{Control::load, load}, .steps = vibration_.steps, .reach = reach_},
             loaded_);
    out.status = loaded_.status;
    if (!loaded_.converged()) return out;
    out.position = loaded_.state.excitation.position;
    out.tangents = stepper_.tangents(loaded_.state);
    return out;
  }

  /// Vibrates about the last load.
  Vibration vibrate(double direction, double amplitude) {
    const StaticLoad& about = result_.loads.back();
    Vibration out;
    out.cycle.status = stopped_ ? Status::interrupted : about.status;
    if (!out.cycle.converged()) {
      out.cycle.direction = direction;
      out.cycle.amplitude = amplitude;
      return out;
    }
    const CycleCourse course{.direction = direction,
                             .amplitude = {Control::displacement, amplitude},
                             .preload = PlaneTarget{Control::load, about.load},
                             .swings = true,
                             .steps = vibration_.steps,
                             .reach = reach_};
    Step step = loaded_;
    CycleSeries series(stepper_, course, step);
    out.cycle = series.until_settled(most_vibration_loops, Recording::curve, [this](double fraction) {
      stopped_ = progress_ &&
                 !progress_((static_cast<double>(result_.vibrations.size()) + fraction) / static_cast<double>(all_));
      return !stopped_;
    });
    if (out.cycle.converged()) out.harmonic = first_harmonic(out.cycle.curve);
    return out;
  }

  const VibrationSettings& vibration_;
  const ProgressCallback& progress_;
  FoilStepper stepper_;
  double reach_;
  std::size_t all_;
  Step loaded_;  ///< how the last load was reached
  bool stopped_{};
  VibrationResult result_;
};

/// A vibration that is known, and where it goes.
struct Answer {
  Eigen::Vector2d direction;
  const Vibration& vibration;
};

/// The matrix M with M n = the part of the harmonic, for the direction n of each answer.
Eigen::Matrix2d matrix_of(const std::vector<Answer>& answers, Eigen::Vector2d FirstHarmonic::*part) {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Constant(answers.size() == 2 ? 0.0 : unknown);
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
                    .residual = unknown,
                    .loss_factor = {unknown, unknown}};
  for (const auto& [n, vibration] : answers) {
    foils.residual = std::fmax(foils.residual, vibration.harmonic->residual);  // not a number is none
    if (n.x() != 0.0 && n.y() != 0.0) continue;
    foils.loss_factor[n.x() == 0.0 ? 1 : 0] = vibration.cycle.loss_factor.value_or(unknown);
  }
  return foils;
}

}  // namespace

bool VibrationResult::converged() const {
  return std::all_of(vibrations.begin(), vibrations.end(),
                     [](const Vibration& vibration) { return vibration.cycle.converged(); });
}

VibrationResult run_vibration(const Case& input, const ProgressCallback& progress) {
  if (!input.vibration) {
    throw Error(ErrorKind::input, {{"", 0, "vibration", "", "this table is missing", "add [vibration]"}});
  }
  return VibrationRunner(input, progress).run();
}

std::vector<LinearFoils> linear_foils(const VibrationSettings& vibration, const VibrationResult& result) {
  std::vector<LinearFoils> all;
  for (std::size_t load = 0; load < vibration.loads.size(); ++load) {
    for (std::size_t amplitude = 0; amplitude < vibration.amplitudes.size(); ++amplitude) {
      std::vector<Answer> answers;
      for (std::size_t direction = 0; direction < vibration.directions.size(); ++direction) {
        const Vibration& one = result.vibrations[place_of(vibration, load, direction, amplitude)];
        if (one.harmonic) answers.push_back({unit_vector(vibration.directions[direction]), one});
      }
      LinearFoils& foils = all.emplace_back(linear_foils_of(answers));
      foils.load = vibration.loads[load];
      foils.amplitude = vibration.amplitudes[amplitude];
    }
  }
  return all;
}

}  // namespace bumpfoil
