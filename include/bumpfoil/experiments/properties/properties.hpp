#pragma once

#include <optional>
#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/identification.hpp"

namespace bumpfoil {

/// Smallest and largest eigenvalue of a stiffness matrix, N/m.
struct StiffnessRange {
  double softest{};
  double stiffest{};
};

/// What is known of bumps of one shape that follow each other.
struct BumpProperties {
  int from{};  ///< from 1
  int to{};
  BumpShape shape;
  BumpArc arc;
  BumpCell cell;              ///< of the symmetric frame
  TrussConstants identified;  ///< from the frame of a row of such bumps

  // One isolated bump loaded at its crest, N/m; see structure/single_bump.hpp.
  double shallow_bump{};                 ///< limit for shallow bumps
  std::optional<double> sliding_bump;    ///< feet slide without friction
  double guided_bump{};                  ///< rotation of the feet clamped
  std::optional<double> loading_bump;    ///< feet slide with the friction of the case; absent where it locks them
  std::optional<double> unloading_bump;  ///< the same while the load falls
};

/// Bump foil of one strip whose bumps have dimensions of their own.
struct StripProperties {
  int strip{};     ///< from 1, from the side z < 0 on
  double width{};  ///< m; stiffnesses are of this width
  std::vector<BumpProperties> bumps;
  std::optional<StiffnessRange> bump_foil;
};

/// What is known of the foils before any contact is solved.
struct Properties {
  std::vector<BumpProperties> bumps;  ///< from the weld on; one where all bumps are alike
  std::optional<StiffnessRange>
      top_foil;                         ///< K_t; absent without a top foil, without a bearing, or with too many bumps
  std::optional<PadAssembly> assembly;  ///< absent unless the top foil is formed otherwise than the bearing
  std::optional<StiffnessRange> bump_foil;  ///< K_b without contacts; absent with too many bumps, and without a truss
  std::vector<StripProperties> strips;      ///< those with bumps of their own; all else is of the foil in common
};

/// Of foils that are valid; where their truss cannot be built, the rest is known all the same.
Properties compute_properties(const PadDesign& pad);

/// Of the foils of a case. @throws Error (input) if the case is wrong
Properties compute_properties(const Case& input);

}  // namespace bumpfoil
