#pragma once

#include <string>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// The command that gives such a result: equilibrium or, with a wall in place of foils, film.
std::string_view command_of(const EquilibriumResult& result);

/// How a run ended.
RunStatus status_of(const EquilibriumResult& result);

/// Rows of equilibrium.csv or film.csv: one for each state.
Table state_table(const EquilibriumResult& result);

/// Rows of coefficients.csv: stiffness and damping of every state that was found at each of its frequencies, those of
/// further motion, and with all closed contacts stuck.
Table film_coefficient_table(const EquilibriumResult& result);

/// The states side by side, for the terminal; of states that several paths led to, how far these lie apart.
std::string equilibrium_table(const EquilibriumResult& result);

/// Lines on what was not found, and why.
std::vector<std::string> failure_lines(const EquilibriumResult& result);

/// Lines on what users should know of the states that were found, and the foils' stress above yield.
std::vector<std::string> warning_lines(const Case& input, const EquilibriumResult& result);

/// States that several paths led to at one operating point, by their places in the result.
struct PathSpread {
  std::vector<std::size_t> states{};
};
/// Operating points that more than one path led to.
std::vector<PathSpread> path_spreads(const EquilibriumResult& result);

}  // namespace bumpfoil
