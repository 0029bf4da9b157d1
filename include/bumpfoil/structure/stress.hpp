#pragma once

#include <optional>

#include "bumpfoil/structure/forming.hpp"
#include "bumpfoil/structure/frame.hpp"
#include "bumpfoil/structure/top_foil.hpp"

namespace bumpfoil {

/// Bending stress at the surfaces of the foils, |M| / W, Pa. Quantities that a model does not have are empty or absent:
/// the bump foil of the truss, the top foil of the Le Lez (2007) model.
struct FoilStress {
  Vector top_crest;                ///< top foil over each crest
  std::optional<double> top_weld;  ///< where the top foil is clamped
  Vector bump_crest;               ///< bump foil at each crest
  Vector bump_foot;                ///< at each foot, in the order of the results
  Vector bump_largest;             ///< anywhere along the two arcs of each bump
  std::optional<double> bump_weld;
};

/// Data to compute the stress from the unknowns of a foil structure. A plain value.
struct StressModel {
  BumpDofs dofs;
  int first_bump{};  ///< block of bump 1
  std::optional<FrameModel> bump_foil;
  std::optional<TopFoilMoments> top_foil;
  double moment_scale{};         ///< see top_moment_scale(), N: the moments of the top foil are the unknowns times this
  double top_section_modulus{};  ///< W of the top foil, m^3
  double weld_rotation{};        ///< of its forming, see forming_rotations(), rad
};

StressModel make_stress_model(const FoilDesign& foils);

/// Moments of the top foil as the unknowns hold them; over the crests, where they are largest in magnitude but for a
/// part of 1 / cos(d/2) - 1 between two crests that are d apart.
/// @param x  unknowns of the structure of the same foils
FoilStress foil_stress(const StressModel& model, const Vector& x);

}  // namespace bumpfoil
