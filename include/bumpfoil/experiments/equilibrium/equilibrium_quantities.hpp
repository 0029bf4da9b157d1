#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/results/quantity.hpp"

/// Every quantity of a state of a running bearing, described once: equilibrium.csv, result.nc, summary.json and the
/// table on the terminal take it from here.
namespace bumpfoil {

/// Of running_statuses.
inline constexpr auto running_status_words = [] {
  std::array<std::string_view, running_statuses.size()> words;
  std::transform(running_statuses.begin(), running_statuses.end(), words.begin(), name_of<Status>);
  return words;
}();
/// As files number and spell how the search for a state ended.
inline constexpr Form running_status{Form::flag, running_status_words};

namespace tag {

inline constexpr Tags of_foils = first_of_experiment;  ///< not of walls in their place
inline constexpr Tags of_pads = 2 * of_foils;          ///< of several alone
inline constexpr Tags of_limits = 2 * of_pads;         ///< known where limits were requested
inline constexpr Tags is_bump = 2 * of_limits;         ///< the number of one, through all pads
/// Known of states that were not found, too: what was requested, and how that ended.
inline constexpr Tags requested = 2 * is_bump;
inline constexpr Tags demand = 2 * requested;          ///< speed and load that were requested
inline constexpr Tags of_asperities = 2 * demand;      ///< not of smooth surfaces
inline constexpr Tags of_width = 2 * of_asperities;    ///< not of films that are uniform over the width
inline constexpr Tags of_uniform_film = 2 * of_width;  ///< of those alone
inline constexpr Tags of_tilt = 2 * of_uniform_film;   ///< where the journal may tilt
inline constexpr Tags of_slope = 2 * of_tilt;          ///< of foils whose displacement may be linear over the width
inline constexpr Tags of_parabola = 2 * of_slope;      ///< ... a parabola
inline constexpr Tags of_slits = 2 * of_parabola;      ///< of split top foils

}  // namespace tag

/// Of one state.
using RunningQuantity = Quantity<double (*)(const BearingModel&, const RunningState&)>;

/// In the order of files and tables: of a bearing with foils, of one pad or several, or of one with a wall in their
/// place.
/// @param limits  whether these were requested
std::vector<RunningQuantity> running_quantities(const BearingModel& bearing, bool limits = false);

/// Of bearings of all kinds.
std::span<const RunningQuantity> all_running_quantities();

/// The value in files: not a number for a state that was not found, unless the quantity was `requested`.
double value_of(const RunningQuantity& quantity, const BearingModel& bearing, const RunningState& state);

/// Of every column of the mesh at one state.
using ColumnQuantity = Quantity<Vector (*)(const BearingModel&, const BearingState&)>;
std::span<const ColumnQuantity> column_quantities();

/// Whether the displacement of the foils has the mode P_k over the width.
bool has_mode(const BearingModel& bearing, int k);

/// p at all nodes, Pa: rows from the mid-plane or a side to the side, columns from the weld to the free end, pad after
/// pad.
Matrix film_pressure(const BearingModel& bearing, const BearingState& state);

/// A bump (from 0, through all pads) as tables call it: "3"; of several pads "2.3", the third of pad 2.
std::string running_bump_text(const BearingModel& bearing, int bump);

/// Where the top foil moves most in a motion with the journal held.
struct HeldPlace {
  std::size_t pad{};  ///< from 0
  double theta{};     ///< from the weld along the foil, rad
};
HeldPlace held_place(const BearingModel& bearing, const HeldMotion& motion);

/// Detached bumps at the inlet: bumps in a row, from where gas enters, that the top foil does not load. With several
/// pads, on that where they are most; 0 for a state that was not found, and where no bump is loaded at all.
int lifted_bumps_at_entry(const BearingModel& bearing, const RunningState& state);

/// The operating point as messages call it: "45000 rpm, load (50, 0) N"; without a speed that is not a number.
std::string name_of_point(const OperatingPoint& point);

/// A state as messages call it, by where it was reached from: "load_ramp from rest, 45000 rpm, load (20, 0) N", or
/// "load_ramp from load (20, 0) N, 45000 rpm, load (50, 0) N".
std::string name_of_state(const RunningState& state);

/// A limit as messages call it: "lift-off speed under the load (50, 0) N".
std::string name_of_limit(const FilmLimit& limit);

/// A speed or a load of a limit as messages show it: "11241 rpm", "115.32 N".
std::string shown_limit_value(const FilmLimit& limit, double value);

/// FilmLimit::unstable as messages show it: "50 N to 115.32 N and 140 N"; empty without any.
std::string unstable_ranges_text(const FilmLimit& limit);

/// Why a state was not found, and where the last one is; empty for one that was.
std::string running_failure(const BearingModel& bearing, const RunningState& state);

}  // namespace bumpfoil
