#include "bumpfoil/experiments/fit/fit.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "core/even_point.hpp"
#include "experiments/fit/fit_keys.hpp"
#include "experiments/fit/fit_model.hpp"
#include "experiments/fit/fit_statistics.hpp"
#include "experiments/fit/least_squares.hpp"

namespace bumpfoil {
namespace {

/// Number of sample points per parameter, of which the best are further starts.
constexpr std::size_t places_per_parameter = 4;
/// A parameter closer to a bound, relative to the distance between bounds, is at it.
constexpr double at_bound = 1e-6;
/// Minima that differ by less, relative to the bounds, in every parameter are the same.
constexpr double distinct_distance = 0.02;
/// A minimum whose chi-square exceeds the best by less (in units of chi-square per degree of freedom) is reported as
/// nearly as deep.
constexpr double nearly_as_deep = 9.0;

/// Relative deviation between forward and backward differences of residuals that indicates a jump, as between sets of
/// sliding contacts; and the smallest change of such residuals from bound to bound, in standard deviations.
constexpr double jump = 0.5;
constexpr double least_jump = 1.0;

/// Extent of profiles, in standard errors, and the number of steps to each side.
constexpr double profile_reach = 3.0;
constexpr int profile_steps = 6;

class Fit {
 public:
  Fit(const Case& input, const ProgressCallback& progress)
      : model_(input), settings_(model_.settings()), progress_(progress) {
    for (const auto& data : model_.data()) rows_ += std::ssize(data->measured().points);
    problem_.robust = rows_;
    problem_.huber = settings_.huber;
    problem_.residuals = [this](const Eigen::VectorXd& x) { return residuals(x); };
  }

  FitResult run() {
    FitResult result;
    result.settings = settings_;
    for (const FitParameter& parameter : settings_.parameters) {
      const std::optional<Dimension> dimension = dimension_of(parameter.key);
      result.units.emplace_back(dimension ? si_unit(*dimension) : "1");
    }
    const Eigen::VectorXd given = given_start();
    weigh(require_start(given));
    std::vector<LeastSquaresMinimum> minima = minimise_from_all(given);
    if (!minima.empty() && settings_has_noisy_displacements()) {
      weigh(*model_.answers(values_at(minima.front().x)));
      // Standard deviations depend on the slope of the loop: update them at the solution and repeat.
      if (auto again = minimise(problem_, minima.front().x, [] { return true; })) minima.front() = std::move(*again);
    }
    if (minima.empty()) {
      result.runs = runs_;
      result.status = stopped_ ? Status::interrupted : Status::not_converged;
      return result;
    }
    describe_minimum(minima.front(), result);
    keep_minima(minima, result);
    if (settings_.profile) add_profiles(minima.front(), result);
    result.runs = runs_;
    result.status = stopped_                   ? Status::interrupted
                    : minima.front().converged ? Status::converged
                                               : Status::iterations_spent;
    return result;
  }

 private:
  [[nodiscard]] Eigen::Index count() const { return std::ssize(settings_.parameters); }

  [[nodiscard]] Eigen::VectorXd given_start() const {
    Eigen::VectorXd x(count());
    for (Eigen::Index i = 0; i < count(); ++i) {
      const FitParameter& one = settings_.parameters[static_cast<std::size_t>(i)];
      x[i] = (one.start - one.lower) / (one.upper - one.lower);
    }
    return x;
  }

  [[nodiscard]] std::vector<double> values_at(const Eigen::VectorXd& x) const {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < count(); ++i) {
      const FitParameter& one = settings_.parameters[static_cast<std::size_t>(i)];
      values.push_back(std::clamp(one.lower + x[i] * (one.upper - one.lower), one.lower, one.upper));
    }
    return values;
  }

  [[nodiscard]] bool settings_has_noisy_displacements() const {
    return std::any_of(settings_.data.begin(), settings_.data.end(),
                       [](const FitData& data) { return data.displacement_std > 0.0; });
  }

  /// Model values there. @throws Error (input) with the reason why the case cannot be run
  [[nodiscard]] std::vector<DataAnswer> require_start(const Eigen::VectorXd& x) const {
    const std::vector<double> values = values_at(x);
    for (std::size_t i = 0; i < settings_.data.size(); ++i) static_cast<void>(model_.case_of_data(i, values));
    if (auto answers = model_.answers(values)) return std::move(*answers);
    const std::string_view command = name_of(settings_.data.front().experiment);
    throw Error(ErrorKind::input,
                {{"", 0, "fit.parameter", "", "the model cannot be run at the starts",
                  fmt::format("start from values with which `bumpfoil {}` reaches all that was measured", command)}});
  }

  /// Takes the standard deviations of residuals from the model.
  void weigh(const std::vector<DataAnswer>& answers) {
    weights_ = each(answers, [](const DataAnswer& answer) { return answer.weights; });
  }

  std::optional<Eigen::VectorXd> residuals(const Eigen::VectorXd& x) {
    if (stopped_) return std::nullopt;
    ++runs_;
    const std::vector<double> values = values_at(x);
    const auto answers = model_.answers(values);
    if (!answers) return std::nullopt;
    std::vector<double> all;
    for (std::size_t i = 0; i < answers->size(); ++i) {
      const std::vector<FittedPoint>& points = model_.data()[i]->measured().points;
      for (std::size_t k = 0; k < points.size(); ++k) {
        all.push_back(((*answers)[i].fitted[k] - points[k].measured) / weights_[i][k]);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const FitParameter& one = settings_.parameters[i];
      if (one.mean) all.push_back((values[i] - *one.mean) / *one.std);
    }
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(all.data(), std::ssize(all)));
  }

  /// Reports the progress of a minimisation or profile. The number of steps of each is unknown.
  bool goes_on(std::size_t part, int step) {
    const auto parts = static_cast<double>(settings_.starts + (settings_.profile ? count() : 0));
    const double share = 1.0 - 1.0 / (1.0 + 0.1 * step);
    stopped_ = progress_ && !progress_((static_cast<double>(part) + share) / parts);
    return !stopped_;
  }

  /// Minima from the given start and from the best sample points, in ascending order.
  std::vector<LeastSquaresMinimum> minimise_from_all(const Eigen::VectorXd& given) {
    std::vector<Eigen::VectorXd> starts{given};
    const auto further = static_cast<std::size_t>(settings_.starts) - 1;
    if (further > 0) {
      const std::size_t places = std::max(further, places_per_parameter * settings_.parameters.size());
      std::vector<double> costs(places, std::numeric_limits<double>::infinity());
      tbb::parallel_for(std::size_t{0}, places, [&](std::size_t k) {
        if (const auto there = residuals(even_point(k + 1, Eigen::VectorXd::Zero(count()))))
          costs[k] = cost_of(problem_, *there);
      });
      std::vector<std::size_t> order(places);
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
      for (std::size_t k = 0; k < further; ++k) {
        if (std::isfinite(costs[order[k]])) starts.push_back(even_point(order[k] + 1, Eigen::VectorXd::Zero(count())));
      }
    }
    std::vector<LeastSquaresMinimum> minima;
    for (std::size_t k = 0; k < starts.size() && !stopped_; ++k) {
      int steps = 0;
      const auto go_on = [&] { return goes_on(k, steps++); };
      auto minimum = minimise(problem_, starts[k], go_on);
      if (minimum && !stopped_) minima.push_back(std::move(*minimum));
    }
    std::stable_sort(minima.begin(), minima.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
    return minima;
  }

  void describe_minimum(const LeastSquaresMinimum& minimum, FitResult& result) {
    const std::vector<double> values = values_at(minimum.x);
    const auto answers = model_.answers(values);
    FitEstimate estimate{.sensitivities = minimum.differences.jacobian,
                         .weights = Eigen::VectorXd::Ones(minimum.residuals.size()),
                         .variances = Eigen::VectorXd::Ones(minimum.residuals.size()),
                         .held = {}};
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < answers->size(); ++i) {
      const DataAnswer& answer = (*answers)[i];
      FittedData& data = result.data.emplace_back(model_.data()[i]->measured());
      std::vector<int> counts(data.quantities.size(), 0);
      for (std::size_t k = 0; k < data.points.size(); ++k, ++row) {
        FittedPoint& point = data.points[k];
        point.fitted = answer.fitted[k];
        point.std = answer.std[k];
        const double difference = point.fitted - point.measured;
        data.quantities[point.quantity].residual += difference * difference;
        ++counts[point.quantity];
        if (settings_.huber) {
          estimate.weights[row] = std::min(1.0, *settings_.huber / std::abs(minimum.residuals[row]));
        }
        estimate.variances[row] = std::pow(point.std / weights_[i][k], 2);
        result.chi_square += estimate.weights[row] * std::pow(difference / point.std, 2);
      }
      for (std::size_t q = 0; q < counts.size(); ++q) {
        data.quantities[q].residual = std::sqrt(data.quantities[q].residual / counts[q]);
      }
    }
    for (Eigen::Index i = row; i < minimum.residuals.size(); ++i) {
      result.chi_square += minimum.residuals[i] * minimum.residuals[i];
    }
    int open = 0;
    for (Eigen::Index i = 0; i < count(); ++i) {
      const FitParameter& one = settings_.parameters[static_cast<std::size_t>(i)];
      FittedValue& found = result.parameters.emplace_back();
      found.value = values[static_cast<std::size_t>(i)];
      found.at_bound = minimum.x[i] < at_bound || minimum.x[i] > 1.0 - at_bound;
      found.at_jump =
          minimum.differences.bends[i] > jump && estimate.sensitivities.col(i).norm() > least_jump && !found.at_bound;
      estimate.sensitivities.col(i) /= one.upper - one.lower;
      estimate.held.push_back(found.at_bound || found.at_jump);
      open += found.at_bound ? 0 : 1;
    }
    result.degrees_of_freedom = std::max(1, static_cast<int>(minimum.residuals.size()) - open);
    const double excess = std::max(1.0, result.reduced_chi_square());
    const Eigen::MatrixXd covariance = excess * covariance_of(estimate);
    // The minimisation weights all points equally; standard errors account for the number of readings of each.
    FitEstimate counted = estimate;
    counted.variances.setOnes();
    const Eigen::MatrixXd as_counted = covariance_of(counted);
    const double factor = student_975(result.degrees_of_freedom);
    for (Eigen::Index i = 0; i < count(); ++i) {
      FittedValue& found = result.parameters[static_cast<std::size_t>(i)];
      const double std = std::sqrt(covariance(i, i));
      if (!std::isfinite(std)) {
        profile_scales_.push_back(1.0 / excess);
        continue;
      }
      profile_scales_.push_back(as_counted(i, i) / (std * std));
      found.standard_error = std;
      found.lower_95 = found.value - factor * std;
      found.upper_95 = found.value + factor * std;
    }
    const Eigen::VectorXd deviations = covariance.diagonal().cwiseSqrt();
    result.correlation = covariance.cwiseQuotient(deviations * deviations.transpose());
    result.directions =
        hardly_told(estimate.sensitivities.topRows(rows_), settings_.parameters, result.units, result.collinearity);
    result.fitted = model_.case_with(values);
  }

  /// The minimum with one parameter held; `x` is the start. @return its cost, absent if there is none
  std::optional<double> minimise_others(Eigen::Index held, Eigen::VectorXd& x, const std::function<bool()>& go_on) {
    const auto whole = [&](const Eigen::VectorXd& others) {
      Eigen::VectorXd all(count());
      all << others.head(held), x[held], others.tail(count() - 1 - held);
      return all;
    };
    if (count() == 1) {
      const auto there = residuals(x);
      return there ? std::optional(cost_of(problem_, *there)) : std::nullopt;
    }
    LeastSquares problem = problem_;
    problem.residuals = [&](const Eigen::VectorXd& others) { return residuals(whole(others)); };
    Eigen::VectorXd start(count() - 1);
    start << x.head(held), x.tail(count() - 1 - held);
    const auto minimum = minimise(problem, start, go_on);
    if (!minimum) return std::nullopt;
    x = whole(minimum->x);
    return minimum->cost;
  }

  /// One side of a profile, away from the best value. @return where it exceeds `threshold`
  std::optional<double> follow_profile(Eigen::Index held, const LeastSquaresMinimum& best, double end, double threshold,
                                       const std::function<bool()>& go_on, std::vector<FitProfilePoint>& profile) {
    std::optional<double> crossing;
    const double scale = profile_scales_[static_cast<std::size_t>(held)];
    Eigen::VectorXd x = best.x;
    FitProfilePoint last = profile.front();
    for (int k = 1; k <= profile_steps && end != best.x[held]; ++k) {
      x[held] = best.x[held] + (end - best.x[held]) * k / profile_steps;
      const std::optional<double> cost = minimise_others(held, x, go_on);
      if (!cost || stopped_) break;
      const FitProfilePoint next{values_at(x)[static_cast<std::size_t>(held)], scale * (*cost - best.cost)};
      if (!crossing && next.cost > threshold) {
        // Square roots of the cost are nearly linear.
        const double from = std::sqrt(std::max(0.0, last.cost));
        const double part = (std::sqrt(threshold) - from) / (std::sqrt(next.cost) - from);
        crossing = last.value + part * (next.value - last.value);
      }
      profile.push_back(next);
      last = next;
    }
    return crossing;
  }

  void add_profiles(const LeastSquaresMinimum& best, FitResult& result) {
    const double threshold = std::pow(student_975(result.degrees_of_freedom), 2);
    for (Eigen::Index i = 0; i < count() && !stopped_; ++i) {
      const FitParameter& one = settings_.parameters[static_cast<std::size_t>(i)];
      FittedValue& found = result.parameters[static_cast<std::size_t>(i)];
      int steps = 0;
      const auto go_on = [&] { return goes_on(static_cast<std::size_t>(settings_.starts + i), steps++); };
      const double reach = found.standard_error ? profile_reach * *found.standard_error / (one.upper - one.lower) : 1.0;
      found.profile.push_back({found.value, 0.0});
      const auto follow = [&](double end) {
        return follow_profile(i, best, std::clamp(end, 0.0, 1.0), threshold, go_on, found.profile);
      };
      found.profile_upper_95 = follow(best.x[i] + reach);
      found.profile_lower_95 = follow(best.x[i] - reach);
      std::sort(found.profile.begin(), found.profile.end(),
                [](const FitProfilePoint& a, const FitProfilePoint& b) { return a.value < b.value; });
    }
  }

  /// Keeps distinct minima that are nearly as deep.
  void keep_minima(const std::vector<LeastSquaresMinimum>& minima, FitResult& result) const {
    std::vector<Eigen::VectorXd> kept;
    const double excess = std::max(1.0, result.reduced_chi_square());
    for (const LeastSquaresMinimum& minimum : minima) {
      if (minimum.cost - minima.front().cost > nearly_as_deep * excess) break;
      const bool known = std::any_of(kept.begin(), kept.end(), [&](const Eigen::VectorXd& other) {
        return (other - minimum.x).cwiseAbs().maxCoeff() < distinct_distance;
      });
      if (known) continue;
      kept.push_back(minimum.x);
      result.minima.push_back({values_at(minimum.x), minimum.cost});
    }
  }

  FitModel model_;
  const FitSettings& settings_;
  const ProgressCallback& progress_;
  std::vector<std::vector<double>> weights_;  ///< standard deviations of residuals, for each data set
  Eigen::Index rows_{};                       ///< number of residuals of the data
  std::vector<double> profile_scales_;        ///< of each parameter, see FitProfilePoint
  LeastSquares problem_;
  std::atomic<std::size_t> runs_{};
  std::atomic<bool> stopped_{};
};

}  // namespace

FitResult run_fit(const Case& input, const ProgressCallback& progress) {
  return Fit(input, progress).run();
}

}  // namespace bumpfoil
