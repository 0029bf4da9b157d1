#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"
#include "bumpfoil/experiments/film/wall_film.hpp"
#include "experiments/equilibrium/running_outcome.hpp"

namespace bumpfoil {

ExperimentInfo film_experiment() {
  return {
      .name = "film",
      .summary = "Compute the gas film over a rigid or elastic bearing surface instead of the foils",
      .examples =
          "  bumpfoil film case.toml -o rigid --set 'equilibrium.speeds=[\"45000 rpm\"]' --set "
          "'equilibrium.positions=[[\"15 um\", \"0 um\"]]'\n"
          "  bumpfoil film case.toml -o winkler --set film.wall=springs --set film.wall_stiffness=\"5 GPa/m\" "
          "--set film.closed=true\n"
          "[equilibrium] lists positions, not loads: one film for each.\n",
      .files = {"summary.json", "film.csv", "result.nc"},
      .advice = running_advice,
      .run = [](const Case& input,
                const ProgressCallback& progress) { return running_outcome(input, run_wall_films(input, progress)); },
      .quantities = meanings_of(all_running_quantities()),
      .small_runs = {{"equilibrium.speeds=[\"45000 rpm\"]", "equilibrium.positions=[[\"15 um\", \"0 um\"]]",
                      "film.columns_per_pitch=4", "film.rows=4"}}};
}

}  // namespace bumpfoil
