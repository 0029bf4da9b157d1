#pragma once

#include <string_view>

namespace bumpfoil {

/// Whether a command of this name writes results: an experiment, a sweep or an ensemble.
bool is_known(std::string_view command);

/// Whether the results are cycles, increment by increment.
bool has_cycles(std::string_view command);

/// Whether the results are numbers of many samples, shown as distributions; those of all other commands are numbers
/// over some dimensions.
bool has_distributions(std::string_view command);

/// Whether the results are of a grid of cases, with its keys in the summary.
bool has_axes(std::string_view command);

/// Whether the results are states of a running bearing, with drawings of single bumps and feet.
bool has_states(std::string_view command);

/// Whether the results are free motions of a rotor over speed, with the onsets of whirl in the summary.
bool has_onsets(std::string_view command);

/// Whether the results are revolutions of a rotor in time, with rubs and the energy balance in the summary.
bool has_revolutions(std::string_view command);

/// Whether the results are fitted parameters of a case with the data, also in the summary.
bool has_parameters(std::string_view command);

/// Whether the results are evaluated points of an optimisation, with the best also in the summary.
bool has_points(std::string_view command);

/// Whether the results are unbalance responses of a rotor over speed, with their peaks in the summary.
bool has_peaks(std::string_view command);

}  // namespace bumpfoil
