#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#ifdef BUMPFOIL_PEERS_SICONOS
#include <Eigen/Eigenvalues>

#include "support/siconos_contacts.hpp"
#endif

/// Times solvers on the same problems and prints JSON: the reference bearing (friction 0.1, +X, 100 steps per branch,
/// without set-up) with the solvers of the program, with `newton` on one dense block, with Siconos; and a strip of ten
/// bumps, for comparison with finite elements. Times are processor times of one thread.
namespace bumpfoil {
namespace {

using Loadings = std::vector<ContactLoading>;

/// Median over a number of runs, s.
double processor_time(int runs, const std::function<void()>& work) {
  std::vector<double> times;
  for (int run = 0; run < runs; ++run) {
    const std::clock_t begin = std::clock();
    work();
    times.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// Along X to the amplitude and back.
Loadings loadings_of(const BearingModel& foils, double amplitude, int steps) {
  Loadings loadings;
  for (int k = 0; k <= 2 * steps; ++k) {
    const int from_start = k <= steps ? k : 2 * steps - k;
    loadings.push_back(loading_under(foils, {.position = {amplitude * from_start / steps, 0.0}}));
  }
  return loadings;
}

/// The same problem as one block, without its structure.
ContactProblem as_one_block(const ContactProblem& problem) {
  ContactProblem dense;
  dense.K = BlockTridiagonal(1, static_cast<int>(problem.K.rows()));
  dense.K.diagonal.front() = problem.K.dense();
  for (const ContactSite& site : problem.sites) {
    const int first = site.block * problem.K.block_size();
    const auto moved = [first](int place) { return place < 0 ? place : first + place; };
    dense.sites.push_back({.plus = moved(site.plus),
                           .minus = moved(site.minus),
                           .tangential = moved(site.tangential),
                           .friction_coefficient = site.friction_coefficient});
  }
  return dense;
}

std::string row(const std::string& name, double seconds, const std::string& more) {
  return fmt::format(R"({{"name": "{}", "seconds": {:.6g}{}}})", name, seconds, more);
}

/// One pass along the loadings; `states`, if given, receives the last state of each increment.
std::string time_solver(const std::string& name, const SolverSettings& settings, const ContactProblem& problem,
                        const Loadings& loadings, int runs) {
  const auto solver = make_path_follower(problem, settings, make_mode_system(problem));
  const ContactState unstressed = ContactState::unstressed(problem);
  ContactState state = unstressed;
  std::vector<ContactEvent> events;
  SolveCost total;
  int failures = 0;
  const double seconds = processor_time(runs, [&] {
    total = SolveCost();
    failures = 0;
    const SolveReport assembled = solver->assemble(loadings.front(), unstressed, state);
    failures += assembled.converged() ? 0 : 1;
    total += assembled.cost;
    // Forward and back: two straight paths.
    const std::size_t steps = (loadings.size() - 1) / 2;
    for (std::size_t k = 1; k < loadings.size(); ++k) {
      const std::size_t leg = (k - 1) / steps;
      if (k == leg * steps + 1) solver->set_out({loadings[k - 1], loadings[k - 1 + steps]}, state);
      const double fraction = static_cast<double>(k - leg * steps) / static_cast<double>(steps);
      events.clear();
      const FollowReport report = solver->follow_to(fraction, state, {}, events);
      failures += report.converged() ? 0 : 1;
      total += report.cost;
    }
  });
  return row(
      name, seconds,
      fmt::format(R"(, "increments": {}, "solved": {}, "linear_solves": {}, "factorisations": {})", loadings.size(),
                  static_cast<int>(loadings.size()) - failures, total.iterations, total.factorisations));
}

#ifdef BUMPFOIL_PEERS_SICONOS
/// Sweeps of the iterative methods for one increment; more would take minutes.
constexpr SiconosOptions siconos_options{.max_iterations = 1000};

/// Every increment starts from the exact previous state, so that a failure does not affect later ones.
std::string time_siconos(SiconosMethod method, const ContactProblem& problem, const Loadings& loadings) {
  SiconosContacts siconos(problem);
  NewtonSolver exact(problem);
  ContactState state = ContactState::unstressed(problem);
  ContactState answer = state;
  int claimed = 0;
  int solved = 0;
  int first_failure = -1;
  double worst_penetration = 0.0;
  double seconds = 0.0;
  for (std::size_t k = 0; k < loadings.size(); ++k) {
    const ContactState previous = state;
    bool converged = false;
    seconds +=
        processor_time(1, [&] { converged = siconos.solve(method, loadings[k], previous.x, answer, siconos_options); });
    const ContactResiduals residuals =
        contact_residuals(problem, problem.K.multiply(answer.x), loadings[k], previous.x, answer);
    const bool right = residuals.within(1e-6, 1e-9);
    claimed += converged ? 1 : 0;
    solved += right ? 1 : 0;
    if (!right && first_failure < 0) first_failure = static_cast<int>(k);
    if (converged) worst_penetration = std::max(worst_penetration, residuals.penetration);
    if (!exact.solve(loadings[k], previous, state).converged()) return "";
  }
  const Vector stretches = Eigen::SelfAdjointEigenSolver<Matrix>(siconos.compliance()).eigenvalues();
  return row("siconos " + name_of(method), seconds,
             fmt::format(R"(, "increments": {}, "claimed": {}, "solved": {}, "first_failure": {}, )"
                         R"("worst_penetration_m": {:.3g}, "condition_of_compliance": {:.2g})",
                         loadings.size(), claimed, solved, first_failure, worst_penetration,
                         stretches.maxCoeff() / stretches.cwiseAbs().minCoeff()));
}
#endif

std::string bearing_rows() {
  const Case input = reference_case();
  const BearingModel foils = *make_bearing_foils(input);
  const auto& cycle = input.settings.get<CycleSettings>();
  const Loadings loadings = loadings_of(foils, cycle.amplitude.value, cycle.steps);
  const auto named = [](SolverName name) {
    SolverSettings settings;
    settings.name = name;
    return settings;
  };
  std::string rows = time_solver("newton", named(SolverName::newton), foils.problem, loadings, 21);
  rows += ",\n" + time_solver("events", named(SolverName::events), foils.problem, loadings, 21);
  rows += ",\n" + time_solver("uzawa", named(SolverName::uzawa), foils.problem, loadings, 3);
  const ContactProblem dense = as_one_block(foils.problem);
  rows += ",\n" + time_solver("newton, one dense block", named(SolverName::newton), dense, loadings, 3);
#ifdef BUMPFOIL_PEERS_SICONOS
  for (const SiconosMethod method :
       {SiconosMethod::lemke, SiconosMethod::gauss_seidel, SiconosMethod::conjugate_gradients}) {
    rows += ",\n" + time_siconos(method, foils.problem, loadings);
  }
#endif
  return rows;
}

/// The strip of docs/verification/fe_strip.md: frame, ten bumps, no top foil, pressed by 20 um in 20 steps and
/// released.
std::string strip_rows() {
  constexpr double compression = 20e-6;
  constexpr int steps = 20;
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.height_reference = HeightReference::midsurface;
  input.bump_foil.weld_at = WeldPosition::arc_start;
  input.settings.set(
      StripSettings{.bumps = 10, .top_foil = false, .amplitude = {.value = compression}, .steps = steps});
  const BearingModel foils = *make_strip_foils(input);
  return time_solver("newton", SolverSettings(), foils.problem, loadings_of(foils, compression, steps), 21);
}

}  // namespace
}  // namespace bumpfoil

int main() {
  std::cout << "{\"bearing\": [\n"
            << bumpfoil::bearing_rows() << "\n],\n\"strip\": [\n"
            << bumpfoil::strip_rows() << "\n]}\n";
}
