#include "bumpfoil/optimise/optimise.hpp"

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
#include "optimise/constrained_search.hpp"
#include "optimise/key_box.hpp"
#include "optimise/optimise_model.hpp"
#include "optimise/point_merits.hpp"

namespace bumpfoil {
namespace {

/// Number of sample points per key, of which the best are further starts, and their maximum fraction of all
/// evaluations.
constexpr std::size_t places_per_key = 4;
constexpr double part_of_places = 1.0 / 3.0;
/// With two aims, the fraction of the other evaluations for the ends of the front.
constexpr double part_of_ends = 0.5;
/// First steps of searches relative to the distance between bounds: from given starts, and from a neighbour on the
/// front.
constexpr double wide_step = 0.25;
constexpr double near_step = 0.08;
/// Minimum distance between starts in at least one key, if possible.
constexpr double least_apart = 0.15;
/// Searches satisfy their constraints with this fraction of their tolerance as margin, so that they end within limits.
constexpr double kept_part_of_tolerance = 0.1;
/// A limit is active if its margin is below this fraction of its bound.
constexpr double active_part = 0.01;

/// Evaluated points, in the order of their evaluation.
class KnownPoints {
 public:
  [[nodiscard]] const OptimisePoint* find(const KeyValues& values) const {
    const auto found = numbers_.find(values);
    return found == numbers_.end() ? nullptr : &points_[found->second];
  }

  /// Known points keep their indices.
  void add(OptimisePoint point) {
    if (numbers_.try_emplace(point.values, points_.size()).second) points_.push_back(std::move(point));
  }

  [[nodiscard]] const std::vector<OptimisePoint>& all() const { return points_; }

 private:
  std::vector<OptimisePoint> points_;
  std::map<KeyValues, std::size_t> numbers_;
};

/// A search and its result.
struct SearchRun {
  SearchGoal goal;
  KeyValues start;
  double step{wide_step};
  std::size_t budget{};  ///< maximum number of evaluations
  std::size_t number{};
  std::vector<OptimisePoint> evaluated{};
  OptimiseSearch record{};

  [[nodiscard]] bool ended() const { return record.by_tolerance || record.by_round_off; }
};

class Optimiser {
 public:
  Optimiser(const Case& input, const ProgressCallback& progress, unsigned threads)
      : model_(input),
        settings_(model_.settings()),
        box_(settings_.keys),
        progress_(progress),
        threads_(threads > 0 ? threads : available_threads()),
        start_(box_.short_values(model_.start())) {
    result_.settings = settings_;
    result_.key_units = model_.key_units();
    result_.aims = model_.aims();
    result_.limits = model_.limits();
    result_.optimised = input;
    result_.optimised.settings.remove<OptimiseSettings>();
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

  /// Executes several points, or searches, on all threads. @param run  (number, goes_on)
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
    Eigen::VectorXd shift(box_.dimensions());
    for (Eigen::Index i = 0; i < shift.size(); ++i) {
      shift[i] = uniform_draw({static_cast<std::uint64_t>(settings_.seed), 0, 0, static_cast<std::uint32_t>(i)});
    }
    places_due.reserve(places());
    for (std::size_t k = 1; k < places(); ++k) places_due.push_back(box_.values_at(even_point(k, shift)));
    std::vector<std::optional<OptimisePoint>> found(places_due.size());
    run_all(places_due.size(), places_due.size(), [&](std::size_t i, const ProgressCallback& goes_on) {
      found[i] = model_.evaluate(places_due[i], goes_on);
    });
    for (auto& point : found) {
      if (point) known_.add(std::move(*point));
    }
    merits_.take_sizes(known_.all());
  }

  /// The given start, and the best sample points that are far enough apart.
  [[nodiscard]] std::vector<KeyValues> starts_for(const SearchGoal& goal) const {
    std::vector<const OptimisePoint*> order;
    for (const OptimisePoint& point : known_.all()) {
      if (point.status == PointStatus::converged) order.push_back(&point);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](const auto* a, const auto* b) { return merits_.merit(*a, goal) < merits_.merit(*b, goal); });
    std::vector<KeyValues> starts{start_};
    const auto add = [&](bool apart) {
      for (const OptimisePoint* point : order) {
        if (std::ssize(starts) >= settings_.starts) return;
        const bool near = std::any_of(starts.begin(), starts.end(), [&](const KeyValues& other) {
          const double far = (box_.place_of(other) - box_.place_of(point->values)).cwiseAbs().maxCoeff();
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

  /// Searches from the best point of an aim, if another search found it.
  [[nodiscard]] std::vector<SearchRun> last_searches() {
    std::vector<SearchRun> runs;
    for (std::size_t aim = 0; aim < result_.aims.size(); ++aim) {
      const OptimisePoint* const best = merits_.best_of(known_.all(), {aim});
      if (best == nullptr || end_of(*best) == OptimiseStatus::converged) continue;
      runs.push_back({.goal = {aim}, .start = best->values, .step = near_step});
    }
    return runs;
  }

  /// Total evaluations of such searches.
  [[nodiscard]] std::size_t part_of_first() const {
    const double part = two_aims() && settings_.front > 0 ? part_of_ends : 1.0;
    return static_cast<std::size_t>(part * static_cast<double>(evaluations_left()));
  }

  /// Performs a search; the points it evaluates are added to `run.evaluated`.
  void search(SearchRun& run, const ProgressCallback& goes_on) {
    KnownPoints own;
    double worst = 0.0;
    std::optional<OptimisePoint> best_met;
    const double kept = kept_part_of_tolerance * settings_.tolerance;
    const auto evaluate = [&](const Eigen::VectorXd& x, double& aim, Eigen::VectorXd& limits) {
      const KeyValues values = box_.values_at(x);
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
        // Worse than all points of the search so far, so that its models lead away from here.
        aim = worst + 1.0;
        limits.setOnes();
        return true;
      }
      aim = merits_.scaled_aim(*point, run.goal.aim);
      worst = std::max(worst, aim);
      limits = merits_.scaled_limits(*point, run.goal).array() + kept;
      if (merits_.meets(*point, run.goal) && (!best_met || aim < merits_.scaled_aim(*best_met, run.goal.aim)))
        best_met = *point;
      return true;
    };
    const SearchProblem problem{.limits = std::ssize(result_.limits) + (run.goal.other ? 1 : 0), .evaluate = evaluate};
    const SearchEnd end = search_constrained(problem, box_.place_of(run.start), run.step, settings_.tolerance);
    run.record.by_tolerance = end == SearchEnd::tolerance;
    run.record.by_round_off = end == SearchEnd::round_off;
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

  /// Unused evaluations of some searches go to those that need more. These restart: known points cost nothing.
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

  /// Two chains of searches from the ends of the front to its middle, each starting from the best of its neighbour.
  void follow_front() {
    const OptimisePoint* const first = merits_.best_of(known_.all(), {0});
    const OptimisePoint* const last = merits_.best_of(known_.all(), {1});
    if (first == nullptr || settings_.front == 0 || first->aims[1] == last->aims[1]) return;
    goals_ = merits_.goals_between(*first, *last, settings_.front);
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

  [[nodiscard]] std::size_t number_of(const OptimisePoint* point) const {
    return static_cast<std::size_t>(point - result_.points.data());
  }

  /// Whether the search that found the best of an aim ended by its tolerance.
  [[nodiscard]] OptimiseStatus end_of(const OptimisePoint& best) const {
    OptimiseStatus status = OptimiseStatus::evaluations_spent;
    for (const OptimiseSearch& one : result_.searches) {
      if (one.best != best.values) continue;
      if (one.by_tolerance) return OptimiseStatus::converged;
      if (one.by_round_off) status = OptimiseStatus::rounding_limited;
    }
    return status;
  }

  void conclude() {
    const OptimisePoint* best = merits_.best_of(result_.points, {0});
    if (best == nullptr) {
      find_nearest();
      result_.status = stopped_          ? OptimiseStatus::interrupted
                       : result_.nearest ? OptimiseStatus::infeasible
                                         : OptimiseStatus::no_result;
      return;
    }
    if (two_aims()) {
      result_.front = merits_.front_of(result_.points, goals_);
      best = &result_.points[middle_of_front(result_.points, result_.front)];
    }
    result_.best = number_of(best);
    result_.optimised = model_.case_with(best->values);
    result_.status = OptimiseStatus::interrupted;
    if (stopped_) return;
    for (std::size_t aim = 0; aim < result_.aims.size(); ++aim) {
      result_.status = end_of(*merits_.best_of(result_.points, {aim}));
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
      if (!result_.nearest || merits_.merit(point, {0}) < merits_.merit(result_.points[*result_.nearest], {0})) {
        result_.nearest = number_of(&point);
      }
    }
  }

  OptimiseModel model_;
  const OptimiseSettings& settings_;
  KeyBox box_;
  const ProgressCallback& progress_;
  unsigned threads_;
  OptimiseResult result_;
  PointMerits merits_{result_};
  KeyValues start_;
  KnownPoints known_;
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
