// A user's project that only uses the installed library.
#include <bumpfoil/core/version.hpp>
#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <iostream>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bearing.cycle.directions = {0.0};
  bearing.cycle.steps = 10;
  const bumpfoil::CycleResult result = bumpfoil::run_cycles(bearing);
  if (!result.converged()) return 1;
  const double force = result.cycles.front().turning_point->max_force;
  std::cout << "bumpfoil " << bumpfoil::version() << ": " << force << " N\n";
  // Pushed by 2.5 clearances, this bearing resists with several hundred newtons.
  return force > 500.0 && force < 1000.0 ? 0 : 1;
}
