#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "experiments/fit/fit_columns.hpp"
#include "experiments/fit/measured_data.hpp"
#include "experiments/vibration/loaded_foils.hpp"

namespace bumpfoil {
namespace {

/// Readings between two trials are interpolated if the product of the distances from both, in amplitudes, is at most
/// this: the relative error for a curve whose slope changes by its own size over an amplitude.
constexpr double vibration_tolerance = 1e-5;
constexpr int most_vibration_trials = 50;
constexpr int fewest_steps = 2;

/// Quantities of a loop.
struct ReadVibration {
  double stiffness{}, loss_factor{};
};

/// A vibration of the foils, and the amplitude read by the rig.
struct VibrationTrial {
  double amplitude{}, read{}, stiffness{}, loss_factor{};

  /// Linear interpolation with another trial.
  [[nodiscard]] ReadVibration at(double place, const VibrationTrial& other) const {
    const double part = place == amplitude ? 0.0 : (place - amplitude) / (other.amplitude - amplitude);
    return {stiffness + part * (other.stiffness - stiffness), loss_factor + part * (other.loss_factor - loss_factor)};
  }
};

/// Rows about one load in one direction.
struct VibrationGroup {
  Eigen::Vector2d load{0.0, 0.0};
  double direction{};
  std::vector<std::size_t> rows{};
};

class MeasuredVibrationData final : public MeasuredData {
 public:
  MeasuredVibrationData(const FitData& data, const Case& input)
      : amplitudes_(data.column(FitColumn::amplitude).values), stiffnesses_(data.column(FitColumn::stiffness).values) {
    const std::vector<double>& directions = data.column(FitColumn::direction).values;
    std::vector<std::string> series;
    for (std::size_t row = 0; row < amplitudes_.size(); ++row) {
      const double direction = directions.empty() ? data.direction : directions[row];
      const bool in_columns =
          !data.column(FitColumn::load_x).values.empty() || !data.column(FitColumn::load_y).values.empty();
      const Eigen::Vector2d load = in_columns     ? load_in_row(data, row)
                                   : data.preload ? data.preload->value
                                                  : input.settings.get<VibrationSettings>().loads.front();
      const auto known = std::find_if(groups_.begin(), groups_.end(), [&](const VibrationGroup& group) {
        return group.load == load && group.direction == direction;
      });
      VibrationGroup& group = known == groups_.end() ? groups_.emplace_back() : *known;
      group.load = load;
      group.direction = direction;
      group.rows.push_back(row);
      series.push_back(
          fmt::format("load ({:.6g}, {:.6g}) N, along {:.6g} deg", load.x(), load.y(), to_degrees(direction)));
    }
    measured_ = measured_table(data);
    measured_.axis = "Amplitude";
    measured_.axis_unit = "m";
    add_table_points(measured_, data, amplitudes_, series);
  }

  [[nodiscard]] Case case_for(Case input) const override {
    input.settings.keep_only<VibrationSettings>();
    auto& vibration = input.settings.get_or_create<VibrationSettings>();
    vibration.motion = Motion::line;
    vibration.loads = {groups_.front().load};
    vibration.directions = {groups_.front().direction};
    vibration.amplitudes = {amplitudes_.front()};
    vibration.frequencies = {1.0};  // loops are independent of it
    // Exact increments are also independent of their number.
    if (input.solver.name == SolverName::events) vibration.steps = fewest_steps;
    return input;
  }

  [[nodiscard]] std::optional<DataAnswer> answer(const Case& input, const Rig& rig) const override {
    std::vector<std::optional<ReadVibration>> read(amplitudes_.size());
    tbb::parallel_for(std::size_t{0}, groups_.size(), [&](std::size_t i) {
      LoadedFoils foils(input);
      if (foils.go_to(groups_[i].load).status != Status::converged) return;
      for (const std::size_t row : groups_[i].rows) {
        read[row] = read_row(foils, groups_[i].direction, row, rig);
        if (!read[row]) return;
      }
    });
    if (std::find(read.begin(), read.end(), std::nullopt) != read.end()) return std::nullopt;
    return table_answer(measured_, [&read](FitColumn column) {
      return each(read, [column](const std::optional<ReadVibration>& one) {
        return column == FitColumn::stiffness ? one->stiffness : one->loss_factor;
      });
    });
  }

 private:
  /// Foils and machine in series: their displacements add up to the measured amplitude. The machine stores no energy
  /// over a loop.
  [[nodiscard]] std::optional<ReadVibration> read_row(LoadedFoils& foils, double direction, std::size_t row,
                                                      const Rig& rig) const {
    const double compliance = rig.machine_stiffness ? 1.0 / *rig.machine_stiffness : 0.0;
    const double read = amplitudes_[row];
    double amplitude = first_amplitude(row, compliance);
    VibrationTrial last;  // at rest
    for (int trial = 0; trial < most_vibration_trials; ++trial) {
      const Cycle cycle = foils.vibrate(direction, amplitude);
      if (!cycle.loaded_stiffness || !cycle.loss_factor) return std::nullopt;  // unlike a complete loop
      const VibrationTrial here{amplitude, amplitude * (1.0 + compliance * *cycle.loaded_stiffness),
                                *cycle.loaded_stiffness, *cycle.loss_factor};
      const double slope = (here.read - last.read) / (amplitude - last.amplitude);
      const double next = amplitude + (read - here.read) / slope;
      if (std::abs((next - amplitude) * (next - last.amplitude)) <= vibration_tolerance * read * read) {
        ReadVibration found = here.at(next, last);
        const double softer = 1.0 + compliance * found.stiffness;
        const double ratio = next / read;
        return ReadVibration{found.stiffness / softer, found.loss_factor * softer * ratio * ratio};
      }
      last = here;
      amplitude = std::max(next, 0.1 * amplitude);
    }
    return std::nullopt;
  }

  /// Amplitude of the foils if their stiffness is the measured one.
  [[nodiscard]] double first_amplitude(std::size_t row, double compliance) const {
    const double pressed = stiffnesses_.empty() ? 0.0 : compliance * stiffnesses_[row];
    return std::max(1.0 - pressed, 0.1) * amplitudes_[row];
  }

  std::vector<double> amplitudes_;   ///< measured amplitudes of each row, m
  std::vector<double> stiffnesses_;  ///< the same for stiffness, N/m; empty if not measured
  std::vector<VibrationGroup> groups_;
};

}  // namespace

std::unique_ptr<const MeasuredData> measured_vibrations(const FitData& data, const Case& input) {
  return std::make_unique<MeasuredVibrationData>(data, input);
}

}  // namespace bumpfoil
