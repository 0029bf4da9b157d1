#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "experiments/fit/fit_columns.hpp"
#include "experiments/fit/measured_data.hpp"

namespace bumpfoil {
namespace {

/// The rig reads amplitudes to this part of them.
constexpr double vibration_tolerance = 1e-6;
constexpr int most_vibration_trials = 50;
constexpr int fewest_steps = 2;

/// What follows from a loop.
struct ReadVibration {
  double stiffness{}, loss_factor{};
};

/// Rows about one load along one direction: all their amplitudes are run at once.
struct VibrationGroup {
  Eigen::Vector2d load{0.0, 0.0};
  double direction{};
  std::vector<std::size_t> rows{};
};

std::optional<std::vector<ReadVibration>> vibrate(Case input, const VibrationGroup& group,
                                                  std::vector<double> amplitudes) {
  input.vibration->loads = {group.load};
  input.vibration->directions = {group.direction};
  input.vibration->amplitudes = std::move(amplitudes);
  std::vector<ReadVibration> all;
  for (const Vibration& one : run_vibration(input).vibrations) {
    if (!one.harmonic || !one.cycle.loaded_stiffness || !one.cycle.loss_factor) return std::nullopt;
    all.push_back({*one.cycle.loaded_stiffness, *one.cycle.loss_factor});
  }
  return all;
}

class MeasuredVibrationData final : public MeasuredData {
 public:
  MeasuredVibrationData(const FitData& data, const Case& input)
      : amplitudes_(data.column(FitColumn::amplitude).values) {
    const std::vector<double>& directions = data.column(FitColumn::direction).values;
    std::vector<std::string> series;
    for (std::size_t row = 0; row < amplitudes_.size(); ++row) {
      const double direction = directions.empty() ? data.direction : directions[row];
      const bool in_columns =
          !data.column(FitColumn::load_x).values.empty() || !data.column(FitColumn::load_y).values.empty();
      const Eigen::Vector2d load = in_columns     ? load_in_row(data, row)
                                   : data.preload ? data.preload->value
                                                  : input.vibration->loads.front();
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
    if (!input.vibration) input.vibration.emplace();
    input.vibration->motion = Motion::line;
    input.vibration->loads = {groups_.front().load};
    input.vibration->directions = {groups_.front().direction};
    input.vibration->amplitudes = {amplitudes_.front()};
    input.vibration->frequencies = {1.0};  // loops do not depend on it
    // Nor on the increments where they are exact.
    if (input.solver.name == SolverName::events) input.vibration->steps = fewest_steps;
    return input;
  }

  [[nodiscard]] std::optional<DataAnswer> answer(const Case& input, const Rig& rig) const override {
    std::vector<ReadVibration> read(amplitudes_.size());
    std::vector<char> found(groups_.size(), 0);
    tbb::parallel_for(std::size_t{0}, groups_.size(), [&](std::size_t i) {
      const auto of_group = read_group(input, groups_[i], rig);
      if (!of_group) return;
      for (std::size_t k = 0; k < of_group->size(); ++k) read[groups_[i].rows[k]] = (*of_group)[k];
      found[i] = 1;
    });
    if (std::find(found.begin(), found.end(), 0) != found.end()) return std::nullopt;
    return table_answer(measured_, [&read](FitColumn column) {
      std::vector<double> values;
      values.reserve(read.size());
      for (const ReadVibration& one : read) {
        values.push_back(column == FitColumn::stiffness ? one.stiffness : one.loss_factor);
      }
      return values;
    });
  }

 private:
  /// Of foils and machine in series, whose displacements add up to the amplitude that was read. The machine stores no
  /// energy in a loop.
  [[nodiscard]] std::optional<std::vector<ReadVibration>> read_group(const Case& input, const VibrationGroup& group,
                                                                     const Rig& rig) const {
    const double compliance = rig.machine_stiffness ? 1.0 / *rig.machine_stiffness : 0.0;
    std::vector<double> read;
    for (const std::size_t row : group.rows) read.push_back(amplitudes_[row]);
    std::vector<double> amplitudes = read;
    std::vector<double> last_amplitudes(read.size(), 0.0);
    std::vector<double> last_read(read.size(), 0.0);
    for (int trial = 0; trial < most_vibration_trials; ++trial) {
      auto all = vibrate(input, group, amplitudes);
      if (!all) return std::nullopt;
      bool settled = true;
      std::vector<double> next;
      for (std::size_t k = 0; k < read.size(); ++k) {
        const double here = amplitudes[k] * (1.0 + compliance * (*all)[k].stiffness);
        settled = settled && std::abs(here - read[k]) <= vibration_tolerance * read[k];
        // The secant; at first from rest. What has arrived stays.
        const double slope = here == last_read[k] ? 1.0 : (here - last_read[k]) / (amplitudes[k] - last_amplitudes[k]);
        next.push_back(std::max(amplitudes[k] + (read[k] - here) / slope, 0.1 * amplitudes[k]));
        last_read[k] = here;
        last_amplitudes[k] = amplitudes[k];
      }
      if (!settled) {
        amplitudes = std::move(next);
        continue;
      }
      for (std::size_t k = 0; k < read.size(); ++k) {
        ReadVibration& one = (*all)[k];
        const double stiffness = one.stiffness / (1.0 + compliance * one.stiffness);
        const double ratio = amplitudes[k] / read[k];
        one.loss_factor *= one.stiffness / stiffness * ratio * ratio;
        one.stiffness = stiffness;
      }
      return all;
    }
    return std::nullopt;
  }

  std::vector<double> amplitudes_;  ///< as they were read, of each row, m
  std::vector<VibrationGroup> groups_;
};

}  // namespace

std::unique_ptr<const MeasuredData> measured_vibrations(const FitData& data, const Case& input) {
  return std::make_unique<MeasuredVibrationData>(data, input);
}

}  // namespace bumpfoil
