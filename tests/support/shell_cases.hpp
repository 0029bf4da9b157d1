#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/structure/bump_sheet.hpp"

namespace bumpfoil {

/// Quantities compared with shell models: rows of tests/data/fe/shells.json, described in
/// tests/verification/fe/shells.py. Empty if a case lacks them.
struct ShellNumbers {
  Matrix crest_w;  ///< radial displacement of the top foil over the crests, one column per shell_zeta(), m
  Matrix span_w;   ///< the same in the middle of spans
  Vector moments;  ///< on each crest about the mid-plane, N m
};

/// A case computed with shell elements.
struct FeShells {
  std::string name;  ///< held crests, nine bumps, tilt
  std::string feet;  ///< sliding, stuck; "none" under held crests
  int refined{};     ///< of the mesh: 1, coarse, or 2
  ShellNumbers found;
};

/// All cases of the file, on both meshes.
const std::vector<FeShells>& fe_shells();

/// Positions over the half width at which displacements are compared.
const std::vector<double>& shell_zeta();

/// A top foil bonded to the bumps of the reference bearing, or to as many, under a lobe of 1 bar, cos along the foil
/// and 1 - zeta^2 over the width. A plain value.
struct PressedBumps {
  int bumps{};
  double middle{};  ///< of the lobe, from the weld, rad
  double extent{};  ///< rad
  bool feet_slide{};
  SheetModel sheet{};
};

/// Results of the program at crests and all spans between them: a frame for the bump foil, the foils on a film's mesh.
/// @param modes  of the displacement over the width (width.modes)
ShellNumbers press_bumps(const PressedBumps& pressed, int modes);

/// Results of the program for a case of the file.
ShellNumbers shells_by_program(const std::string& name, const std::string& feet, int modes, SheetModel sheet = {});

}  // namespace bumpfoil
