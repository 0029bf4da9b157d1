#include "bumpfoil/io/cycle_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

#include "bumpfoil/io/summary.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view header =
    "direction_deg,increment,branch,displacement_m,x_m,y_m,force_x_N,force_y_N,force_direct_N,force_cross_N,"
    "elastic_energy_J,dissipated_energy_J,work_J,residual,iterations,substeps\n";

}  // namespace

std::string cycle_csv(const CycleResult& result) {
  std::string out(header);
  const auto append = [&out](double number) {
    if (std::isfinite(number)) fmt::format_to(std::back_inserter(out), "{:.17g}", number);
    out += ',';
  };
  for (const Cycle& cycle : result.cycles) {
    for (const Increment& increment : cycle.increments) {
      append(to_degrees(cycle.direction));
      fmt::format_to(std::back_inserter(out), "{},{},", increment.index,
                     increment.branch == Branch::loading ? "loading" : "unloading");
      for (const double number :
           std::array{increment.displacement, increment.x, increment.y, increment.force_x, increment.force_y,
                      increment.force_direct, increment.force_cross, increment.elastic_energy,
                      increment.dissipated_energy, increment.work, increment.residuals.equilibrium}) {
        append(number);
      }
      fmt::format_to(std::back_inserter(out), "{},{}\n", increment.solve.iterations, increment.substeps);
    }
  }
  return out;
}

}  // namespace bumpfoil
