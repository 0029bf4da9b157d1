#include "bumpfoil/ensemble/ensemble_run.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {
namespace {

using Clock = std::chrono::steady_clock;
/// Time between writes to the log: the work lost in a power failure.
constexpr auto write_interval = std::chrono::milliseconds(200);
/// Memory for rows that wait for an earlier one.
constexpr std::size_t buffer_bytes = std::size_t{64} << 20U;
/// Keeps the maximum number of threads busy.
constexpr std::size_t smallest_window = 1024;

/// Writes rows to the log in order, and checks after whole rounds whether they suffice.
class Writer {
 public:
  Writer(RunFlow& flow, std::size_t window, RowLog& log, const std::function<bool()>& enough)
      : flow_(flow), window_(window), log_(log), enough_(enough), is_enough_(log.rows() > 0 && asks()) {}

  [[nodiscard]] bool is_enough() const { return is_enough_; }

  [[nodiscard]] bool is_time() const {
    return Clock::now() - last_write_ >= write_interval || flow_.waiting() > window_ / 2;
  }

  void write() {
    while (!is_enough_) {
      const std::vector<double> rows = flow_.leave(ensemble_round - log_.rows() % ensemble_round);
      if (rows.empty()) break;
      log_.append(rows);
      is_enough_ = asks();
    }
    last_write_ = Clock::now();
  }

 private:
  [[nodiscard]] bool asks() const { return enough_ && log_.rows() % ensemble_round == 0 && enough_(); }

  RunFlow& flow_;
  std::size_t window_;
  RowLog& log_;
  const std::function<bool()>& enough_;
  bool is_enough_;
  Clock::time_point last_write_{Clock::now()};
};

}  // namespace

EnsembleSampler::EnsembleSampler(const Case& input, const EnsembleLayout& layout) : input_(input), layout_(layout) {}

std::optional<std::vector<double>> EnsembleSampler::run(std::size_t number, const ProgressCallback& progress) {
  const Case sampled = sampled_case(input_, draw_sample(input_, number));
  bool stopped = false;
  const ProgressCallback goes_on = [&](double fraction) {
    stopped = stopped || !progress(fraction);
    return !stopped;
  };
  SampleRun run = take_run();
  std::optional<std::vector<SampledPlace>> found;
  try {
    found = run(sampled, goes_on);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::input) throw;
  }
  give_back(std::move(run));
  if (stopped) return std::nullopt;
  return make_ensemble_row(layout_, found);
}

SampleRun EnsembleSampler::take_run() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      SampleRun run = std::move(idle_.back());
      idle_.pop_back();
      return run;
    }
  }
  return experiment_named(input_.montecarlo->command).sampling->begin(input_);
}

void EnsembleSampler::give_back(SampleRun run) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(run));
}

bool run_ensemble(const Case& input, const EnsembleLayout& layout, RowLog& log, const EnsembleRun& run) {
  const auto samples = static_cast<std::size_t>(input.montecarlo->samples);
  const std::size_t window = std::max(smallest_window, buffer_bytes / (layout.width() * sizeof(double)));
  RunFlow flow(log.rows(), std::max(samples, log.rows()), window);
  Writer writer(flow, window, log, run.enough);
  if (writer.is_enough()) return true;
  EnsembleSampler sampler(input, layout);
  const bool finished = run_in_parallel(
      flow, run.threads,
      [&](std::size_t number, const ProgressCallback& progress) {
        std::optional<std::vector<double>> row = sampler.run(number, progress);
        if (row) flow.put(number, std::move(*row));
      },
      [&] {
        if (run.share) run.share(flow);
        if (writer.is_time()) writer.write();
        return !writer.is_enough() && (!run.progress || run.progress(static_cast<double>(flow.done())));
      });
  writer.write();
  return finished || writer.is_enough();
}

}  // namespace bumpfoil
