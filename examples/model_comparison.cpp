// One bearing, four models of its bump foil: the truss, the frame with small and with large displacements, and the
// Le Lez (2007) model.
#include <fmt/format.h>
#include <bumpfoil/experiments/cycle/cycle.hpp>
#include <bumpfoil/experiments/reference_case.hpp>
#include <utility>

int main() {
  using bumpfoil::BumpFoilModel;
  bumpfoil::Case bearing = bumpfoil::reference_case();
  bearing.settings.set(bumpfoil::CycleSettings{.directions = {0.0}, .amplitude = {.value = 60e-6}, .steps = 30});
  const auto push = [&bearing](const char* name, BumpFoilModel model, bumpfoil::Geometry geometry) {
    bearing.bump_foil.model = model;
    bearing.bump_foil.geometry = geometry;
    const bumpfoil::Cycle cycle = bumpfoil::run_cycles(bearing).cycles.front();
    if (!cycle.converged()) return false;
    fmt::print("{}: {:.1f} N, loop {:.3f} mJ\n", name, cycle.turning_point->max_force, 1e3 * *cycle.loop_energy);
    return true;
  };
  const bool converged = push("truss", BumpFoilModel::truss, bumpfoil::Geometry::linear) &&
                         push("frame", BumpFoilModel::frame, bumpfoil::Geometry::linear) &&
                         push("frame, large displacements", BumpFoilModel::frame, bumpfoil::Geometry::nonlinear) &&
                         push("Le Lez (2007)", BumpFoilModel::former, bumpfoil::Geometry::linear);
  return converged ? 0 : 3;
}
