#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdint>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "bumpfoil/contact/residual.hpp"
#include "support/random_problem.hpp"
#include "support/siconos_contacts.hpp"

/// Not a test: prints how Siconos solves small random problems, tests/data/siconos.json. Every problem has two
/// increments; the second starts from Siconos' own state after the first.
namespace bumpfoil {
namespace {

constexpr std::uint64_t seeds = 25;
constexpr int block_size = 6;
constexpr int most_blocks = 4;
/// With three unknowns per contact there are 2^9 combinations; the next larger problems have 2^18.
constexpr int blocks_to_enumerate = 1;

struct Forces {
  bool converged{};                      ///< as reported by Siconos
  bool right{};                          ///< by the residuals of both increments
  std::vector<Vector> normal, friction;  ///< per increment
};

Forces run(SiconosMethod method, const RandomProblem& random) {
  SiconosContacts siconos(random.problem);
  ContactState state = ContactState::unstressed(random.problem);
  Forces forces{.converged = true, .right = true, .normal = {}, .friction = {}};
  for (const ContactLoading* loading : {&random.first, &random.second}) {
    const Vector previous_x = state.x;
    forces.converged = siconos.solve(method, *loading, previous_x, state) && forces.converged;
    // Iterative methods stop at 1e-7 N, which corresponds to a few picometres.
    forces.right = forces.right &&
                   contact_residuals(random.problem, random.problem.K.multiply(state.x), *loading, previous_x, state)
                       .within(1e-7, 1e-11);
    forces.normal.push_back(state.normal_force);
    forces.friction.push_back(state.friction_force);
  }
  return forces;
}

std::string lists(const std::vector<Vector>& values) {
  return fmt::format("[[{:.12g}], [{:.12g}]]", fmt::join(values[0], ","), fmt::join(values[1], ","));
}

/// Results of one method on all problems of one size.
struct Tally {
  int problems{}, converged{}, right{};
};

constexpr std::array methods = {SiconosMethod::lemke, SiconosMethod::gauss_seidel, SiconosMethod::conjugate_gradients,
                                SiconosMethod::enumeration};

/// Runs all problems; prints the tally of each method and the forces of the first method that succeeded.
void study() {
  std::string rows;
  std::map<std::pair<int, SiconosMethod>, Tally> tallies;
  for (int blocks = 1; blocks <= most_blocks; ++blocks) {
    for (const double friction : {0.1, 0.5}) {
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const RandomProblem random = make_random_problem(seed, blocks, block_size, friction);
        bool solved = false;
        for (const SiconosMethod method : methods) {
          if (method == SiconosMethod::enumeration && blocks > blocks_to_enumerate) continue;
          const Forces forces = run(method, random);
          Tally& tally = tallies[{blocks, method}];
          ++tally.problems;
          tally.converged += forces.converged ? 1 : 0;
          tally.right += forces.converged && forces.right ? 1 : 0;
          if (solved || !forces.converged || !forces.right) continue;
          solved = true;
          rows += fmt::format(
              R"({}{{"seed": {}, "blocks": {}, "block_size": {}, "friction": {}, "method": "{}", "normal_N": {}, )"
              R"("friction_N": {}}})",
              rows.empty() ? "" : ",\n", seed, blocks, block_size, friction, name_of(method), lists(forces.normal),
              lists(forces.friction));
        }
      }
    }
  }
  std::string summary;
  for (const auto& [key, tally] : tallies) {
    summary += fmt::format(R"({}{{"contacts": {}, "method": "{}", "problems": {}, "converged": {}, "right": {}}})",
                           summary.empty() ? "" : ",\n", 3 * key.first, name_of(key.second), tally.problems,
                           tally.converged, tally.right);
  }
  std::cout << "{\"methods\": [\n" << summary << "\n],\n\"rows\": [\n" << rows << "\n]}\n";
}

}  // namespace
}  // namespace bumpfoil

int main() {
  bumpfoil::study();
}
