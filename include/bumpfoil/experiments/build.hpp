#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/model/case.hpp"

/// The boundary of cases: they are checked here, and lower modules take designs, gases and settings.
namespace bumpfoil {

/// The foils of the bearing of a case, pressed by its journal without a film.
/// @param commands  that are to run them
/// @throws Error (input) if the case cannot be built, or run by one of them
SharedBearing make_bearing_foils(const Case& input, const std::vector<std::string>& commands = {});

/// The strip of a case between its plate and the base.
/// @throws Error (input) if the case cannot be built, has no strip, or is of the Le Lez (2007) model
SharedBearing make_strip_foils(const Case& input);

/// The solver of a case, made for a contact problem: this is where the method of the source paper comes in
/// (origin/uzawa.hpp).
/// @param modes  linear system of the problem, which the follower shares with its caller
/// @param rates  of the event-driven solver
std::unique_ptr<PathFollower> make_path_follower(const SharedProblem& problem, const SolverSettings& settings,
                                                 const std::shared_ptr<ModeSystem>& modes,
                                                 Rates rates = Rates::by_solves);

/// Takes foils from state to state by the solver of a case.
FoilStepper make_stepper(SharedBearing foils, const SolverSettings& settings = {}, Rates rates = Rates::by_solves);

/// The bearing of a case, in gas.
/// @throws Error (input) if the case cannot be built
BearingModel make_film_bearing(const Case& input, const Gas& gas, const FilmResolution& resolution);

/// The mesh of the case.
FilmResolution resolution_of(const Case& input);

/// What the case says of pressures around the film, asperities, and how its journal is tilted.
/// @param input    that is valid
/// @param ambient  pressure, Pa
FilmSurroundings surroundings_of(const Case& input, double ambient);

/// h below which surfaces count as touching, m: film.h_floor; 0 where asperities carry what a film does not.
double thickness_floor(const Case& input);

/// The bearing in the gas and on the mesh of the case.
BearingModel make_film_bearing(const Case& input);

}  // namespace bumpfoil
