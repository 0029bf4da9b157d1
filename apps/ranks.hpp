#pragma once

#include <optional>
#include <string>

namespace bumpfoil {

/// Subject of a message between ranks.
enum class Subject {
  order,    ///< to help
  runs,     ///< to be done
  done,     ///< what runs gave, and how many are wanted next
  refusal,  ///< why this rank cannot help
  enough,   ///< of this order
  end,      ///< of all
};

struct Letter {
  int rank{};  ///< that it comes from
  Subject subject{};
  std::string text;
};

/// The processes that mpirun, or another MPI launcher, started together, including this one; just one without a
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
