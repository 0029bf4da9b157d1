#pragma once

#include <Eigen/Core>
#include <optional>

#include "bumpfoil/contact/problem.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "bumpfoil/structure/stress.hpp"

namespace bumpfoil {

/// Foils ready to be loaded: elastic foils and the contacts between what presses on them (the journal of a bearing, the
/// plate of a strip), the foils, and what carries them (sleeve, base). A plain value.
///
/// What presses stands at a position in the X-Y plane: a displacement d moves it by d.n towards the foils over a bump
/// with the normal n. The plate of a strip moves along X, and all its normals are (1, 0).
///
/// Contacts of the block of a bump, in this order: journal/top foil, top foil/crest, then one per foot with the sleeve.
/// Without a top foil the first is missing, and the second is that of the plate with the crest.
struct FoilModel {
  FoilStructure structure;
  StressModel stress;
  ContactProblem problem;
  double clearance{};        ///< gap between what presses, at the origin, and the undeformed foils, m
  Eigen::Matrix2Xd normals;  ///< unit vectors in the X-Y plane that point outward at each crest
  Vector assembled_gap;      ///< g0 of each contact without what presses, m: height errors and sleeve gaps

  [[nodiscard]] bool has_top_foil() const { return structure.dofs.top_u >= 0; }
  [[nodiscard]] int top_bump() const {
    return has_top_foil() ? 1 : 0;
  }  ///< place of the contact in the block of a bump
  [[nodiscard]] int first_foot() const { return top_bump() + 1; }
  [[nodiscard]] int contacts_per_block() const { return static_cast<int>(problem.pairs.size()); }
  [[nodiscard]] int bumps() const { return structure.bumps(); }
  [[nodiscard]] int feet_per_block() const { return structure.dofs.feet(); }
  /// Contacts of the pressing body, the first of each bump: entries of a vector of all contacts.
  [[nodiscard]] auto pressed() const {
    return Eigen::seqN(Eigen::Index{structure.first_bump} * contacts_per_block(), Eigen::Index{bumps()},
                       Eigen::Index{contacts_per_block()});
  }
};

/// The law that a contact problem of the foils needs: absent where K says all.
std::optional<ElasticLaw> elastic_law(const FoilStructure& structure);

/// The foils of a bearing, pressed by its journal.
/// @throws Error (input) if the case cannot be built.
FoilModel make_bearing_model(const Case& input);

/// The strip of a case between its plate and the base: flat foils, without clearance.
/// @throws Error (input) if the case cannot be built, or has no strip, or is of the former model.
FoilModel make_strip_model(const Case& input);

/// Gaps and loads with the pressing body at `position` (m):
///
///     g_r = r_i + u_t,   g_t = -height_error_i - u_t + v_crest,   g_b = sleeve_gap_i - v_foot
///
/// [Arghir2019, Eqs. 1-4]; without a top foil r_i - height_error_i + v_crest in place of the first two.
ContactLoading loading_at(const FoilModel& model, const Eigen::Vector2d& position);

/// Rate of loading_at per metre of displacement along the unit vector `direction`.
ContactLoading loading_rate(const FoilModel& model, const Eigen::Vector2d& direction);

/// Loads of the pressing body on the foils, N, one per bump.
Vector pressing_loads(const FoilModel& model, const Vector& normal_force);

/// Force that holds the pressing body, N.
Eigen::Vector2d holding_force(const FoilModel& model, const Vector& normal_force);

}  // namespace bumpfoil
