#pragma once

#include <optional>

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// Loading of foils whose top foil is bonded to all crests and whose feet never lift. A plain value.
struct BondedLoading {
  bool feet_slide{true};               ///< without friction; otherwise fixed
  Matrix pressure{};                   ///< P of the film at all nodes
  std::optional<Matrix> crest_lift{};  ///< where the top foil is held over the crests, a row for each line, m; none: it
                                       ///< is not
};

struct BondedAnswer {
  Matrix lift;         ///< displacement of the top foil at all columns, outward, a row for each line, m
  Matrix crest_force;  ///< outward on top foil and crest, which holds them at crest_lift, a row for each line, N
};

/// The linear response of foils of one pad, by the film's own equations: foil_residual(), and K of the bump foils.
BondedAnswer bonded_answer(const FilmBearing& bearing, const BondedLoading& loading);

}  // namespace bumpfoil
