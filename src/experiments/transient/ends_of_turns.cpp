#include "experiments/transient/ends_of_turns.hpp"

#include <algorithm>

#include "bumpfoil/motion/speed_program.hpp"

namespace bumpfoil {
namespace {

/// Rows read at a time.
constexpr std::size_t angles_at_once = 10'000;

}  // namespace

std::vector<std::size_t> ends_of_turns(
    std::size_t rows, const std::function<std::vector<double>(std::size_t first, std::size_t count)>& angles) {
  std::vector<std::size_t> ends;
  for (std::size_t first = 0; first < rows; first += angles_at_once) {
    const std::vector<double> some = angles(first, std::min(angles_at_once, rows - first));
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (whole_turns(some[i]) >= std::ssize(ends)) ends.push_back(first + i);
    }
  }
  return ends;
}

}  // namespace bumpfoil
