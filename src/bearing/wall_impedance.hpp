#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/bearing/impedance.hpp"
#include "bumpfoil/film/film_solver.hpp"

namespace bumpfoil {

/// Impedance of a film over a rigid bearing surface or an elastic foundation, to motions of the journal by q e^{s t}
/// about a state, see FilmStepper::impedance(). The foundation has neither mass nor damping.
/// @param rates  s, 1/s, at which accuracy is ensured
/// @return nothing if the equations are singular
std::optional<FilmImpedance> wall_impedance(const FilmModel& model, const Foundation& foundation,
                                            const BearingState& state, const std::vector<std::complex<double>>& rates);

}  // namespace bumpfoil
