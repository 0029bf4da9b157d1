#include "experiments/fit/fit_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "experiments/fit/fit_keys.hpp"

namespace bumpfoil {
namespace {

/// The rig reads the largest displacement to this part of the range.
constexpr double amplitude_tolerance = 1e-9;
constexpr int most_amplitudes = 20;

/// A branch of a loop as the rig would read it without drift: forces over rising displacements.
struct ReadBranch {
  std::vector<double> displacements;
  std::vector<double> forces;

  /// Beyond its ends the force stays.
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
  return data.experiment == FittedExperiment::strip ? input.strip->preload.has_value() : input.cycle.swings();
}

Case case_for(Case input, const FitData& data) {
  if (input.solver.chosen() == SolverName::events) {  // which follows whole legs exactly
    input.cycle.steps = 1;
    if (input.strip) input.strip->steps = 1;
  }
  const Target amplitude{Control::displacement,
                         *std::max_element(data.displacements.begin(), data.displacements.end())};
  if (data.experiment == FittedExperiment::strip) {
    input.strip->amplitude = amplitude;
    return input;
  }
  input.cycle.directions = {data.direction};
  input.cycle.amplitude = amplitude;
  if (data.preload) input.cycle.preload = data.preload;
  return input;
}

/// Loops of one bearing, or strip, to any displacement.
class LoopRunner {
 public:
  LoopRunner(Case input, FittedExperiment experiment) : input_(std::move(input)), experiment_(experiment) {
    if (experiment == FittedExperiment::cycle) runner_.emplace(make_bearing_foils(input_, {"cycle"}), input_.solver);
  }

  /// Absent if it fails. @throws Error (input) if the foils cannot be built
  std::optional<std::vector<LoadingCurve::Point>> run(double amplitude) {
    const Target target{Control::displacement, amplitude};
    if (experiment_ == FittedExperiment::cycle) {
      input_.cycle.amplitude = target;
      const Cycle cycle = runner_->run(input_.cycle.directions.front(), input_.cycle, Recording::curve);
      return cycle.converged() ? std::optional(points_of(cycle)) : std::nullopt;
    }
    input_.strip->amplitude = target;
    const CycleResult result = run_strip(input_, {}, Recording::curve);
    return result.converged() ? std::optional(points_of(result.cycles.back())) : std::nullopt;
  }

 private:
  Case input_;
  FittedExperiment experiment_;
  std::optional<CycleRunner> runner_;
};

/// Appends points to a branch where the rig would read them, those that go on; in the order of rising displacement.
void append(ReadBranch& branch, std::vector<LoadingCurve::Point>::const_iterator from,
            std::vector<LoadingCurve::Point>::const_iterator to, double middle, double compliance, const Rig& rig) {
  for (; from != to; ++from) {
    const double read = from->displacement - middle + compliance * from->force + rig.displacement_origin;
    if (!branch.displacements.empty() && read <= branch.displacements.back()) continue;
    branch.displacements.push_back(read);
    branch.forces.push_back(from->force);
  }
}

/// What the rig reads of a loop that turns where the largest displacement was measured.
std::optional<ReadLoop> read_loop(LoopRunner& runner, const MeasuredCurve& curve, bool swings, const Rig& rig) {
  const double compliance = rig.machine_stiffness ? 1.0 / *rig.machine_stiffness : 0.0;
  const double reach = swings ? 0.5 * (curve.top() - curve.bottom())
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
    const auto bottom = swings ? std::min_element(top, loop->end(), displaced_less) : loop->end() - 1;
    const double pressing = swings ? 0.5 * (top->force - bottom->force) : top->force;
    const double read = amplitude + compliance * pressing;
    if (std::abs(read - reach) <= amplitude_tolerance * curve.displacement_range()) {
      const double middle = swings ? 0.5 * (top->displacement + bottom->displacement) : 0.0;
      ReadLoop result;
      const std::vector<LoadingCurve::Point> falling(std::make_reverse_iterator(bottom + 1),
                                                     std::make_reverse_iterator(top));
      append(result.pull, falling.begin(), falling.end(), middle, compliance, rig);
      append(result.push, swings ? bottom : loop->end(), loop->end(), middle, compliance, rig);
      append(result.push, loop->begin(), top + 1, middle, compliance, rig);
      return result;
    }
    // The secant; at first from the origin, where the machine is not pressed.
    const double slope = (read - last_read) / (amplitude - last_amplitude);
    last_read = read;
    last_amplitude = amplitude;
    amplitude += (reach - read) / slope;
  }
  return std::nullopt;
}

}  // namespace

FitModel::FitModel(const Case& input) : settings_(*input.settings.find<FitSettings>()) {
  Case bare = input;
  bare.settings.set(FitSettings{});
  text_ = case_to_toml(bare);
  bare.settings = {};
  bare.montecarlo.reset();
  for (const FitData& data : settings_.data) {
    const Case own = case_for(bare, data);
    curves_.emplace_back(data, is_swing(own, data));
    texts_.push_back(case_to_toml(own));
  }
}

std::vector<std::string> FitModel::overrides(const std::vector<double>& values) const {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const std::string& key : keys_set_by(settings_.parameters[i].key)) {
      all.push_back(fmt::format("{}={:.17g}", key, values[i]));
    }
  }
  return all;
}

Case FitModel::case_with(const std::vector<double>& values) const {
  return parse_case(text_, "", {.overrides = overrides(values), .commands = {}});
}

Case FitModel::case_of_loop(std::size_t i, const std::vector<double>& values) const {
  return parse_case(texts_[i], "",
                    {.overrides = overrides(values), .commands = {std::string(name_of(settings_.data[i].experiment))}});
}

std::optional<std::vector<LoopForces>> FitModel::forces(const std::vector<double>& values) const {
  FitSettings settings;  // the rigs alone
  settings.machine_stiffness = settings_.machine_stiffness;
  for (const FitData& data : settings_.data) settings.data.push_back({.rig = data.rig});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& key = settings_.parameters[i].key;
    if (is_of_rig(key)) set_rig(settings, key, values[i]);
  }
  std::vector<LoopForces> all;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const FitData& data = settings_.data[i];
    Rig rig = settings.data[i].rig;
    if (!rig.machine_stiffness) rig.machine_stiffness = settings.machine_stiffness;
    std::optional<ReadLoop> loop;
    try {
      const Case input = case_of_loop(i, values);
      LoopRunner runner(input, data.experiment);
      loop = read_loop(runner, curves_[i], is_swing(input, data), rig);
    } catch (const Error&) {
      return std::nullopt;  // no such bearing
    }
    if (!loop) return std::nullopt;
    LoopForces& forces = all.emplace_back();
    for (const Reading& reading : curves_[i].readings()) {
      const ReadBranch& branch = reading.pull ? loop->pull : loop->push;
      const double displacement = reading.displacement - rig.displacement_drift * reading.tau;
      forces.at.push_back(branch.at(displacement) + rig.force_origin + rig.force_drift * reading.tau);
      const double width = data.displacement_std;
      const double rise = width > 0.0 ? branch.at(displacement + width) - branch.at(displacement - width) : 0.0;
      forces.slope.push_back(width > 0.0 ? rise / (2.0 * width) : 0.0);
    }
  }
  return all;
}

}  // namespace bumpfoil
