#include <bumpfoil/analysis/cycle.hpp>
#include <iostream>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bearing.friction = {.top_bump = 0.1, .bump_sleeve = 0.2};
  const bumpfoil::CycleResult result = bumpfoil::run_cycles(bearing);
  for (const bumpfoil::Cycle& cycle : result.cycles) {
    std::cout << cycle.max_force << " N, loop " << 1e3 * cycle.loop_energy << " mJ\n";
  }
  return result.converged() ? 0 : 3;
}
