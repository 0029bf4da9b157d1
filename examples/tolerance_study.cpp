// A hundred bearings whose bump heights scatter by 10 um: scatter of force and clearance. `bumpfoil montecarlo` does
// the same on all cores, also for a million of them.
#include <fmt/format.h>
#include <bumpfoil/ensemble/sample.hpp>
#include <bumpfoil/ensemble/statistics.hpp>
#include <bumpfoil/experiments/cycle/sampled_cycles.hpp>
#include <bumpfoil/experiments/reference_case.hpp>

int main() {
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bearing.solver.name = bumpfoil::SolverName::events;
  auto& settings = bearing.settings.get<bumpfoil::CycleSettings>();
  settings.directions = {0.0};
  settings.steps = 50;
  bearing.montecarlo.emplace().bump_height.emplace().distribution.sigma = 10e-6;  // m, of a normal distribution

  std::vector<double> forces, clearances;
  for (std::uint64_t number = 0; number < 100; ++number) {
    const bumpfoil::Sample sample = bumpfoil::draw_sample(bearing, number);
    const auto run = bumpfoil::run_sampled_cycles(bumpfoil::sampled_case(bearing, sample));
    if (!run || !run->converged()) return 3;
    const bumpfoil::Cycle& push = run->cycles.front();
    forces.push_back(push.turning_point->max_force);
    clearances.push_back(1e6 * *push.clearances[1].displacement);
  }
  const bumpfoil::Cycle nominal = bumpfoil::run_cycles(bearing).cycles.front();

  const auto print = [](const char* words, const char* unit, double perfect, const std::vector<double>& values) {
    const bumpfoil::Statistics found = bumpfoil::statistics_of(values);
    fmt::print("{}: {:.4g} {} without scatter; mean {:.4g}, std {:.3g} {}\n", words, perfect, unit, found.mean,
               found.deviation, unit);
  };
  print("maximum force", "N", nominal.turning_point->max_force, forces);
  print("clearance at 10 N", "µm", 1e6 * *nominal.clearances[1].displacement, clearances);
}
