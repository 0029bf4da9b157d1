#pragma once

#include <Eigen/Core>
#include <optional>

#include "bumpfoil/contact/problem.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "bumpfoil/structure/stress.hpp"

namespace bumpfoil {

/// A bearing ready to be loaded: elastic foils and the contacts between journal, foils and sleeve. A plain value.
///
/// Contacts of the block of a bump, in this order: journal/top foil, top foil/crest, then one per foot with the sleeve.
struct BearingModel {
  Bearing bearing;
  FoilStructure structure;
  StressModel stress;
  ContactProblem problem;
  Vector phi;            ///< polar angles of the crests, rad
  Vector assembled_gap;  ///< g0 of each contact without the journal's part, m: height errors and sleeve gaps

  static constexpr int journal_top = 0;  ///< place of the contact in the block of a bump
  static constexpr int top_bump = 1;
  static constexpr int first_foot = 2;

  [[nodiscard]] int bumps() const { return structure.bumps(); }
  [[nodiscard]] int feet_per_bump() const { return structure.dofs.feet(); }
};

/// The law that a contact problem of the foils needs: absent where K says all.
std::optional<ElasticLaw> elastic_law(const FoilStructure& structure);

/// @throws Error (input) if the case cannot be built.
BearingModel make_bearing_model(const Case& input);

/// Gaps and loads with the journal centre at `position` (m):
///
///     g_r = r_i + u_t,   g_t = -height_error_i - u_t + v_crest,   g_b = sleeve_gap_i - v_foot
///
/// [Arghir2019, Eqs. 1-4].
ContactLoading loading_at(const BearingModel& model, const Eigen::Vector2d& position);

/// Rate of loading_at per metre of journal displacement along the unit vector `direction`.
ContactLoading loading_rate(const BearingModel& model, const Eigen::Vector2d& direction);

/// Loads of the journal on the top foil, N, one per bump.
Vector journal_loads(const BearingModel& model, const Vector& normal_force);

}  // namespace bumpfoil
