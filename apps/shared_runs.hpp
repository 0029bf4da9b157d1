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

// Runs that several ranks share. The first rank reads the case, distributes the runs and writes; the others only run.
// Each requests as many as keep its threads busy for a while, and sends what those gave that it has done: faster ranks
// get more.

/// A run by its number, and what it needs, or what it gave, as bytes.
struct SharedRun {
  std::size_t number{};
  std::string bytes{};
};

/// Runs of a range that need nothing but their numbers.
std::vector<SharedRun> runs_in(const RunRange& range);

/// Tasks of the other ranks.
struct SharedWork {
  std::string command;              ///< whose runs they are
  std::optional<unsigned> threads;  ///< of each rank; if not given, each uses as many as it may
  std::string order;                ///< what all runs have in common, for the command
};

/// The first rank's side.
class RankHelpers {
 public:
  /// Asks all other ranks to help.
  RankHelpers(const Ranks& ranks, const SharedWork& work);
  /// Ends their help at once.
  ~RankHelpers();
  RankHelpers(const RankHelpers&) = delete;
  RankHelpers& operator=(const RankHelpers&) = delete;

  /// Takes what came back, and hands runs to ranks that request them.
  /// @param hand_out  gives so many runs at most   @param take  takes what one gave
  /// @throws Error (input) if one cannot help: it must be the same program on the same kind of machine
  void share(const std::function<std::vector<SharedRun>(std::size_t)>& hand_out,
             const std::function<void(SharedRun)>& take);

  /// How evenly runs were distributed, for the terminal; nothing where there is one rank.
  /// @param all  of all ranks   @param what  they are
  [[nodiscard]] std::string shares_text(std::size_t all, const char* what) const;

 private:
  const Ranks& ranks_;
  std::vector<bool> helps_;  ///< by rank
  std::vector<std::size_t> runs_;
};

/// Does a run: what it gives, or nothing where `progress` stopped it. For several threads at once.
using RunOfOrder = std::function<std::optional<std::string>(const SharedRun& run, const ProgressCallback& progress)>;

/// A command whose runs other ranks do.
struct SharedCommand {
  std::string name;
  RunOfOrder (*made_ready)(const std::string& order);
};

/// The other ranks' side: helps until the first rank has no more work.
void help(const Ranks& ranks, const std::vector<SharedCommand>& commands);

/// The case of an identity.
/// @throws Error (input) if another program, or one on another kind of machine, has made it
Case case_of_same_program(const std::string& identity);

/// Releases the other ranks at the end, however it comes; for the first one.
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
