#pragma once

#include <memory>
#include <optional>

#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/contact/solver.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/structure/foil_structure.hpp"

namespace bumpfoil {

class ModeSystem;
class PenaltySystem;

/// The Le Lez (2007) model of the bearing [LeLez2007], with which [Arghir2019] compares: the truss alone, without top
/// foil and without gaps that open. A plain value.
///
/// Contacts of the block of a bump: crest with journal, foot with sleeve. Both hold in both senses: a normal force may
/// be a tension.
struct FormerModel {
  Bearing bearing;
  FoilStructure structure;  ///< truss, four unknowns per bump
  ContactProblem problem;
  Eigen::Matrix2Xd normals;  ///< unit vectors in the X-Y plane that point outward at each crest
  Vector height_errors;      ///< m, one per bump, positive = taller
  Vector sleeve_gaps;        ///< m, one per bump

  static constexpr int crest = 0;  ///< place of the contact in the block of a bump
  static constexpr int foot = 1;

  [[nodiscard]] int bumps() const { return structure.bumps(); }
};

/// @throws Error (input) if the case cannot be built.
FormerModel make_former_model(const Case& input);

/// Gaps between journal and undeformed crests, r_i - height_error_i, m, one per bump.
Vector former_crest_gaps(const FormerModel& model, const Eigen::Vector2d& position);

/// Checks a state at a journal position with contact_residuals for |N|, and equilibrium for N itself. Crests that the
/// journal does not reach are not checked for penetration, which the model does not have.
ContactResiduals former_residuals(const FormerModel& model, const Eigen::Vector2d& position, const ContactState& state);

/// Result of one journal position.
struct FormerSolution {
  ContactState state;  ///< normal forces below zero are tensions; `open` are crests that the journal does not reach
  ContactResiduals residuals;  ///< former_residuals
  SolveReport report;
};

/// Solves the static problem of one journal position from the unstressed foil, whatever was before: loading and
/// unloading are one curve. With x = 0 the unstressed state,
///
///     K x = contact forces,
///     v_crest = -(r_i - height_error_i) where that gap is negative, crest free elsewhere;   v_foot = sleeve_gap_i
///     |t| <= f |N|,   t = -f |N| sign(u) where u is not zero
///
/// by exact solves for assumed modes and signs of N, changing violated ones; if that cycles, an augmented Lagrangian
/// with friction bounds held (Tresca) and updated leads the exact solves, which decide.
///
/// `residuals` are those of contact_residuals for |N|, with equilibrium for N itself; crests that the journal does not
/// reach are not checked for penetration, which the model does not have. A converged solution is
/// ContactResiduals::within its default bounds.
class FormerSolver {
 public:
  explicit FormerSolver(const FormerModel& model);
  ~FormerSolver();

  [[nodiscard]] FormerSolution solve(const Eigen::Vector2d& position);

  /// d(F.n)/ds along the unit vector n for the contact modes of `state`, N/m: the same for loading and unloading.
  /// @return absent where the contacts leave a mechanism
  [[nodiscard]] std::optional<double> tangent_stiffness(const ContactState& state, const Eigen::Vector2d& direction);

 private:
  struct TrescaState;

  bool iterate_modes(const ContactLoading& loading, int rounds, FormerSolution& solution);
  bool approach(const ContactLoading& loading, FormerSolution& solution);
  bool minimise(const ContactLoading& loading, TrescaState& s, SolveCost& cost);
  void evaluate(const ContactLoading& loading, TrescaState& s);

  FormerModel model_;
  double penalty_;  ///< of the augmented Lagrangian, N/m
  std::unique_ptr<ModeSystem> modes_;
  std::unique_ptr<PenaltySystem> penalties_;
};

/// Applied force on the journal, which balances the crests, N.
Eigen::Vector2d former_journal_force(const FormerModel& model, const ContactState& state);

}  // namespace bumpfoil
