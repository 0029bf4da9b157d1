#pragma once

#include <string_view>

namespace bumpfoil {

/// Whether reports show the results of the command of this name.
bool is_shown(std::string_view command);

/// Whether these are cycles, increment by increment.
bool has_cycles(std::string_view command);

/// Whether these are numbers of many samples, of which distributions are shown; of all other commands they are numbers
/// over some dimensions.
bool has_distributions(std::string_view command);

/// Whether these are states of a running bearing, of which single bumps and feet are drawn.
bool has_states(std::string_view command);

/// Whether these are free motions of a rotor over speed, with the onsets of its whirl in the summary.
bool has_onsets(std::string_view command);

/// Whether these are revolutions of a rotor in time, with its rubs and the balance of its energy in the summary.
bool has_revolutions(std::string_view command);

/// Whether these are parameters of a case with what they were found from, in the summary as well.
bool has_parameters(std::string_view command);

/// Whether these are points that were evaluated to choose keys of a case, with the best in the summary as well.
bool has_points(std::string_view command);

/// Whether these are responses of a rotor to unbalance over speed, with their peaks in the summary.
bool has_peaks(std::string_view command);

}  // namespace bumpfoil
