// A user's project that only uses the installed library.
#include <bumpfoil/core/version.hpp>
#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <bumpfoil/experiments/reference_case.hpp>
#include <iostream>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  auto& settings = bearing.settings.get<bumpfoil::CycleSettings>();
  settings.directions = {0.0};
  settings.steps = 10;
  const bumpfoil::CycleResult result = bumpfoil::run_cycles(bearing);
  if (!result.converged()) return 1;
  const double force = result.cycles.front().turning_point->max_force;
  std::cout << "bumpfoil " << bumpfoil::version() << ": " << force << " N\n";
  // Pushed by 2.5 clearances, this bearing resists with several hundred newtons.
  return force > 500.0 && force < 1000.0 ? 0 : 1;
}
