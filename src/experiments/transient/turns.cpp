#include <algorithm>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "core/linear_algebra.hpp"
#include "experiments/transient/ends_of_turns.hpp"
#include "experiments/transient/step_row.hpp"

// Post-processing of the steps of a run, one revolution in memory at a time.
namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Steps read at a time.
constexpr std::size_t steps_at_once = 10'000;
/// A bearing rubs if asperities carry more than this fraction of the weight on it.
constexpr double rubbing_part = 0.01;
/// Highest order of spectra.
constexpr double highest_order = 8.0;
/// Angles that differ by less are equal.
constexpr double rounded_angle = 1e-6;

std::vector<std::size_t> turn_ends_of(const StepTable& steps) {
  return ends_of_turns(steps.rows(), [&](std::size_t first, std::size_t count) {
    return steps.column(column_of(StepColumn::angle), first, count);
  });
}

/// Positions over angle, between two rows.
struct PlaceMotion {
  std::vector<double> angles;  ///< magnitudes of the angles
  std::vector<double> x, y;

  [[nodiscard]] Eigen::Vector2d at(std::size_t i) const { return {x[i], y[i]}; }
};

PlaceMotion motion_of(const TransientResult& result, std::size_t place, std::size_t first, std::size_t last) {
  const std::size_t count = last - first + 1;
  PlaceMotion motion{.angles = result.steps->column(column_of(StepColumn::angle), first, count),
                     .x = result.steps->column(place_column(place, 0), first, count),
                     .y = result.steps->column(place_column(place, 1), first, count)};
  for (double& angle : motion.angles) angle = std::abs(angle);
  return motion;
}

/// A motion at equidistant angles, interpolated linearly between steps.
/// @param begin  the first of them, rad, not before the start of the motion
Eigen::Matrix2Xd at_equal_angles(const PlaceMotion& motion, double begin, std::size_t count, double step) {
  Eigen::Matrix2Xd places(2, static_cast<Eigen::Index>(count));
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = begin + step * static_cast<double>(i);
    while (at + 2 < motion.angles.size() && motion.angles[at + 1] < angle) ++at;
    const double turned = motion.angles[at + 1] - motion.angles[at];  // zero while the rotor is at rest
    const double part = turned > 0.0 ? (angle - motion.angles[at]) / turned : 0.0;
    places.col(static_cast<Eigen::Index>(i)) = (1.0 - part) * motion.at(at) + part * motion.at(at + 1);
  }
  return places;
}

/// Amplitudes of e^{i order angle} of some orders at equidistant angles, with a linearly drifting mean, by least
/// squares.
std::vector<Eigen::Vector2cd> harmonics_of(const Eigen::Matrix2Xd& places, double begin, double step,
                                           std::initializer_list<double> orders) {
  Eigen::MatrixXd basis(places.cols(), 2 + 2 * static_cast<Eigen::Index>(orders.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const double angle = begin + step * static_cast<double>(i);
    basis.row(i).head<2>() << 1.0, step * static_cast<double>(i);
    Eigen::Index at = 2;
    for (const double order : orders) {
      basis.row(i).segment<2>(at) << std::cos(order * angle), std::sin(order * angle);
      at += 2;
    }
  }
  const Eigen::MatrixXd found = least_squares(basis, places.transpose());
  std::vector<Eigen::Vector2cd> amplitudes;
  for (Eigen::Index at = 2; at < basis.cols(); at += 2) {
    amplitudes.emplace_back(found.row(at).transpose() - Complex(0.0, 1.0) * found.row(at + 1).transpose());
  }
  return amplitudes;
}

/// Mean and distance travelled of a turn.
PlaceTurn place_in_turn(const PlaceMotion& motion) {
  const std::size_t last = motion.angles.size() - 1;
  PlaceTurn found{.orbit = {}, .at_end = motion.at(last)};
  Eigen::Vector2d least = found.at_end;
  Eigen::Vector2d most = found.at_end;
  const double whole = motion.angles[last] - motion.angles[0];
  for (std::size_t i = 0; i < last; ++i) {
    const double part = (motion.angles[i + 1] - motion.angles[i]) / whole;
    found.orbit.mean += 0.5 * part * (motion.at(i) + motion.at(i + 1));
    least = least.cwiseMin(motion.at(i));
    most = most.cwiseMax(motion.at(i));
  }
  found.orbit.half_peak_to_peak = 0.5 * (most - least);
  return found;
}

/// Harmonics of a turn from a window of two turns centred on it: this separates motion of order 1/2 and a drifting mean
/// from order 1. The first and the last turn use themselves only, without order 1/2.
/// @param steps  in a turn
void find_harmonics(const PlaceMotion& motion, long number, std::size_t steps, PlaceTurn& found) {
  const double step = turn / static_cast<double>(steps);
  double begin = turn * (static_cast<double>(number) - 1.5);
  const double end = begin + 2.0 * turn;
  const bool has_both = motion.angles.front() <= begin + rounded_angle && motion.angles.back() >= end - rounded_angle;
  if (!has_both) begin = turn * static_cast<double>(number - 1);
  const Eigen::Matrix2Xd places = at_equal_angles(motion, begin, (has_both ? 2 : 1) * steps, step);
  if (has_both) {
    const std::vector<Eigen::Vector2cd> all = harmonics_of(places, begin, step, {1.0, 2.0, 0.5});
    found.orbit.once = all[0];
    found.orbit.twice = all[1];
    found.half = all[2];
  } else {
    const std::vector<Eigen::Vector2cd> whole = harmonics_of(places, begin, step, {1.0, 2.0});
    found.orbit.once = whole[0];
    found.orbit.twice = whole[1];
  }
}

BearingRecord bearing_in_turn(const TransientResult& result, std::size_t bearing, std::size_t first,
                              std::size_t count) {
  const auto read = [&](BearingColumn column) {
    return result.steps->column(bearing_column(result.layout, bearing, column), first, count);
  };
  const std::vector<double> thickness = read(BearingColumn::thinnest);
  const std::vector<double> load = read(BearingColumn::asperity_load);
  BearingRecord record{.thinnest = *std::min_element(thickness.begin(), thickness.end()),
                       .asperity_load = *std::max_element(load.begin(), load.end())};
  for (const double power : read(BearingColumn::power)) record.power += power / static_cast<double>(count);
  return record;
}

}  // namespace

std::vector<TransientTurn> turns_of(const TransientResult& result) {
  std::vector<TransientTurn> turns;
  if (!result.steps) return turns;
  const std::vector<std::size_t> ends = turn_ends_of(*result.steps);
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const std::size_t first = ends[k - 1];
    const std::size_t count = ends[k] - first;  // excludes the first row, which ends the previous revolution
    const auto times = result.steps->column(column_of(StepColumn::time), first, count + 1);
    TransientTurn& revolution = turns.emplace_back();
    revolution.number = static_cast<long>(k);
    revolution.time = times.back();
    revolution.speed = std::copysign(turn / (times.back() - times.front()),
                                     result.steps->column(column_of(StepColumn::angle), ends[k], 1).front());
    for (std::size_t place = 0; place < result.layout.places; ++place) {
      PlaceTurn& found = revolution.places.emplace_back(place_in_turn(motion_of(result, place, first, ends[k])));
      const std::size_t from = ends[k < 2 ? 0 : k - 2];
      const std::size_t to = k + 1 < ends.size() ? ends[k + 1] : result.steps->rows() - 1;
      find_harmonics(motion_of(result, place, from, to), revolution.number,
                     static_cast<std::size_t>(result.settings.steps_per_revolution), found);
    }
    for (std::size_t bearing = 0; bearing < result.layout.bearings; ++bearing) {
      revolution.bearings.push_back(bearing_in_turn(result, bearing, first + 1, count));
    }
    for (std::size_t i = 0; i < energy_columns; ++i) {
      for (const double term : result.steps->column(column_of(StepColumn::energy) + i, first + 1, count)) {
        revolution.energy.*energy_terms()[i] += term;
      }
    }
  }
  return turns;
}

std::vector<RubEvent> rubs_of(const TransientResult& result) {
  std::vector<RubEvent> rubs;
  if (!result.steps) return rubs;
  for (std::size_t bearing = 0; bearing < result.layout.bearings; ++bearing) {
    const double least = rubbing_part * result.machine.loads[bearing].norm();
    bool rubs_now = false;
    for (std::size_t first = 0; first < result.steps->rows(); first += steps_at_once) {
      const std::size_t count = std::min(steps_at_once, result.steps->rows() - first);
      const auto times = result.steps->column(column_of(StepColumn::time), first, count);
      const auto loads =
          result.steps->column(bearing_column(result.layout, bearing, BearingColumn::asperity_load), first, count);
      for (std::size_t i = 0; i < count; ++i) {
        if (loads[i] <= least) {
          rubs_now = false;
          continue;
        }
        if (!rubs_now) rubs.push_back({.bearing = bearing, .begin = times[i]});
        rubs_now = true;
        rubs.back().end = times[i];
        rubs.back().load = std::max(rubs.back().load, loads[i]);
      }
    }
  }
  return rubs;
}

Waterfall waterfall_of(const TransientResult& result) {
  const auto per_spectrum = static_cast<std::size_t>(result.settings.revolutions_per_spectrum);
  const auto per_turn = static_cast<std::size_t>(result.settings.steps_per_revolution);
  const std::size_t count = per_spectrum * per_turn;
  Waterfall waterfall;
  const std::size_t orders = std::min(static_cast<std::size_t>(highest_order) * per_spectrum, (count - 1) / 2) + 1;
  waterfall.orders.reserve(orders);
  for (std::size_t i = 0; i < orders; ++i) {
    waterfall.orders.push_back(static_cast<double>(i) / static_cast<double>(per_spectrum));
  }
  if (!result.steps) return waterfall;
  const std::vector<std::size_t> ends = turn_ends_of(*result.steps);
  Eigen::FFT<double> transform;
  for (std::size_t k = per_spectrum; k < ends.size(); k += per_spectrum) {
    const std::size_t first = ends[k - per_spectrum];
    const auto at = [&](StepColumn column, std::size_t row) {
      return result.steps->column(column_of(column), row, 1).front();
    };
    const double begin = at(StepColumn::time, first);
    const double end = at(StepColumn::time, ends[k]);
    waterfall.times.push_back(0.5 * (begin + end));
    waterfall.speeds.push_back((at(StepColumn::angle, ends[k]) - at(StepColumn::angle, first)) / (end - begin));
    for (std::size_t place = 0; place < result.layout.places; ++place) {
      const Eigen::Matrix2Xd places =
          at_equal_angles(motion_of(result, place, first, ends[k]), turn * static_cast<double>(k - per_spectrum), count,
                          turn / static_cast<double>(per_turn));
      const Eigen::Vector2d mean = places.rowwise().mean();
      for (const int axis : {0, 1}) {
        std::vector<double> windowed(count);
        for (std::size_t i = 0; i < count; ++i) {
          const double window = 1.0 - std::cos(turn * static_cast<double>(i) / static_cast<double>(count));
          windowed[i] = window * (places(axis, static_cast<Eigen::Index>(i)) - mean[axis]);
        }
        std::vector<Complex> spectrum;
        transform.fwd(spectrum, windowed);
        for (std::size_t i = 0; i < orders; ++i) {
          waterfall.amplitudes.push_back(2.0 / static_cast<double>(count) * std::abs(spectrum[i]));
        }
      }
    }
  }
  return waterfall;
}

EnergyCheck energy_check(const std::vector<TransientTurn>& turns) {
  EnergyCheck check;
  for (const TransientTurn& revolution : turns) {
    const WorkBalance& energy = revolution.energy;
    check.sum += energy;
    check.defect += std::abs(energy.defect());
    check.largest +=
        std::max({std::abs(energy.forces), energy.friction, std::abs(energy.stored), std::abs(energy.films())});
  }
  return check;
}

}  // namespace bumpfoil
