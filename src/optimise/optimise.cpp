#include "bumpfoil/optimise/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/draws.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "core/even_point.hpp"
#include "core/number_text.hpp"
#include "optimise/constrained_search.hpp"
#include "optimise/optimise_model.hpp"

namespace bumpfoil {
namespace {

/// Places for each key among which the further starts are the best, and the part of all evaluations that they take at
/// most.
constexpr std::size_t places_per_key = 4;
constexpr double part_of_places = 1.0 / 3.0;
/// Of two aims the part of the other evaluations that the ends of the front take.
constexpr double part_of_ends = 0.5;
/// First steps of searches in parts of the way between the bounds: from given starts, and from a neighbour on the
/// front.
constexpr double wide_step = 0.25;
constexpr double near_step = 0.08;
/// Starts lie farther apart than this in some key, where there are such.
constexpr double least_apart = 0.15;
/// Searches keep their limits by this part of their tolerance, so that they end where limits are met.
constexpr double part_of_tolerance = 0.1;
/// A limit is active that is met by less than this part of its bound.
constexpr double active_part = 0.01;

using KeyValues = std::vector<double>;

/// What a search is for: an aim, and how good another is to be at least.
struct SearchGoal {
  std::size_t aim{};
  std::optional<OptimiseLimit> other{};
};

/// Points that are known, in the order of their evaluation.
class KnownPoints {
 public:
  [[nodiscard]] const OptimisePoint* find(const KeyValues& values) const {
    const auto found = numbers_.find(values);
    return found == numbers_.end() ? nullptr : &points_[found->second];
  }

  /// Points that are known keep their numbers.
  void add(OptimisePoint point) {
    if (numbers_.try_emplace(point.values, points_.size()).second) points_.push_back(std::move(point));
  }

  [[nodiscard]] const std::vector<OptimisePoint>& all() const { return points_; }

 private:
  std::vector<OptimisePoint> points_;
  std::map<KeyValues, std::size_t> numbers_;
};

/// A search, and where it comes to.
struct SearchRun {
  SearchGoal goal;
  KeyValues start;
  double step{wide_step};
  std::size_t budget{};  ///< evaluations at most
  std::size_t number{};
  std::vector<OptimisePoint> evaluated{};
  OptimiseSearch record{};

  [[nodiscard]] bool ended() const { return record.by_tolerance || record.by_rounding; }
};

class Optimiser {
 public:
  Optimiser(const Case& input, const ProgressCallback& progress, unsigned threads)
      : model_(input),
        settings_(model_.settings()),
        progress_(progress),
        threads_(threads > 0 ? threads : available_threads()) {
    start_.reserve(settings_.keys.size());
    for (std::size_t i = 0; i < settings_.keys.size(); ++i) {
      start_.push_back(short_value(model_.start()[i], settings_.keys[i]));
    }
    result_.settings = settings_;
    result_.key_units = model_.key_units();
    result_.aims = model_.aims();
    result_.limits = model_.limits();
    result_.optimised = input;
    result_.optimised.settings.set(OptimiseSettings{});
  }

  OptimiseResult run() {
    evaluate_places();
    if (!stopped_) run_searches(first_searches(), part_of_first());
    if (!stopped_) run_searches(last_searches(), part_of_first());
    if (!stopped_ && two_aims()) follow_front();
    result_.points = known_.all();
    conclude();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool two_aims() const { return result_.aims.size() > 1; }
  [[nodiscard]] std::size_t evaluations() const { return static_cast<std::size_t>(settings_.evaluations); }

  [[nodiscard]] std::size_t places() const {
    const std::size_t most =
        std::max<std::size_t>(1, static_cast<std::size_t>(part_of_places * static_cast<double>(settings_.evaluations)));
    return std::min(1 + places_per_key * settings_.keys.size(), most);
  }

  [[nodiscard]] Eigen::VectorXd scaled(const KeyValues& values) const {
    Eigen::VectorXd x(std::ssize(values));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const OptimisedKey& key = settings_.keys[i];
      x[static_cast<Eigen::Index>(i)] = key.log ? std::log(values[i] / key.lower) / std::log(key.upper / key.lower)
                                                : (values[i] - key.lower) / (key.upper - key.lower);
    }
    return x;
  }

  /// With so few digits that a value comes back from its place in the box the same, and is found again.
  static double short_value(double value, const OptimisedKey& key) {
    double rounded = value;
    read_number(fmt::format("{:.12g}", value), rounded);
    return std::clamp(rounded, key.lower, key.upper);
  }

  [[nodiscard]] KeyValues values_at(const Eigen::VectorXd& x) const {
    KeyValues values;
    values.reserve(settings_.keys.size());
    for (std::size_t i = 0; i < settings_.keys.size(); ++i) {
      const OptimisedKey& key = settings_.keys[i];
      const double part = x[static_cast<Eigen::Index>(i)];
      const double value =
          key.log ? key.lower * std::pow(key.upper / key.lower, part) : key.lower + part * (key.upper - key.lower);
      values.push_back(short_value(part >= 1.0 ? key.upper : value, key));
    }
    return values;
  }

  /// Runs some points, or searches, on all threads. @param run  (number, goes_on)
  void run_all(std::size_t runs, std::size_t budget, const NumberedRun& run) {
    const auto before = static_cast<double>(known_.all().size());
    const ProgressCallback part = [&](double fraction) {
      return !progress_ ||
             progress_((before + fraction * static_cast<double>(budget)) / static_cast<double>(evaluations()));
    };
    if (!run_in_parallel(runs, threads_, run, part)) stopped_ = true;
  }

  [[nodiscard]] std::size_t evaluations_left() const {
    return evaluations() - std::min(evaluations(), known_.all().size());
  }

  void evaluate_places() {
    std::vector<KeyValues> places_due{start_};
    Eigen::VectorXd shift(std::ssize(settings_.keys));
    for (Eigen::Index i = 0; i < shift.size(); ++i) {
      shift[i] = uniform_draw({static_cast<std::uint64_t>(settings_.seed), 0, 0, static_cast<std::uint32_t>(i)});
    }
    places_due.reserve(places());
    for (std::size_t k = 1; k < places(); ++k) places_due.push_back(values_at(even_point(k, shift)));
    std::vector<std::optional<OptimisePoint>> found(places_due.size());
    run_all(places_due.size(), places_due.size(), [&](std::size_t i, const ProgressCallback& goes_on) {
      found[i] = model_.evaluate(places_due[i], goes_on);
    });
    for (auto& point : found) {
      if (point) known_.add(std::move(*point));
    }
    aim_scales_.reserve(result_.aims.size());
    for (std::size_t i = 0; i < result_.aims.size(); ++i) aim_scales_.push_back(scale_of(&OptimisePoint::aims, i));
    limit_scales_.reserve(result_.limits.size());
    for (std::size_t i = 0; i < result_.limits.size(); ++i) {
      const double bound = std::abs(result_.limits[i].bound);
      limit_scales_.push_back(bound > 0.0 ? bound : scale_of(&OptimisePoint::limits, i));
    }
  }

  /// Of a quantity: its size at the first place that has it.
  [[nodiscard]] double scale_of(KeyValues OptimisePoint::*numbers, std::size_t i) const {
    for (const OptimisePoint& point : known_.all()) {
      if (point.status != PointStatus::converged) continue;
      if (const double size = std::abs((point.*numbers)[i]); size > 0.0) return size;
    }
    return 1.0;
  }

  /// Of an aim, to be least, in parts of its size.
  [[nodiscard]] double scaled_aim(const OptimisePoint& point, std::size_t aim) const {
    return (result_.aims[aim].maximise ? -1.0 : 1.0) * point.aims[aim] / aim_scales_[aim];
  }

  /// Limits of a goal, not to be positive.
  [[nodiscard]] Eigen::VectorXd scaled_limits(const OptimisePoint& point, const SearchGoal& goal) const {
    const std::size_t count = result_.limits.size();
    Eigen::VectorXd all(std::ssize(result_.limits) + (goal.other ? 1 : 0));
    for (std::size_t i = 0; i < count; ++i) {
      all[static_cast<Eigen::Index>(i)] = -result_.limits[i].margin(point.limits[i]) / limit_scales_[i];
    }
    if (goal.other) {
      const std::size_t other = 1 - goal.aim;
      all[all.size() - 1] = -goal.other->margin(point.aims[other]) / aim_scales_[other];
    }
    return all;
  }

  [[nodiscard]] bool meets(const OptimisePoint& point, const SearchGoal& goal) const {
    return result_.is_feasible(point) && (!goal.other || goal.other->margin(point.aims[1 - goal.aim]) >= 0.0);
  }

  /// What is less is better: first what misses limits the least, then the aim. @pre  the point converged
  [[nodiscard]] std::pair<double, double> merit(const OptimisePoint& point, const SearchGoal& goal) const {
    const Eigen::VectorXd missed = scaled_limits(point, goal);
    const double most = missed.size() > 0 && !meets(point, goal) ? missed.maxCoeff() : 0.0;
    return {std::max(most, 0.0), scaled_aim(point, goal.aim)};
  }

  [[nodiscard]] const OptimisePoint* best_of(const std::vector<OptimisePoint>& points, const SearchGoal& goal) const {
    const OptimisePoint* best = nullptr;
    for (const OptimisePoint& point : points) {
      if (!meets(point, goal)) continue;
      if (best == nullptr || scaled_aim(point, goal.aim) < scaled_aim(*best, goal.aim)) best = &point;
    }
    return best;
  }

  /// The given start, and the best places that lie apart.
  [[nodiscard]] std::vector<KeyValues> starts_for(const SearchGoal& goal) const {
    std::vector<const OptimisePoint*> order;
    for (const OptimisePoint& point : known_.all()) {
      if (point.status == PointStatus::converged) order.push_back(&point);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto* a, const auto* b) { return merit(*a, goal) < merit(*b, goal); });
    std::vector<KeyValues> starts{start_};
    const auto add = [&](bool apart) {
      for (const OptimisePoint* point : order) {
        if (std::ssize(starts) >= settings_.starts) return;
        const bool near = std::any_of(starts.begin(), starts.end(), [&](const KeyValues& other) {
          const double far = (scaled(other) - scaled(point->values)).cwiseAbs().maxCoeff();
          return far <= (apart ? least_apart : 0.0);
        });
        if (!near) starts.push_back(point->values);
      }
    };
    add(true);
    add(false);
    return starts;
  }

  [[nodiscard]] std::vector<SearchRun> first_searches() {
    std::vector<SearchRun> runs;
    for (std::size_t aim = 0; aim < result_.aims.size(); ++aim) {
      for (const KeyValues& start : starts_for({aim})) runs.push_back({.goal = {aim}, .start = start});
    }
    return runs;
  }

  /// From the best of an aim, where it is not the end of a search for that aim: another search met it on its way.
  [[nodiscard]] std::vector<SearchRun> last_searches() {
    std::vector<SearchRun> runs;
    for (std::size_t aim = 0; aim < result_.aims.size(); ++aim) {
      const OptimisePoint* const best = best_of(known_.all(), {aim});
      if (best == nullptr || end_of(*best) == OptimiseStatus::converged) continue;
      runs.push_back({.goal = {aim}, .start = best->values, .step = near_step});
    }
    return runs;
  }

  /// Evaluations of such searches together.
  [[nodiscard]] std::size_t part_of_first() const {
    const double part = two_aims() && settings_.front > 0 ? part_of_ends : 1.0;
    return static_cast<std::size_t>(part * static_cast<double>(evaluations_left()));
  }

  /// Points that a search asks for; those that it evaluates come to `run.evaluated`.
  void search(SearchRun& run, const ProgressCallback& goes_on) {
    KnownPoints own;
    double worst = 0.0;
    std::optional<OptimisePoint> best_met;
    const double kept = part_of_tolerance * settings_.tolerance;
    const auto evaluate = [&](const Eigen::VectorXd& x, double& aim, Eigen::VectorXd& limits) {
      const KeyValues values = values_at(x);
      const OptimisePoint* point = known_.find(values);
      if (point == nullptr) point = own.find(values);
      if (point == nullptr) {
        if (run.record.evaluations == run.budget) return false;
        const double before = static_cast<double>(run.record.evaluations);
        auto found = model_.evaluate(
            values, [&](double part) { return goes_on((before + part) / static_cast<double>(run.budget)); });
        if (!found) return false;
        ++run.record.evaluations;
        found->search = run.number;
        own.add(std::move(*found));
        point = own.find(values);
      }
      if (point->status != PointStatus::converged) {
        // Worse than all that the search has met: its models lead away from there.
        aim = worst + 1.0;
        limits.setOnes();
        return true;
      }
      aim = scaled_aim(*point, run.goal.aim);
      worst = std::max(worst, aim);
      limits = scaled_limits(*point, run.goal).array() + kept;
      if (meets(*point, run.goal) && (!best_met || aim < scaled_aim(*best_met, run.goal.aim))) best_met = *point;
      return true;
    };
    const SearchProblem problem{.limits = std::ssize(result_.limits) + (run.goal.other ? 1 : 0), .evaluate = evaluate};
    const SearchEnd end = search_constrained(problem, scaled(run.start), run.step, settings_.tolerance);
    run.record.by_tolerance = end == SearchEnd::tolerance;
    run.record.by_rounding = end == SearchEnd::rounding;
    if (best_met) run.record.best = best_met->values;
    run.evaluated = own.all();
  }

  void keep(std::vector<SearchRun>& runs) {
    for (SearchRun& run : runs) {
      for (OptimisePoint& point : run.evaluated) known_.add(std::move(point));
      run.record.aim = run.goal.aim;
      result_.searches.push_back(std::move(run.record));
    }
  }

  /// Evaluations that some searches leave go to those that lack some, which begin again: what they know costs nothing.
  void run_searches(std::vector<SearchRun> runs, std::size_t budget) {
    if (budget < runs.size()) return;
    std::vector<SearchRun*> due;
    due.reserve(runs.size());
    for (SearchRun& run : runs) {
      run.number = result_.searches.size() + due.size() + 1;
      due.push_back(&run);
    }
    while (!stopped_ && budget >= due.size() && !due.empty()) {
      for (SearchRun* run : due) run->budget = run->record.evaluations + budget / due.size();
      run_all(due.size(), budget, [&](std::size_t i, const ProgressCallback& goes_on) { search(*due[i], goes_on); });
      for (SearchRun* run : due) {
        budget -= std::min(budget, run->evaluated.size());
        for (OptimisePoint& point : run->evaluated) known_.add(std::move(point));
        run->evaluated.clear();
      }
      std::erase_if(due, [](const SearchRun* run) { return run->ended(); });
    }
    keep(runs);
  }

  /// Goals between the ends of the front, from the best of one aim on: the other is to be better and better.
  [[nodiscard]] std::vector<SearchGoal> goals_between(const OptimisePoint& from, const OptimisePoint& to) const {
    std::vector<SearchGoal> goals;
    goals.reserve(static_cast<std::size_t>(settings_.front));
    const bool above = result_.aims[1].maximise;
    for (int k = 1; k <= settings_.front; ++k) {
      const double bound = from.aims[1] + (to.aims[1] - from.aims[1]) * k / (settings_.front + 1.0);
      goals.push_back({0, OptimiseLimit{.text = {}, .quantity = {}, .above = above, .bound = bound}});
    }
    return goals;
  }

  /// Two chains of searches from the ends of the front to its middle, each from the best of its neighbour.
  void follow_front() {
    const OptimisePoint* const first = best_of(known_.all(), {0});
    const OptimisePoint* const last = best_of(known_.all(), {1});
    if (first == nullptr || settings_.front == 0 || first->aims[1] == last->aims[1]) return;
    goals_ = goals_between(*first, *last);
    const std::size_t count = goals_.size();
    const std::size_t left = evaluations_left();
    std::vector<SearchRun> runs(count);
    for (std::size_t i = 0; i < count; ++i) {
      runs[i] = {.goal = goals_[i], .start = {}, .step = near_step, .number = result_.searches.size() + i + 1};
    }
    const std::size_t half = (count + 1) / 2;
    run_all(2, left, [&](std::size_t chain, const ProgressCallback& goes_on) {
      KeyValues at = chain == 0 ? first->values : last->values;
      const std::size_t length = chain == 0 ? half : count - half;
      std::size_t own_left = left / count * length;
      for (std::size_t k = 0; k < length; ++k) {
        SearchRun& run = runs[chain == 0 ? k : count - 1 - k];
        run.start = at;
        run.budget = own_left / (length - k);
        search(run,
               [&](double part) { return goes_on((static_cast<double>(k) + part) / static_cast<double>(length)); });
        own_left -= run.record.evaluations;
        if (!run.record.best.empty()) at = run.record.best;
      }
    });
    keep(runs);
  }

  /// Best points of all goals along the front, without those that another is better than in both aims.
  void keep_front() {
    std::vector<const OptimisePoint*> best;
    const auto add = [&](const SearchGoal& goal) {
      const OptimisePoint* const point = best_of(result_.points, goal);
      if (point != nullptr && std::find(best.begin(), best.end(), point) == best.end()) best.push_back(point);
    };
    add({0});
    for (const SearchGoal& goal : goals_) add(goal);
    add({1});
    const auto is_beaten = [&](const OptimisePoint* point) {
      return std::any_of(best.begin(), best.end(), [&](const OptimisePoint* other) {
        return other != point && scaled_aim(*other, 0) <= scaled_aim(*point, 0) &&
               scaled_aim(*other, 1) <= scaled_aim(*point, 1);
      });
    };
    std::vector<const OptimisePoint*> kept;
    std::copy_if(best.begin(), best.end(), std::back_inserter(kept),
                 [&](const auto* point) { return !is_beaten(point); });
    std::stable_sort(kept.begin(), kept.end(),
                     [&](const auto* a, const auto* b) { return scaled_aim(*a, 0) < scaled_aim(*b, 0); });
    result_.front.reserve(kept.size());
    for (const OptimisePoint* point : kept) result_.front.push_back(number_of(point));
  }

  [[nodiscard]] std::size_t number_of(const OptimisePoint* point) const {
    return static_cast<std::size_t>(point - result_.points.data());
  }

  /// The point of the front that is nearest to the best of both aims, each in parts of its range along the front.
  [[nodiscard]] std::size_t middle_of_front() const {
    const OptimisePoint& first = result_.points[result_.front.front()];
    const OptimisePoint& last = result_.points[result_.front.back()];
    const auto part = [&](const OptimisePoint& point, std::size_t aim, const OptimisePoint& best,
                          const OptimisePoint& worst) {
      const double range = worst.aims[aim] - best.aims[aim];
      return range == 0.0 ? 0.0 : (point.aims[aim] - best.aims[aim]) / range;
    };
    const auto distance = [&](std::size_t number) {
      const OptimisePoint& point = result_.points[number];
      return std::hypot(part(point, 0, first, last), part(point, 1, last, first));
    };
    return *std::min_element(result_.front.begin(), result_.front.end(),
                             [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  }

  /// Whether the search that met the best of an aim ended by its tolerance.
  [[nodiscard]] OptimiseStatus end_of(const OptimisePoint& best) const {
    OptimiseStatus status = OptimiseStatus::evaluations_spent;
    for (const OptimiseSearch& one : result_.searches) {
      if (one.best != best.values) continue;
      if (one.by_tolerance) return OptimiseStatus::converged;
      if (one.by_rounding) status = OptimiseStatus::rounding_limited;
    }
    return status;
  }

  void conclude() {
    const OptimisePoint* best = best_of(result_.points, {0});
    if (best == nullptr) {
      find_nearest();
      result_.status = stopped_          ? OptimiseStatus::interrupted
                       : result_.nearest ? OptimiseStatus::infeasible
                                         : OptimiseStatus::no_result;
      return;
    }
    if (two_aims()) {
      keep_front();
      best = &result_.points[middle_of_front()];
    }
    result_.best = number_of(best);
    result_.optimised = model_.case_with(best->values);
    result_.status = OptimiseStatus::interrupted;
    if (stopped_) return;
    for (std::size_t aim = 0; aim < result_.aims.size(); ++aim) {
      result_.status = end_of(*best_of(result_.points, {aim}));
      if (result_.status != OptimiseStatus::converged) break;
    }
    const auto again = model_.evaluate(best->values, {}, &result_.warnings);
    const bool same =
        again && again->status == PointStatus::converged && again->aims == best->aims && again->limits == best->limits;
    if (!same) result_.status = OptimiseStatus::not_confirmed;
  }

  void find_nearest() {
    for (const OptimisePoint& point : result_.points) {
      if (point.status != PointStatus::converged) continue;
      if (!result_.nearest || merit(point, {0}) < merit(result_.points[*result_.nearest], {0})) {
        result_.nearest = number_of(&point);
      }
    }
  }

  OptimiseModel model_;
  const OptimiseSettings& settings_;
  const ProgressCallback& progress_;
  unsigned threads_;
  OptimiseResult result_;
  KeyValues start_;
  KnownPoints known_;
  std::vector<double> aim_scales_;
  std::vector<double> limit_scales_;
  std::vector<SearchGoal> goals_;  ///< between the ends of the front
  bool stopped_{};
};

}  // namespace

bool OptimiseResult::is_feasible(const OptimisePoint& point) const {
  if (point.status != PointStatus::converged) return false;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (!(limits[i].margin(point.limits[i]) > 0.0)) return false;
  }
  return true;
}

int OptimiseResult::bound_of(std::size_t key) const {
  const OptimisedKey& one = settings.keys[key];
  const double value = points[*best].values[key];
  const double near = settings.tolerance * (one.upper - one.lower);
  return value - one.lower <= near ? -1 : one.upper - value <= near ? 1 : 0;
}

bool OptimiseResult::is_active(std::size_t limit) const {
  return relative_miss(limits[limit], points[*best].limits[limit]) > -active_part;
}

double relative_miss(const OptimiseLimit& limit, double value) {
  const double size = std::abs(limit.bound);
  return -limit.margin(value) / (size > 0.0 ? size : std::max(std::abs(value), std::numeric_limits<double>::min()));
}

OptimiseResult run_optimise(const Case& input, const ProgressCallback& progress, unsigned threads) {
  return Optimiser(input, progress, threads).run();
}

}  // namespace bumpfoil
