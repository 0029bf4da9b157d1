#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <bumpfoil/experiments/reference_case.hpp>
#include <iostream>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bearing.friction = {.top_bump = 0.1, .bump_sleeve = 0.2};
  const bumpfoil::CycleResult result = bumpfoil::run_cycles(bearing);
  for (const bumpfoil::Cycle& cycle : result.cycles) {
    if (!cycle.converged()) return 3;
    std::cout << cycle.turning_point->max_force << " N, loop " << 1e3 * *cycle.loop_energy << " mJ\n";
  }
}
