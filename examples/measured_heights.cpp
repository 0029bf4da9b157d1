// A bearing with measured bump heights, compared with the nominal one. Run it in this folder.
#include <fmt/format.h>
#include <bumpfoil/case/case_reader.hpp>
#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <bumpfoil/experiments/reference_case.hpp>

int main() {
  const auto push = [](const char* name, bumpfoil::Case bearing) {
    auto& settings = bearing.settings.get<bumpfoil::CycleSettings>();
    settings.directions = {0.0};
    settings.steps = 50;
    const bumpfoil::Cycle cycle = bumpfoil::run_cycles(bearing).cycles.front();
    if (!cycle.converged()) return false;
    fmt::print("{}: {:.1f} N, first contact {:.1f} um\n", name, cycle.turning_point->max_force,
               1e6 * *cycle.first_contact);
    return true;
  };
  const bool converged =
      push("as drawn", bumpfoil::reference_case()) && push("as measured", bumpfoil::read_case("measured.toml"));
  return converged ? 0 : 3;
}
