#include "fuzz/checked_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/pads.hpp"
#include "experiments/equilibrium/running_outcome.hpp"
#include "support/drawn_bearings.hpp"
#include "support/solved_film.hpp"

namespace bumpfoil {
namespace {

/// Checks every number of a result: known ones must be present.
std::string wrong_numbers(const Dataset& dataset) {
  for (const auto* list : {&dataset.coordinates, &dataset.variables}) {
    for (const Variable& variable : *list) {
      if (!variable.values) continue;
      const std::vector<double> values = variable.values();
      const std::size_t due = dataset.size_of(variable);
      if (!values.empty() && values.size() != due && !dataset.grows(variable)) {
        return fmt::format("{} has {} values in place of {}", variable.meaning.name, values.size(), due);
      }
      for (const double value : values) {
        // Files have what is not finite as absent.
        if (variable.known && !std::isfinite(value)) return fmt::format("{} is not a number", variable.meaning.name);
      }
    }
  }
  return {};
}

/// Energy defect, if the response is straight from event to event.
std::string wrong_energies(const Case& input, const Cycle& cycle) {
  constexpr double tolerated_gap = 1e-13;  // m: a contact counts as closed, and is pressed shut with what it carries
  double force = 0.0;                      // of all contacts together
  for (const InterfaceFields* at : {&cycle.fields.journal_top, &cycle.fields.top_bump, &cycle.fields.bump_sleeve}) {
    if (at->normal_force.size() > 0) force += at->normal_force.rowwise().sum().maxCoeff();
  }
  double largest = 0.0;
  double imbalance = 0.0;
  double dissipated = 0.0;
  if (cycle.increments.empty()) return {};
  for (const Increment& k : cycle.increments) {
    if (!k.converged()) break;
    const double stored = k.elastic_energy - cycle.increments.front().elastic_energy;
    largest = std::max({largest, std::abs(k.work), k.elastic_energy});
    imbalance = std::max(imbalance, std::abs(k.work - stored - k.dissipated_energy));
    if (k.index > 0 && k.dissipated_energy < dissipated - 1e-9 * largest - tolerated_gap * force) {
      return fmt::format("increment {}: friction gives back {:.2g} J of {:.2g} J", k.index,
                         dissipated - k.dissipated_energy, largest);
    }
    if (k.index > 0) dissipated = k.dissipated_energy;
  }
  if (input.solver.chosen() != SolverName::events || imbalance <= 1e-8 * largest + tolerated_gap * force) return {};
  return fmt::format("energies miss each other by {:.2g} J of {:.2g} J", imbalance, largest);
}

std::string wrong_cycle(const Case& input, const Cycle& cycle) {
  for (const Increment& k : cycle.increments) {
    if (!k.converged()) continue;
    for (const double number : {k.force_x, k.force_y, k.elastic_energy, k.dissipated_energy, k.work}) {
      if (!std::isfinite(number)) return fmt::format("increment {} has a number that is none", k.index);
    }
    const ContactResiduals& r = k.residuals;
    if (input.bump_foil.model == BumpFoilModel::former || input.solver.chosen() == SolverName::uzawa) continue;
    if (!r.within(1e-9, 1e-12)) {
      return fmt::format(
          "increment {}: equilibrium {:.2g}, penetration {:.2g} m, slip in stick {:.2g} m, complementarity {:.2g}, "
          "cone {:.2g}",
          k.index, r.equilibrium, r.penetration, r.slip_in_stick, r.complementarity, r.cone);
    }
  }
  return wrong_energies(input, cycle);
}

std::string wrong_outcome(const Case& input, const Outcome& outcome) {
  if (outcome.status == RunStatus::failed && outcome.failures.empty()) return "fails without a word";
  if (outcome.status == RunStatus::complete && !outcome.failures.empty()) return "is complete with failures";
  if (outcome.cycles) {
    if (outcome.status == RunStatus::complete && !outcome.cycles->converged()) return "is complete and not converged";
    for (const Cycle& cycle : outcome.cycles->cycles) {
      if (std::string wrong = wrong_cycle(input, cycle); !wrong.empty()) return wrong;
    }
  }
  if (outcome.table && outcome.table().find("nan") != std::string::npos) return "shows nan";
  return outcome.dataset ? wrong_numbers(outcome.dataset()) : "";
}

/// Checks both solvers on a push by solver-independent balances.
std::string wrong_push(const Case& input) {
  if (input.settings.get<CycleSettings>().amplitude.control == Control::load ||
      input.settings.get<CycleSettings>().preload || input.settings.get<CycleSettings>().swing ||
      input.bump_foil.model == BumpFoilModel::former || input.bump_foil.geometry == Geometry::nonlinear ||
      total_bumps(input) > 60) {
    return {};
  }
  const BearingVerdict verdict = check_bearing(input, false);
  if (!verdict.newton.wrong.empty()) return "newton: " + verdict.newton.wrong;
  if (!verdict.events.wrong.empty()) return "events: " + verdict.events.wrong;
  return {};
}

std::string wrong_states(const EquilibriumResult& result) {
  for (const RunningState& state : result.states) {
    if (!state.found()) continue;
    if (std::string wrong = wrong_film(*result.bearing, *state.last); !wrong.empty()) return wrong;
    if (state.last->clearance_offset != 0.0) return "is found with its clearance open";
    const Eigen::Vector2d force = state.outcome->force;
    if (state.requested.by_load() && (force - state.requested.journal).norm() > 1e-6 * state.requested.journal.norm()) {
      return fmt::format("carries ({:.6g}, {:.6g}) N in place of ({:.6g}, {:.6g}) N", force.x(), force.y(),
                         state.requested.journal.x(), state.requested.journal.y());
    }
    const FilmFlows& flows = state.outcome->flows;
    const double largest = std::max({std::abs(flows.start), std::abs(flows.end), std::abs(flows.sides)});
    if (std::abs(flows.start - flows.end - flows.sides) > 1e-6 * largest) {
      return fmt::format("loses mass: {:.3g} in, {:.3g} out, {:.3g} at the sides", flows.start, flows.end, flows.sides);
    }
  }
  return {};
}

}  // namespace

Verdict check_case(const DrawnCase& drawn, double budget) {
  Verdict verdict;
  Case input;
  try {
    input = parse_case(drawn.text, "drawn.toml", {.overrides = {}, .commands = {drawn.command}});
  } catch (const Error&) {
    return verdict;
  }
  const std::clock_t begin = std::clock();
  const auto progress = [&](double fraction) {
    if (!(fraction >= 0.0 && fraction <= 1.0 + 1e-9)) verdict.wrong = fmt::format("progress of {}", fraction);
    return static_cast<double>(std::clock() - begin) < budget * CLOCKS_PER_SEC;
  };
  Outcome outcome;
  if (drawn.command == "equilibrium") {
    EquilibriumResult result = run_equilibrium(input, {}, progress);
    if (verdict.wrong.empty()) verdict.wrong = wrong_states(result);
    outcome = running_outcome(input, std::move(result));
  } else {
    outcome = experiment_named(drawn.command).run(input, progress);
  }
  verdict.end = outcome.status == RunStatus::complete ? Verdict::End::solved
                : outcome.status == RunStatus::failed ? Verdict::End::failed
                                                      : Verdict::End::interrupted;
  if (verdict.wrong.empty()) verdict.wrong = wrong_outcome(input, outcome);
  if (verdict.wrong.empty() && drawn.command == "cycle") verdict.wrong = wrong_push(input);
  return verdict;
}

}  // namespace bumpfoil
