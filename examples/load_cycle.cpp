// A downward load of 400 N is applied to the journal and removed. The journal is free to move sideways.
#include <fmt/format.h>
#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <bumpfoil/experiments/reference_case.hpp>
#include <numbers>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bearing.settings.set(bumpfoil::CycleSettings{.directions = {-0.5 * std::numbers::pi},
                                               .amplitude = {.control = bumpfoil::Control::load, .value = 400.0},
                                               .steps = 50});
  const bumpfoil::Cycle cycle = bumpfoil::run_cycles(bearing).cycles.front();
  if (!cycle.converged()) return 3;

  for (std::size_t increment = 0; increment < cycle.increments.size(); increment += 25) {
    const bumpfoil::Increment& at = cycle.increments[increment];
    fmt::print("{:.1f} N: {:.3f} um, {:.3f} um\n", at.force_direct, 1e6 * at.x, 1e6 * at.y);
  }
  fmt::print("loop {:.4g} mJ, loss factor {:.4g}\n", 1e3 * *cycle.loop_energy, *cycle.loss_factor);
}
