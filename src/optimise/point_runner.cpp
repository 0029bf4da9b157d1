#include "optimise/point_runner.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/ensemble/ensemble_yield.hpp"
#include "bumpfoil/ensemble/statistics.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/sweep/sweep.hpp"
#include "sweep/sweep_layout.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view yield_name = "yield";

/// The worst of some numbers. @param largest  whether the largest is the worst
double worst_of(const std::vector<double>& numbers, bool largest) {
  double worst = absent;
  for (const double number : numbers) {
    if (std::isnan(number)) continue;
    if (std::isnan(worst) || (largest ? number > worst : number < worst)) worst = number;
  }
  return worst;
}

/// Runs an experiment, as at the points of sweeps.
class ExperimentRunner final : public PointRunner {
 public:
  ExperimentRunner(const ExperimentInfo& experiment, const Case& input) : experiment_(experiment) {
    const Dataset none = experiment.sweeping->not_begun(input).swept(false).dataset;
    for (const Variable& variable : none.variables) {
      const VariableMeaning& meaning = variable.meaning;
      // Machine-dependent numbers are not quantities of a design.
      const bool of_run = (meaning.tags & tag::of_solver) != 0 || meaning.name == "wall_time";
      if (meaning.form.kind == Form::real && !of_run) meanings_.push_back(meaning);
    }
  }

  [[nodiscard]] std::vector<LimitedQuantity> quantities() const override {
    return each(meanings_, [](const VariableMeaning& one) { return LimitedQuantity{one.name, one.unit}; });
  }

  [[nodiscard]] ShownUnit shown(std::size_t quantity) const override { return meanings_[quantity].shown; }

  [[nodiscard]] PointRun run(const Case& input, const std::vector<OptimisedQuantity>& wanted,
                             const ProgressCallback& progress) const override {
    const Sweep alone{.experiment = &experiment_, .axes = {}, .cases = {input}};
    const SweepPoint point = run_point(alone, 0, progress);
    return {.status = point.status,
            .values = each(wanted,
                           [&point](const OptimisedQuantity& one) {
                             return worst_of(values_of(point, one.name, 0), one.largest);
                           }),
            .failures = point.failures,
            .warnings = point.warnings};
  }

 private:
  const ExperimentInfo& experiment_;
  std::vector<VariableMeaning> meanings_;
};

/// A statistic, by its name in summary.json.
struct NamedStatistic {
  std::string name;
  std::function<double(const Statistics&)> value;
};

const std::vector<NamedStatistic>& named_statistics() {
  static const std::vector<NamedStatistic> all = [] {
    std::vector<NamedStatistic> list{{"mean", [](const Statistics& one) { return one.mean; }},
                                     {"std", [](const Statistics& one) { return one.deviation; }}};
    for (std::size_t i = 0; i < percentiles.size(); ++i) {
      list.push_back({fmt::format("p{}", percentiles[i]), [i](const Statistics& one) { return one.percentile[i]; }});
    }
    return list;
  }();
  return all;
}

/// Runs an ensemble: the same random samples at every point, so that points differ by their keys only.
class EnsembleRunner final : public PointRunner {
 public:
  EnsembleRunner(const Case& input, const OptimiseSettings& settings, std::vector<InputError>& errors)
      : texts_(settings.bearing_limits) {
    const EnsembleLayout layout = make_ensemble_layout(input);
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      try {
        static_cast<void>(parse_limits({texts_[i]}, layout));
      } catch (const Error& error) {
        for (InputError one : error.errors()) {
          one.key = fmt::format("optimise.bearing_limits[{}]", i + 1);
          errors.push_back(std::move(one));
        }
      }
    }
    if (!texts_.empty()) kept_.push_back({std::string(yield_name), "1", shown::unitless, 0, 0});
    for (std::size_t column = 1; column < layout.columns.size(); ++column) {
      const VariableMeaning& meaning = layout.columns[column].meaning;
      if (meaning.form.kind != Form::real || (meaning.tags & tag::no_limits) != 0) continue;
      for (std::size_t i = 0; i < named_statistics().size(); ++i) {
        const std::string name = meaning.name + '.' + named_statistics()[i].name;
        kept_.push_back({name, meaning.unit, meaning.shown, column, i});
      }
    }
  }

  [[nodiscard]] std::vector<LimitedQuantity> quantities() const override {
    return each(kept_, [](const Kept& one) { return LimitedQuantity{one.name, one.unit}; });
  }

  [[nodiscard]] ShownUnit shown(std::size_t quantity) const override { return kept_[quantity].shown; }

  [[nodiscard]] PointRun run(const Case& input, const std::vector<OptimisedQuantity>& wanted,
                             const ProgressCallback& progress) const override {
    const EnsembleLayout layout = make_ensemble_layout(input);
    const auto samples = static_cast<std::size_t>(input.montecarlo->samples);
    std::vector<std::optional<std::vector<double>>> rows(samples);
    EnsembleSampler sampler(input, layout);
    std::atomic<bool> stopped{false};
    const ProgressCallback goes_on = [&](double fraction) {
      if (progress && !progress(fraction)) stopped = true;
      return !stopped;
    };
    // Isolated, so that a search only waits for its own samples.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(std::size_t{0}, samples, [&](std::size_t i) {
        if (!stopped) rows[i] = sampler.run(i, goes_on);
      });
    });
    if (stopped) return {.status = RunStatus::interrupted};
    return read_rows(layout, rows, wanted, input);
  }

 private:
  struct Kept {
    std::string name;
    std::string unit;
    ShownUnit shown;
    std::size_t column;
    std::size_t statistic;
  };

  [[nodiscard]] PointRun read_rows(const EnsembleLayout& layout,
                                   const std::vector<std::optional<std::vector<double>>>& rows,
                                   const std::vector<OptimisedQuantity>& wanted, const Case& input) const {
    const auto entry = [&rows](std::size_t place) {
      return each(rows, [place](const auto& row) { return (*row)[place]; });
    };
    std::size_t failed = 0;
    for (const auto& row : rows) {
      bool good = true;
      for (std::size_t place = 0; place < layout.places.size(); ++place) {
        good = good && (*row)[layout.entry(place, 0)] == 0.0;
      }
      failed += good ? 0 : 1;
    }
    PointRun run{.status = RunStatus::complete, .warnings = case_warnings(input)};
    for (const OptimisedQuantity& one : wanted) {
      const Kept& kept = *std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.name == one.name; });
      if (kept.column == 0) {
        const EnsembleYields yields = make_yields(parse_limits(texts_, layout), layout, rows.size(), entry);
        run.values.push_back(static_cast<double>(yields.all.passed) / static_cast<double>(yields.all.samples));
        continue;
      }
      // A failed sample counts against the yield; statistics of the others would be too optimistic.
      if (failed > 0) run.status = RunStatus::failed;
      std::vector<double> places;
      places.reserve(layout.places.size());
      for (std::size_t place = 0; place < layout.places.size(); ++place) {
        const Statistics statistics =
            statistics_of(entry(layout.entry(place, kept.column)), layout.columns[kept.column].undefined);
        places.push_back(named_statistics()[kept.statistic].value(statistics));
      }
      run.values.push_back(worst_of(places, one.largest));
    }
    if (run.status == RunStatus::failed) {
      run.failures.push_back(fmt::format("{} of {} samples failed", failed, rows.size()));
    }
    return run;
  }

  std::vector<std::string> texts_;
  std::vector<Kept> kept_;
};

}  // namespace

std::unique_ptr<const PointRunner> make_point_runner(const Case& input, const OptimiseSettings& settings,
                                                     std::vector<InputError>& errors) {
  if (settings.runs_ensembles()) {
    return std::make_unique<EnsembleRunner>(input, settings, errors);
  }
  return std::make_unique<ExperimentRunner>(experiment_named(settings.command), input);
}

}  // namespace bumpfoil
