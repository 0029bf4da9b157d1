#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "experiments/fit/measured_curve.hpp"
#include "experiments/fit/measured_data.hpp"

namespace bumpfoil {
namespace {

/// Accepted deviation of the largest reading from the measured displacement, relative to its range.
constexpr double amplitude_tolerance = 1e-9;
constexpr int most_amplitudes = 20;

/// A branch of a loop as read by the rig without drift: force over increasing displacement.
struct ReadBranch {
  std::vector<double> displacements;
  std::vector<double> forces;

  /// Constant beyond its ends.
  [[nodiscard]] double at(double displacement) const {
    const auto above = std::upper_bound(displacements.begin(), displacements.end(), displacement);
    if (above == displacements.begin()) return forces.front();
    if (above == displacements.end()) return forces.back();
    const auto i = static_cast<std::size_t>(above - displacements.begin());
    const double width = displacements[i] - displacements[i - 1];
    return forces[i - 1] + (forces[i] - forces[i - 1]) * (displacement - displacements[i - 1]) / width;
  }
};

struct ReadLoop {
  ReadBranch push, pull;
};

/// Displacements and direct forces of a loop.
std::vector<LoadingCurve::Point> points_of(const Cycle& cycle) {
  const Eigen::Vector2d normal = unit_vector(cycle.direction);
  std::vector<LoadingCurve::Point> points;
  points.reserve(cycle.curve.size());
  for (const LoopPoint& point : cycle.curve) points.push_back({point.displacement, point.force.dot(normal)});
  return points;
}

bool is_swing(const Case& input, const FitData& data) {
  return data.experiment == FittedExperiment::strip ? input.settings.get<StripSettings>().preload.has_value()
                                                    : input.settings.get<CycleSettings>().is_fully_reversed();
}

Case case_of_loop(Case input, const FitData& data) {
  const bool whole_legs = input.solver.chosen() == SolverName::events;  // which follows whole legs exactly
  const Target amplitude{Control::displacement,
                         *std::max_element(data.displacements.begin(), data.displacements.end())};
  if (data.experiment == FittedExperiment::strip) {
    input.settings.keep_only<StripSettings>();
    StripSettings& strip = input.settings.get<StripSettings>();
    if (whole_legs) strip.steps = 1;
    strip.amplitude = amplitude;
    return input;
  }
  input.settings.keep_only<CycleSettings>();
  auto& cycle = input.settings.get_or_create<CycleSettings>();
  if (whole_legs) cycle.steps = 1;
  cycle.directions = {data.direction};
  cycle.amplitude = amplitude;
  if (data.preload) cycle.preload = data.preload;
  return input;
}

/// Loops of one bearing, or strip, with any amplitude.
class LoopRunner {
 public:
  LoopRunner(Case input, FittedExperiment experiment) : input_(std::move(input)), experiment_(experiment) {
    if (experiment == FittedExperiment::cycle) runner_.emplace(make_bearing_foils(input_, {"cycle"}), input_.solver);
  }

  /// Absent if the run fails. @throws Error (input) if the foils cannot be built
  std::optional<std::vector<LoadingCurve::Point>> run(double amplitude) {
    const Target target{Control::displacement, amplitude};
    if (experiment_ == FittedExperiment::cycle) {
      CycleSettings& settings = input_.settings.get<CycleSettings>();
      settings.amplitude = target;
      const Cycle cycle = runner_->run(settings.directions.front(), settings, Recording::curve);
      return cycle.converged() ? std::optional(points_of(cycle)) : std::nullopt;
    }
    input_.settings.get<StripSettings>().amplitude = target;
    const CycleResult result = run_strip(input_, {}, Recording::curve);
    return result.converged() ? std::optional(points_of(result.cycles.back())) : std::nullopt;
  }

 private:
  Case input_;
  FittedExperiment experiment_;
  std::optional<CycleRunner> runner_;
};

/// Appends points as read by the rig to a branch, if they advance; by increasing displacement.
void append(ReadBranch& branch, std::vector<LoadingCurve::Point>::const_iterator from,
            std::vector<LoadingCurve::Point>::const_iterator to, double middle, double compliance, const Rig& rig) {
  for (; from != to; ++from) {
    const double read = from->displacement - middle + compliance * from->force + rig.displacement_origin;
    if (!branch.displacements.empty() && read <= branch.displacements.back()) continue;
    branch.displacements.push_back(read);
    branch.forces.push_back(from->force);
  }
}

/// The loop as read by the rig, reversed at the largest measured displacement.
std::optional<ReadLoop> read_loop(LoopRunner& runner, const MeasuredCurve& curve, bool fully_reversed, const Rig& rig) {
  const double compliance = rig.machine_stiffness ? 1.0 / *rig.machine_stiffness : 0.0;
  const double reach = fully_reversed
                           ? 0.5 * (curve.top() - curve.bottom())
                           : curve.top() - rig.displacement_origin - rig.displacement_drift * curve.tau_at_top();
  double amplitude = reach;
  double last_amplitude = 0.0;
  double last_read = 0.0;
  for (int i = 0; i < most_amplitudes; ++i) {
    if (!(amplitude > 0.0)) return std::nullopt;
    const auto loop = runner.run(amplitude);
    if (!loop) return std::nullopt;
    const auto displaced_less = [](const auto& a, const auto& b) { return a.displacement < b.displacement; };
    const auto top = std::max_element(loop->begin(), loop->end(), displaced_less);
    const auto bottom = fully_reversed ? std::min_element(top, loop->end(), displaced_less) : loop->end() - 1;
    const double pressing = fully_reversed ? 0.5 * (top->force - bottom->force) : top->force;
    const double read = amplitude + compliance * pressing;
    if (std::abs(read - reach) <= amplitude_tolerance * curve.displacement_range()) {
      const double middle = fully_reversed ? 0.5 * (top->displacement + bottom->displacement) : 0.0;
      ReadLoop result;
      const std::vector<LoadingCurve::Point> falling(std::make_reverse_iterator(bottom + 1),
                                                     std::make_reverse_iterator(top));
      append(result.pull, falling.begin(), falling.end(), middle, compliance, rig);
      append(result.push, fully_reversed ? bottom : loop->end(), loop->end(), middle, compliance, rig);
      append(result.push, loop->begin(), top + 1, middle, compliance, rig);
      return result;
    }
    // Secant; the first from the origin, where the machine is unloaded.
    const double slope = (read - last_read) / (amplitude - last_amplitude);
    last_read = read;
    last_amplitude = amplitude;
    amplitude += (reach - read) / slope;
  }
  return std::nullopt;
}

class MeasuredLoopData final : public MeasuredData {
 public:
  MeasuredLoopData(const FitData& data, const Case& input)
      : data_(data),
        curve_(data, is_swing(case_of_loop(input, data), data)),
        noise_(data.force_std.value_or(curve_.scatter())) {
    measured_.experiment = data.experiment;
    measured_.axis = "Displacement";
    measured_.axis_unit = "m";
    measured_.series = {"push", "pull"};
    measured_.quantities = {{.column = FitColumn::force, .noise = noise_}};
    const std::vector<double> at = curve_.means([](const Reading& one) { return one.displacement; });
    const std::vector<double> forces = curve_.means([](const Reading& one) { return one.force; });
    const std::vector<double> pulls = curve_.means([](const Reading& one) { return one.pull ? 1.0 : 0.0; });
    for (std::size_t k = 0; k < curve_.points(); ++k) {
      measured_.points.push_back({.series = pulls[k] > 0.5 ? std::size_t{1} : std::size_t{0},
                                  .at = at[k],
                                  .measured = forces[k],
                                  .readings = curve_.counts()[k]});
    }
  }

  [[nodiscard]] Case case_for(Case input) const override { return case_of_loop(std::move(input), data_); }

  [[nodiscard]] std::optional<DataAnswer> answer(const Case& input, const Rig& rig) const override {
    LoopRunner runner(input, data_.experiment);
    const std::optional<ReadLoop> loop = read_loop(runner, curve_, is_swing(input, data_), rig);
    if (!loop) return std::nullopt;
    const auto branch_of = [&loop](const Reading& one) -> const ReadBranch& {
      return one.pull ? loop->pull : loop->push;
    };
    const auto place_of_reading = [&rig](const Reading& one) {
      return one.displacement - rig.displacement_drift * one.tau;
    };
    DataAnswer all;
    all.fitted = curve_.means([&](const Reading& one) {
      return branch_of(one).at(place_of_reading(one)) + rig.force_origin + rig.force_drift * one.tau;
    });
    const double width = data_.displacement_std;
    const std::vector<double> slopes = curve_.means([&](const Reading& one) {
      if (!(width > 0.0)) return 0.0;
      const ReadBranch& branch = branch_of(one);
      const double place = place_of_reading(one);
      return std::abs(branch.at(place + width) - branch.at(place - width)) / (2.0 * width);
    });
    // All points have equal weight except for their slope: that of the mean number of readings.
    const double mean_readings = static_cast<double>(curve_.readings().size()) / static_cast<double>(curve_.points());
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      const double of_reading = std::hypot(noise_, slopes[k] * width);
      all.std.push_back(of_reading / std::sqrt(curve_.counts()[k]));
      all.weights.push_back(of_reading / std::sqrt(mean_readings));
    }
    return all;
  }

 private:
  FitData data_;
  MeasuredCurve curve_;
  double noise_;  ///< standard deviation of one force reading, N
};

}  // namespace

std::unique_ptr<const MeasuredData> measured_loop(const FitData& data, const Case& input) {
  return std::make_unique<MeasuredLoopData>(data, input);
}

}  // namespace bumpfoil
