#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/ensemble/run_flow.hpp"
#include "bumpfoil/model/case.hpp"
#include "ranks.hpp"

namespace bumpfoil {

// Distribution of runs over several ranks. The first rank reads the case, distributes the runs and writes; the others
// only run. Each requests enough runs to keep its threads busy for a while, and sends the results of completed ones:
// faster ranks get more.

/// A run by its number, with its input or its result as bytes.
struct SharedRun {
  std::size_t number{};
  std::string bytes{};
};

/// Runs of a range whose only input is their number.
std::vector<SharedRun> runs_in(const RunRange& range);

/// Work for the other ranks.
struct SharedWork {
  std::string command;              ///< command of the runs
  std::optional<unsigned> threads;  ///< per rank; by default, each uses its maximum
  std::string order;                ///< input common to all runs, for the command
};

/// The first rank's side.
class RankHelpers {
 public:
  /// Asks all other ranks to help.
  RankHelpers(const Ranks& ranks, const SharedWork& work);
  /// Ends their help immediately.
  ~RankHelpers();
  RankHelpers(const RankHelpers&) = delete;
  RankHelpers& operator=(const RankHelpers&) = delete;

  /// Collects results, and sends runs to ranks that request them.
  /// @param hand_out  returns at most the given number of runs   @param take  receives the result of one
  /// @throws Error (input) if a rank cannot help: it must be the same program on the same kind of machine
  void share(const std::function<std::vector<SharedRun>(std::size_t)>& hand_out,
             const std::function<void(SharedRun)>& take);

  /// Distribution of the runs over ranks, for the terminal; nothing for one rank.
  /// @param all  total over ranks   @param what  name of the runs
  [[nodiscard]] std::string shares_text(std::size_t all, const char* what) const;

 private:
  const Ranks& ranks_;
  std::vector<bool> helps_;  ///< by rank
  std::vector<std::size_t> runs_;
};

/// Executes a run: its result, or nothing if `progress` stopped it. Thread-safe.
using RunOfOrder = std::function<std::optional<std::string>(const SharedRun& run, const ProgressCallback& progress)>;

/// A command whose runs other ranks can execute.
struct SharedCommand {
  std::string name;
  RunOfOrder (*made_ready)(const std::string& order);
};

/// All of them.
std::vector<SharedCommand> shared_commands();

/// The other ranks' side: helps until the first rank has no more work.
void help(const Ranks& ranks, const std::vector<SharedCommand>& commands);

/// The case of an identity.
/// @throws Error (input) if another program, or one on another kind of machine, created it
Case case_of_same_program(const std::string& identity);

/// Releases the other ranks at the end in any case; for the first rank.
class Dismissal {
 public:
  explicit Dismissal(const Ranks& ranks) : ranks_(ranks) {}
  ~Dismissal();
  Dismissal(const Dismissal&) = delete;
  Dismissal& operator=(const Dismissal&) = delete;

 private:
  const Ranks& ranks_;
};

}  // namespace bumpfoil
