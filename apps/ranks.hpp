#pragma once

#include <optional>
#include <string>

namespace bumpfoil {

/// What a letter from rank to rank is about.
enum class Subject {
  order,    ///< to help with an ensemble
  samples,  ///< to run
  rows,     ///< of samples that were run
  refusal,  ///< why no help is to be expected
  enough,   ///< of this ensemble
  end,      ///< of all
};

struct Letter {
  int rank{};  ///< that it comes from
  Subject subject{};
  std::string text;
};

/// The processes that mpirun, or another launcher of MPI, started together, this one among them; one where there is no
/// launcher. All calls must come from the thread that made it.
class Ranks {
 public:
  /// @throws Error (input) where there are several, and the program was built without MPI
  Ranks();
  /// Waits for the others.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  void send(int rank, Subject subject, const std::string& text = {}) const;

  /// A letter that has come, if there is one.
  [[nodiscard]] std::optional<Letter> receive() const;

 private:
  int rank_{0};
  int size_{1};
};

}  // namespace bumpfoil
