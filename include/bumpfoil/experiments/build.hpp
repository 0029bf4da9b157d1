#pragma once

#include <string>
#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/bearing/foils.hpp"
#include "bumpfoil/model/case.hpp"

/// Where cases end: they are checked, and what is below takes designs, gases and settings.
namespace bumpfoil {

/// The foils of the bearing of a case, pressed by its journal.
/// @param commands  that are to run them
/// @throws Error (input) if the case cannot be built, or run by one of them
SharedFoils make_bearing_foils(const Case& input, const std::vector<std::string>& commands = {});

/// The strip of a case between its plate and the base.
/// @throws Error (input) if the case cannot be built, has no strip, or is of the Le Lez (2007) model
SharedFoils make_strip_foils(const Case& input);

/// The bearing of a case, in gas.
/// @throws Error (input) if the case cannot be built
FilmBearing make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution);

/// The bearing in the gas and on the mesh of the case.
FilmBearing make_film_bearing(const Case& input);

}  // namespace bumpfoil
