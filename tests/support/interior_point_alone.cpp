#include "support/interior_point_alone.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"

namespace bumpfoil {

InteriorPointRun run_interior_point_alone(const Case& input, int increments) {
  const BearingModel foils = *make_bearing_foils(input);
  NewtonSolver solver(foils.problem, {.max_mode_updates = 0, .max_events = 0});
  ContactState previous = ContactState::unstressed(foils.problem);
  ContactState state;
  const double phi = input.settings.get<CycleSettings>().directions.front();
  InteriorPointRun run;
  for (int k = 0; k <= 2 * increments; ++k) {
    const double displacement =
        input.settings.get<CycleSettings>().amplitude.value * (k <= increments ? k : 2 * increments - k) / increments;
    const ContactLoading loading =
        loading_under(foils, {.position = {displacement * std::cos(phi), displacement * std::sin(phi)}});
    const SolveReport report = solver.solve(loading, previous, state);
    const Vector elastic_force = foils.problem.K.multiply(state.x);
    if (!report.converged() || !contact_residuals(foils.problem, elastic_force, loading, previous.x, state).within()) {
      run.failure = fmt::format("{}, increment {} of {}", input.title, k, 2 * increments);
      return run;
    }
    ++run.increments;
    run.steps += report.cost.outer_iterations;
    std::swap(previous, state);
  }
  return run;
}

}  // namespace bumpfoil
