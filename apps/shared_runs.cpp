#include "shared_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <iterator>
#include <mutex>
#include <numeric>
#include <string_view>
#include <thread>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/results/run_identity.hpp"
#include "interruption.hpp"

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
/// Maximum time between messages of a rank, and so the delay of its results.
constexpr auto letter_interval = 200ms;
/// Interval between two checks for messages.
constexpr auto polling_interval = 20ms;

// Messages consist of lines and runs: each run is a line with its number and the size of its bytes, followed by the
// bytes. All ranks have the same kind of machine.
std::string take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  BUMPFOIL_ASSERT(end != std::string_view::npos);
  std::string line(text.substr(0, end));
  text.remove_prefix(end + 1);
  return line;
}

std::string text_of(const std::vector<SharedRun>& runs) {
  std::string text;
  for (const SharedRun& run : runs) text += fmt::format("{} {}\n{}", run.number, run.bytes.size(), run.bytes);
  return text;
}

std::vector<SharedRun> runs_of(std::string_view text) {
  std::vector<SharedRun> runs;
  while (!text.empty()) {
    const std::string line = take_line(text);
    const std::size_t size = std::stoul(line.substr(line.find(' ')));
    runs.push_back({std::stoul(line), std::string(text.substr(0, size))});
    text.remove_prefix(size);
  }
  return runs;
}

/// The runs received by a rank, and the results of completed ones.
class HandedRuns : public RunQueue {
 public:
  std::optional<std::size_t> next() override {
    std::unique_lock lock(mutex_);
    ++idle_;
    changed_.wait(lock, [this] { return closed_ || !given_.empty(); });
    --idle_;
    if (closed_) return std::nullopt;
    const std::size_t number = given_.front().number;
    begun_.push_back(std::move(given_.front()));
    given_.pop_front();
    return number;
  }

  void close() override {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  void give(std::vector<SharedRun> runs) {
    const std::lock_guard lock(mutex_);
    std::move(runs.begin(), runs.end(), std::back_inserter(given_));
    changed_.notify_all();
  }

  /// A run that next() has returned.
  [[nodiscard]] SharedRun begun(std::size_t number) {
    const std::lock_guard lock(mutex_);
    const auto run =
        std::find_if(begun_.begin(), begun_.end(), [&](const SharedRun& one) { return one.number == number; });
    SharedRun found = std::move(*run);
    begun_.erase(run);
    return found;
  }

  [[nodiscard]] std::size_t left() const {
    const std::lock_guard lock(mutex_);
    return given_.size();
  }

  /// Number of threads waiting for runs.
  [[nodiscard]] std::size_t idle() const {
    const std::lock_guard lock(mutex_);
    return idle_;
  }

  void put(SharedRun done) {
    const std::lock_guard lock(mutex_);
    done_.push_back(std::move(done));
  }

  std::vector<SharedRun> take_done() {
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, {});
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<SharedRun> given_;
  std::vector<SharedRun> begun_, done_;
  std::size_t idle_{};
  bool closed_{};
};

/// Communicates with the first rank: requests runs and sends results.
class Helper {
 public:
  Helper(const Ranks& ranks, HandedRuns& runs) : ranks_(ranks), runs_(runs) {}

  /// @return false if no more runs are needed
  bool tick() {
    if (const std::optional<Letter> letter = ranks_.receive()) {
      if (letter->subject == Subject::enough) return false;
      runs_.give(runs_of(letter->text));
      asked_ = false;
    }
    const Clock::time_point now = Clock::now();
    const bool wants = runs_.idle() > 0 || (stock_ > 0 && runs_.left() <= stock_ / 2);
    if (!asked_ && (wants || now - last_letter_ >= letter_interval)) ask(now);
    return true;
  }

 private:
  void ask(Clock::time_point now) {
    const std::vector<SharedRun> done = runs_.take_done();
    // Twice the number completed between two messages, so that threads do not wait for the reply. Long runs are not
    // stocked: other ranks may be free for them.
    const double rate = static_cast<double>(done.size()) / std::chrono::duration<double>(now - last_letter_).count();
    stock_ = static_cast<std::size_t>(rate * 2.0 * std::chrono::duration<double>(letter_interval).count());
    const std::size_t wanted = std::max(stock_, runs_.idle());
    ranks_.send(0, Subject::done, fmt::format("{}\n", wanted - std::min(wanted, runs_.left())) + text_of(done));
    asked_ = true;
    last_letter_ = now;
  }

  const Ranks& ranks_;
  HandedRuns& runs_;
  std::size_t stock_{};  ///< number of runs in reserve
  bool asked_{};
  Clock::time_point last_letter_{Clock::now()};
};

/// Executes runs until the first rank needs no more.
void help_with(const Ranks& ranks, std::string_view text, const std::vector<SharedCommand>& commands) {
  const std::string command = take_line(text);
  const auto threads = static_cast<unsigned>(std::stoul(take_line(text)));
  const auto shared =
      std::find_if(commands.begin(), commands.end(), [&](const SharedCommand& one) { return one.name == command; });
  BUMPFOIL_ASSERT(shared != commands.end());
  const RunOfOrder run = shared->made_ready(std::string(text));
  HandedRuns runs;
  Helper helper(ranks, runs);
  run_in_parallel(
      runs, threads > 0 ? threads : available_threads(),
      [&](std::size_t number, const ProgressCallback& progress) {
        std::optional<std::string> given = run(runs.begun(number), progress);
        if (given) runs.put({number, *std::move(given)});
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

std::vector<SharedRun> runs_in(const RunRange& range) {
  std::vector<SharedRun> runs(range.count);
  for (std::size_t i = 0; i < range.count; ++i) runs[i].number = range.first + i;
  return runs;
}

RankHelpers::RankHelpers(const Ranks& ranks, const SharedWork& work)
    : ranks_(ranks), helps_(static_cast<std::size_t>(ranks.size())), runs_(helps_.size()) {
  const std::string order = fmt::format("{}\n{}\n{}", work.command, work.threads.value_or(0), work.order);
  for (int rank = 1; rank < ranks.size(); ++rank) {
    ranks_.send(rank, Subject::order, order);
    helps_[static_cast<std::size_t>(rank)] = true;
  }
}

RankHelpers::~RankHelpers() {
  while (std::find(helps_.begin(), helps_.end(), true) != helps_.end()) {
    const Letter letter = wait_for_letter(ranks_);
    helps_[static_cast<std::size_t>(letter.rank)] = false;
    if (letter.subject == Subject::done) ranks_.send(letter.rank, Subject::enough);
  }
}

void RankHelpers::share(const std::function<std::vector<SharedRun>(std::size_t)>& hand_out,
                        const std::function<void(SharedRun)>& take) {
  while (const std::optional<Letter> letter = ranks_.receive()) {
    if (letter->subject == Subject::refusal) {
      helps_[static_cast<std::size_t>(letter->rank)] = false;
      throw Error(ErrorKind::input, {{fmt::format("rank {}", letter->rank), 0, "", "", letter->text, ""}});
    }
    std::string_view text = letter->text;
    const std::size_t wanted = std::stoul(take_line(text));
    for (SharedRun& run : runs_of(text)) {
      ++runs_[static_cast<std::size_t>(letter->rank)];
      take(std::move(run));
    }
    ranks_.send(letter->rank, Subject::runs, text_of(hand_out(wanted)));
  }
}

std::string RankHelpers::shares_text(std::size_t all, const char* what) const {
  if (runs_.size() < 2) return {};
  std::vector<std::size_t> shares = runs_;
  shares.front() = all - std::min(all, std::accumulate(shares.begin(), shares.end(), std::size_t{0}));
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  return fmt::format("\n{} ranks ran {} to {} {} each\n", shares.size(), *least, *most, what);
}

void help(const Ranks& ranks, const std::vector<SharedCommand>& commands) {
  const InterruptionGuard guard;  // signals reach all ranks; the first one decides
  for (;;) {
    const Letter letter = wait_for_letter(ranks);
    if (letter.subject == Subject::end) return;
    if (letter.subject != Subject::order) continue;  // reply to a request before this rank failed
    try {
      help_with(ranks, letter.text, commands);
    } catch (const std::exception& error) {
      ranks.send(0, Subject::refusal, error.what());
    }
  }
}

Case case_of_same_program(const std::string& identity) {
  Case input = case_of_identity(identity);
  if (run_identity(input) == identity) return input;
  throw Error(ErrorKind::input, {{"", 0, "", "", "is not the same program on the same kind of machine as rank 0",
                                  "run the same program on all ranks: otherwise their numbers would differ"}});
}

Dismissal::~Dismissal() {
  for (int rank = 1; rank < ranks_.size(); ++rank) ranks_.send(rank, Subject::end);
}

}  // namespace bumpfoil
