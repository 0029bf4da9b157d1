#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/model/case.hpp"
#include "ranks.hpp"

namespace bumpfoil {

// An ensemble on several ranks. The first rank reads the case, distributes samples and writes; the others only run
// samples. Each requests as many as keep its threads busy for a while, and sends the rows of those it has run: faster
// ranks get more.

/// The first rank's side.
class EnsembleHelpers {
 public:
  /// Asks all other ranks to help.
  /// @param threads per rank; if not given, each uses as many as it may
  EnsembleHelpers(const Ranks& ranks, const Case& input, std::optional<unsigned> threads);
  /// Ends their help at once.
  ~EnsembleHelpers();
  EnsembleHelpers(const EnsembleHelpers&) = delete;
  EnsembleHelpers& operator=(const EnsembleHelpers&) = delete;

  /// Takes the rows received, and assigns samples to ranks that request them.
  /// @throws Error (input) if one cannot help: it must be the same program on the same kind of machine
  void share(SampleFlow& flow);

  /// Samples that each rank has run, none for the first one.
  [[nodiscard]] const std::vector<std::size_t>& samples() const { return samples_; }

 private:
  const Ranks& ranks_;
  std::size_t width_;
  std::vector<bool> helps_;  ///< by rank
  std::vector<std::size_t> samples_;
};

/// The other ranks' side: helps until the first rank has no more work.
void help(const Ranks& ranks);

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
