#pragma once

#include <optional>
#include <string>

namespace bumpfoil {

/// Subject of a message between ranks.
enum class Subject {
  order,    ///< request to help
  runs,     ///< to be executed
  done,     ///< results of runs, and the number wanted next
  refusal,  ///< the reason why this rank cannot help
  enough,   ///< end of this order
  end,      ///< end of all work
};

struct Letter {
  int rank{};  ///< of the sender
  Subject subject{};
  std::string text;
};

/// The processes started together by mpirun or another MPI launcher, including this one; a single one without a
/// launcher. All calls must come from the thread that created it.
class Ranks {
 public:
  /// @throws Error (input) if there are several, but the program was built without MPI
  Ranks();
  /// Waits for the others.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  void send(int rank, Subject subject, const std::string& text = {}) const;

  /// A received message, if there is one.
  [[nodiscard]] std::optional<Letter> receive() const;

 private:
  int rank_{0};
  int size_{1};
};

}  // namespace bumpfoil
