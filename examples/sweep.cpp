// The effect of friction: push tests with coefficients from 0 to 0.5. `bumpfoil sweep` does the same on all cores.
#include <fmt/format.h>
#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <bumpfoil/experiments/reference_case.hpp>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  auto& settings = bearing.settings.get<bumpfoil::CycleSettings>();
  settings.directions = {0.0};
  settings.steps = 50;
  for (const double coefficient : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    bearing.friction = {.top_bump = coefficient, .bump_sleeve = coefficient};
    const bumpfoil::Cycle push = bumpfoil::run_cycles(bearing).cycles.front();
    if (!push.converged()) return 3;
    fmt::print("{:g}: {:.4g} MN/m, loss factor {:.4g}\n", coefficient, *push.loaded_stiffness / 1e6, *push.loss_factor);
  }
}
