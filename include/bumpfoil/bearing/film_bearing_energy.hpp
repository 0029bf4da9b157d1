#pragma once

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/film/film_energy.hpp"

namespace bumpfoil {

/// What a running bearing holds, J.
struct BearingEnergy {
  double gas{};         ///< free energy over that at ambient pressure, free_energy()
  double foils{};       ///< 1/2 b^T K b of the bump foils and 1/2 M^T T M of the top foils, forming included, and of
                        ///< their membranes
  double asperities{};  ///< int p_c dh from the thickness to infinity, where they touch

  [[nodiscard]] double total() const { return gas + foils + asperities; }
};

BearingEnergy bearing_energy(const BearingModel& bearing, const BearingState& state);

/// Powers of the film of a bearing, W, see FilmPowers. With the work of the journal,
///
///     entrained + supplied = dissipated + friction of the foils + d(energy)/dt - F.dx/dt
///
/// where F holds the journal, friction of asperities on it aside.
FilmPowers film_powers(const FilmModel& film, const BearingState& state);

}  // namespace bumpfoil
