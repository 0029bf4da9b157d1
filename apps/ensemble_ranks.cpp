#include "ensemble_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/run_identity.hpp"
#include "interruption.hpp"

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
/// A rank sends at least that often: the longest time that its rows may be in transit.
constexpr auto letter_interval = 200ms;
/// Interval between two checks for messages.
constexpr auto polling_interval = 20ms;

// Messages are numbers in their memory layout: all ranks are machines of one kind.
std::string text_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers(text.size() / sizeof(double));
  std::memcpy(numbers.data(), text.data(), numbers.size() * sizeof(double));
  return numbers;
}

std::string order_for(const Case& input, std::optional<unsigned> threads) {
  return fmt::format("{}\n{}", threads.value_or(0), run_identity(input));
}

/// The samples assigned to a rank, and the rows of those it has run.
class HandedSamples : public RunQueue {
 public:
  std::optional<std::size_t> next() override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !given_.empty(); });
    if (closed_) return std::nullopt;
    const std::size_t number = given_.front();
    given_.pop_front();
    return number;
  }

  void close() override {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  void give(SampleRange range) {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < range.count; ++i) given_.push_back(range.first + i);
    changed_.notify_all();
  }

  [[nodiscard]] std::size_t left() const {
    const std::lock_guard lock(mutex_);
    return given_.size();
  }

  void put(std::size_t number, const std::vector<double>& row) {
    const std::lock_guard lock(mutex_);
    rows_.push_back(static_cast<double>(number));
    rows_.insert(rows_.end(), row.begin(), row.end());
  }

  /// Each preceded by its number.
  std::vector<double> take_rows() {
    const std::lock_guard lock(mutex_);
    return std::exchange(rows_, {});
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::size_t> given_;
  std::vector<double> rows_;
  bool closed_{};
};

/// Talks to the first rank: requests samples and sends rows.
class Helper {
 public:
  Helper(const Ranks& ranks, HandedSamples& samples, unsigned threads, std::size_t width)
      : ranks_(ranks), samples_(samples), width_(width), ahead_(2 * std::size_t{threads}), least_(ahead_) {}

  /// @return false if no more samples are needed
  bool tick() {
    if (const std::optional<Letter> letter = ranks_.receive()) {
      if (letter->subject == Subject::enough) return false;
      const std::vector<double> range = numbers_of(letter->text);
      samples_.give({static_cast<std::size_t>(range.at(0)), static_cast<std::size_t>(range.at(1))});
      asked_ = false;
    }
    const Clock::time_point now = Clock::now();
    if (!asked_ && (samples_.left() <= ahead_ / 2 || now - last_letter_ >= letter_interval)) ask(now);
    return true;
  }

 private:
  void ask(Clock::time_point now) {
    std::vector<double> letter{0.0};
    const std::vector<double> rows = samples_.take_rows();
    letter.insert(letter.end(), rows.begin(), rows.end());
    // Twice what is run between two messages: threads must not wait for the reply.
    const double run = static_cast<double>(rows.size()) / static_cast<double>(width_ + 1);
    const double speed = run / std::chrono::duration<double>(now - last_letter_).count();
    ahead_ = std::max(least_,
                      static_cast<std::size_t>(speed * 2.0 * std::chrono::duration<double>(letter_interval).count()));
    letter.front() = static_cast<double>(ahead_ - std::min(ahead_, samples_.left()));
    ranks_.send(0, Subject::rows, text_of(letter));
    asked_ = true;
    last_letter_ = now;
  }

  const Ranks& ranks_;
  HandedSamples& samples_;
  std::size_t width_;
  std::size_t ahead_, least_;  ///< samples to keep in stock
  bool asked_{};
  Clock::time_point last_letter_{Clock::now()};
};

/// Runs samples of an ensemble until the first rank has enough.
void help_with(const Ranks& ranks, const std::string& order) {
  const std::size_t line = order.find('\n');
  const auto threads = static_cast<unsigned>(std::stoul(order.substr(0, line)));
  const std::string identity = order.substr(line + 1);
  const Case input = case_of_identity(identity);
  if (run_identity(input) != identity) {
    throw Error(ErrorKind::input, {{"", 0, "", "", "is not the same program on the same kind of machine as rank 0",
                                    "run the same program on all ranks: otherwise parts of an ensemble would differ"}});
  }
  const EnsembleLayout layout = make_ensemble_layout(input);
  const unsigned workers = threads > 0 ? threads : available_threads();
  EnsembleSampler sampler(input, layout);
  HandedSamples samples;
  Helper helper(ranks, samples, workers, layout.width());
  run_in_parallel(
      samples, workers,
      [&](std::size_t number, const ProgressCallback& progress) {
        const std::optional<std::vector<double>> row = sampler.run(number, progress);
        if (row) samples.put(number, *row);
      },
      [&] { return helper.tick(); });
}

Letter wait_for_letter(const Ranks& ranks) {
  std::optional<Letter> letter = ranks.receive();
  while (!letter) {
    std::this_thread::sleep_for(polling_interval);
    letter = ranks.receive();
  }
  return *std::move(letter);
}

}  // namespace

EnsembleHelpers::EnsembleHelpers(const Ranks& ranks, const Case& input, std::optional<unsigned> threads)
    : ranks_(ranks),
      width_(make_ensemble_layout(input).width()),
      helps_(static_cast<std::size_t>(ranks.size())),
      samples_(helps_.size()) {
  const std::string order = order_for(input, threads);
  for (int rank = 1; rank < ranks.size(); ++rank) {
    ranks_.send(rank, Subject::order, order);
    helps_[static_cast<std::size_t>(rank)] = true;
  }
}

EnsembleHelpers::~EnsembleHelpers() {
  while (std::find(helps_.begin(), helps_.end(), true) != helps_.end()) {
    const Letter letter = wait_for_letter(ranks_);
    helps_[static_cast<std::size_t>(letter.rank)] = false;
    if (letter.subject == Subject::rows) ranks_.send(letter.rank, Subject::enough);
  }
}

void EnsembleHelpers::share(SampleFlow& flow) {
  while (const std::optional<Letter> letter = ranks_.receive()) {
    if (letter->subject == Subject::refusal) {
      helps_[static_cast<std::size_t>(letter->rank)] = false;
      throw Error(ErrorKind::input, {{fmt::format("rank {}", letter->rank), 0, "", "", letter->text, ""}});
    }
    const std::vector<double> numbers = numbers_of(letter->text);
    BUMPFOIL_ASSERT(numbers.size() % (width_ + 1) == 1);
    for (auto row = numbers.begin() + 1; row != numbers.end(); row += static_cast<std::ptrdiff_t>(width_) + 1) {
      ++samples_[static_cast<std::size_t>(letter->rank)];
      flow.put(static_cast<std::size_t>(*row), {row + 1, row + 1 + static_cast<std::ptrdiff_t>(width_)});
    }
    const SampleRange range = flow.take(static_cast<std::size_t>(numbers.front()));
    ranks_.send(letter->rank, Subject::samples,
                text_of({static_cast<double>(range.first), static_cast<double>(range.count)}));
  }
}

void help(const Ranks& ranks) {
  const InterruptionGuard guard;  // signals reach all ranks: the first one decides
  for (;;) {
    const Letter letter = wait_for_letter(ranks);
    if (letter.subject == Subject::end) return;
    if (letter.subject != Subject::order) continue;  // a reply to a request from before this rank failed
    try {
      help_with(ranks, letter.text);
    } catch (const std::exception& error) {
      ranks.send(0, Subject::refusal, error.what());
    }
  }
}

Dismissal::~Dismissal() {
  for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, Subject::end);
}

}  // namespace bumpfoil
