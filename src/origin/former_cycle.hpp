#pragma once

#include "experiments/cycle/cycle_run.hpp"

namespace bumpfoil {

/// Cycles of the Le Lez (2007) model: one static solve per journal position, recorded like the increments of the
/// present model. Meaning of its records where the models differ:
///
/// - `top_displacement` is that of the missing top foil: the crest follows the journal, -(r_i - height_error_i), where
///   it is in contact; zero elsewhere.
/// - `journal_top` and `top_bump` are the one contact between journal and crest; friction belongs to `top_bump`.
/// - Normal forces below zero are tensions: contacts hold in both senses. Modes distinguish slip from the unstressed
///   state.
/// - Gaps below zero are crests that rise into the journal where its undeformed gap is open, which nothing hinders.
/// - `dissipated_energy` is zero: friction that opposes the total displacement gives its work back. `residuals` as in
///   FormerSolution, first contact and tangent stiffness of a crest alone; both tangents are the same.
/// The case outlives what is returned.
/// @throws Error (input) if the case cannot be built.
CycleRun former_cycle_run(const Case& input);

}  // namespace bumpfoil
