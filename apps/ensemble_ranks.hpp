#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/model/case.hpp"
#include "ranks.hpp"

namespace bumpfoil {

// An ensemble on several ranks. The first rank reads the case, hands out samples and writes; the others do nothing but
// run samples of it. Each asks for as many as keep its threads busy for a while, and brings along the rows of those it
// has run: whoever is faster gets more.

/// The first rank's side.
class EnsembleHelpers {
 public:
  /// Orders all other ranks to help.
  /// @param threads  of each; where it is not given each takes as many as it may
  EnsembleHelpers(const Ranks& ranks, const Case& input, std::optional<unsigned> threads);
  /// Ends their help, whatever they are doing.
  ~EnsembleHelpers();
  EnsembleHelpers(const EnsembleHelpers&) = delete;
  EnsembleHelpers& operator=(const EnsembleHelpers&) = delete;

  /// Takes the rows that have come, and gives samples to those who ask.
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

/// The other ranks' side: helps until the first rank has nothing more for it.
void help(const Ranks& ranks);

/// Lets the other ranks go in the end, however that comes; for the first one.
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
