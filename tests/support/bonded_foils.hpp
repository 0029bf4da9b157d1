#pragma once

#include <optional>

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// Loading of foils whose top foil is bonded to all crests and whose feet never lift. A plain value.
struct BondedLoading {
  bool feet_slide{true};               ///< without friction; otherwise fixed
  Matrix pressure{};                   ///< P of the film at all nodes
  std::optional<Matrix> crest_lift{};  ///< prescribed over the crests, a row per line, m; none: free
};

struct BondedAnswer {
  Matrix deflection;   ///< displacement of the top foil at all columns, outward, a row per line, m
  Matrix crest_force;  ///< outward, on top foil and crests to hold crest_lift, a row per line, N
};

/// The linear response of foils of one pad, by the film's own equations: foil_residual(), and K of the bump foils.
BondedAnswer bonded_answer(const BearingModel& bearing, const BondedLoading& loading);

}  // namespace bumpfoil
