#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "bumpfoil/bearing/critical_mass.hpp"
#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Response of a state to small motions of the journal at a frequency, from FilmStepper::impedances(), by displacements
/// and slopes (FilmModel::by_slopes()): K = Re Z, C = Im Z / frequency. With sliding contacts still sliding, and with
/// all closed contacts stuck; absent where the system is singular.
struct FilmWhirl {
  double frequency{};  ///< rad/s
  std::optional<JournalMatrixC> impedance, stuck_impedance;
};

/// Estimated error of a state by the mesh of the film, see estimate_mesh_errors().
struct MeshError {
  double minimum_film_thickness{};  ///< m
  double force{};  ///< N: of the force at the position, or of what the position under a load makes of it
};

/// What is varied until the film is as thin as film.h_lift_off.
enum class FilmLimitKind : std::uint8_t {
  lift_off_speed,  ///< the speed, under a load that stays
  load_capacity,   ///< the size of the load, at a speed that stays
};

template <>
inline constexpr auto enum_names<FilmLimitKind> = std::to_array<std::string_view>({"lift_off_speed", "load_capacity"});

/// What is wrong with the states beyond a limit.
enum class LimitBound : std::uint8_t {
  film_thickness,  ///< the minimum film thickness is below film.h_lift_off
  stability,       ///< unstable with the journal held
  end_of_path,     ///< no state was found
};

template <>
inline constexpr auto enum_names<LimitBound> = std::to_array<std::string_view>({"film_thickness", "stability",
                                                                                "end_of_path"});

/// Speeds |Omega|, rad/s, or loads, N, on a path between which all states are unstable with the journal held.
struct UnstableRange {
  double from{}, to{};  ///< the first and the last unstable state that was found; from <= to
};

/// How far a path has valid states: their minimum film thickness is film.h_lift_off or more, and they are stable with
/// the journal held. States whose stability is not known count as stable.
struct FilmLimit {
  FilmLimitKind kind{};
  Status status{Status::not_converged};  ///< converged where the path was followed to where its film is too thin
  LimitBound bounded_by{};               ///< why the neighbour beyond the limit does not count
  /// Neighbours on the path: the last state that counts, and the one beyond it. Where no state counts, those on both
  /// sides of film.h_lift_off.
  OperatingPoint thick, thin;
  double h_thick{}, h_thin{};  ///< minimum film thicknesses there, m; not a number where there is no film
  /// |Omega|, rad/s, or the load, N: where film.h_lift_off is crossed, linear between the neighbours, or of `thick`
  /// where something else bounds it. Not a number where no state counts.
  double value{};
  int jumps{};                            ///< to other branches between the load ramp and the neighbours
  std::optional<bool> stable{};           ///< of `thick`, HeldMotions::is_stable()
  std::vector<UnstableRange> unstable{};  ///< among the states of the path that are thick enough, rising
  int unknown{};                          ///< states of the path that are thick enough, and may be stable or not

  [[nodiscard]] bool found() const { return status == Status::converged; }
};

/// A state of a running bearing, as requested and as found.
struct RunningState {
  FilmPath path{};                       ///< that led here
  OperatingPoint requested;              ///< speed, and load or position
  std::optional<OperatingPoint> before;  ///< state of the path that this one was reached from; none: from rest
  FilmReport report;   ///< of the way from the state before, or from rest; `not_reached` where that was not found
  double wall_time{};  ///< s
  /// Where the path came to: the state that was requested if the report says so, else the last one that was found on
  /// the way, if any was; its clearance offset is not zero where the clearance had not closed yet.
  std::optional<BearingState> last;
  std::optional<FilmBearingOutcome> outcome;  ///< of it
  /// FilmModel::by_slopes() of dF/dq of it: of further motion, and with all closed contacts stuck; absent where they
  /// are singular.
  std::optional<JournalMatrix> stiffness, stuck_stiffness;
  std::optional<double> foil_response;  ///< SlowMotion::foil_response, the larger one of both
  HeldMotions held;                     ///< of it
  int light_contacts{};                 ///< closed ones that carry less than 1 mN
  HeldMotions held_if_open;             ///< of it with these open; found only where there are any
  /// The least one where sliding contacts keep sliding, and where all stick; absent where the state is unstable with
  /// the journal held, and where a rotor of any mass is stable.
  std::optional<CriticalMass> critical_mass, stuck_critical_mass;
  /// At the frequencies of the case, or at that of the rotation: one entry or more.
  std::vector<FilmWhirl> whirls;
  std::optional<MeshError> mesh_error;  ///< of estimate_mesh_errors(), where it was requested
  /// For rotor dynamics, where StateCheckers see to it: at the frequency of the rotation, and at the frequencies that
  /// all states have in common, tabulated_frequencies().
  std::optional<FilmWhirl> synchronous;
  std::vector<FilmWhirl> tabulated;
  /// Largest bending stress of it, Pa: of the top foil over all columns; of the bump foil where its model knows one.
  std::optional<double> top_foil_stress, bump_foil_stress;
  /// Limits under its load and at its speed, where they were requested.
  std::optional<FilmLimit> lift_off_speed, load_capacity;
  /// |Omega| at which the torque under its load is least, rad/s: of add_least_torque_speeds().
  std::optional<double> least_torque_speed;

  /// Whether this stable state stands for an unstable one that the path of the case leads to: prefer_stable.
  bool instead_of_unstable{};

  [[nodiscard]] bool found() const { return report.status == Status::converged; }
};

/// Where another path to the same point ends in another state.
struct OtherBranch {
  std::size_t state{};              ///< of EquilibriumResult::states
  FilmPath path{};                  ///< the other one
  double minimum_film_thickness{};  ///< at its end, m
};

struct EquilibriumResult {
  SharedBearing bearing;
  std::vector<RunningState> states;         ///< path after path, in the order in which they were found
  bool with_limits{};                       ///< limits were requested
  std::vector<FilmLimit> limits;            ///< of add_film_limits(), where they were
  std::vector<OtherBranch> other_branches;  ///< of analyse_running_bearing(), where a second path was requested

  /// All states and limits were found.
  [[nodiscard]] bool converged() const;
};

/// The bearing whose states a case requests.
/// @throws Error (input) if the case cannot be built, has no [equilibrium], or has not what a path needs
BearingModel require_running_bearing(const Case& input);

/// Arranges the assessment of states: stability, stiffness, critical mass, stresses, and coefficients for rotor
/// dynamics. The search along a path does not wait for it. This class assesses states immediately.
class StateCheckers {
 public:
  virtual ~StateCheckers() = default;

  /// Checks a state by `check`, now or on another thread until finish(): the state stays where it is.
  virtual void take(const SharedBearing& /*bearing*/, RunningState& /*state*/, const std::function<void()>& check) {
    check();
  }

  /// Waits until all are checked. @throws what was thrown on other threads
  virtual void finish() {}
};

/// Checks none: states count by where they lie and by their films alone.
class NoCheckers final : public StateCheckers {
 public:
  void take(const SharedBearing& /*bearing*/, RunningState& /*state*/,
            const std::function<void()>& /*check*/) override {}
};

/// Finds the states of [equilibrium]: all speeds with all loads, or with all positions.
///
/// A path starts from ambient pressure: the journal is held at 0.6 C_r along the first load, or on the straight line to
/// the first position, at 0.7 C_r at most. Here C_r is less the lobes of pads. The path continues to the first state,
/// and from state to state:
///
/// * load_ramp, restarted at every speed: the load changes from the force found to the first load in `steps` equal
///   increments, then from load to load in one increment each.
/// * position_ray, restarted at every speed: the journal moves in a straight line to the first position in `steps`
///   equal increments, then from position to position in one increment each. Towards loads: from ambient pressure
///   at the centre, to 0.6 C_r along the first load in `steps` increments, then as a load ramp.
/// * speed_ramp, restarted for every load or position: load_ramp or position_ray at 1.5 times the first speed, then to
///   the first speed in `steps` equal increments, then from speed to speed in one increment each.
/// * cold_start, restarted for every state: directly at a position, where the journal must not touch the undeformed
///   foils; under a load the journal is released, and the film is marched in time until it rests.
///
/// Under a load a journal at rest, which requires asperities, is found from ambient pressure by a march in time on any
/// path. From rest to the first speed it breaks loose: that state is found by a march in time, too.
///
/// Such a sudden start of the film may throw the foils onto the journal. load_ramp, position_ray and speed_ramp then
/// begin at the centre instead, and the journal moves to its starting point in `steps` increments.
///
/// If the foils leave too little space for a film around a centred journal (0.3 C_r, less the lobes, below
/// film.h_floor, or C_r <= 0), they are opened before the start: C_r is increased until the assembled clearance is
/// c. Once the first state is reached in this way, or the one at 1.5 times its speed, the clearance closes in `steps`
/// equal increments at constant load or position. If it cannot close, the last state says how far it closed.
///
/// With `prefer_stable`, on one path, every state that is unstable with the journal held is replaced by the first
/// stable one that another path leads to, from rest to this state alone, if there is one. Later states on its path
/// still follow from the unstable one.
///
/// Friction refers to the previous increment; steps inside an increment are as small as necessary. After a state that
/// is not found, the later ones on its path are not computed.
///
/// @param paths     which to take, one after the other; empty: the one of the case
/// @param progress  called with the fraction that is done; returning false ends the run
/// @param checkers    of the states on these paths; none: each is checked before the next is looked for, and not for
/// rotor
///                  dynamics
/// @throws Error (input) as require_running_bearing() does
EquilibriumResult run_equilibrium(const Case& input, std::vector<FilmPath> paths = {},
                                  const std::function<bool(double)>& progress = {}, StateCheckers* checkers = nullptr);

/// The same of a bearing that is there already, along these paths.
/// @param thickness_floor  film.h_floor, m
EquilibriumResult find_states(const SharedBearing& bearing, const EquilibriumSettings& equilibrium,
                              double thickness_floor, const std::vector<FilmPath>& paths,
                              const std::function<bool(double)>& progress = {}, StateCheckers* checkers = nullptr);

/// Frequencies that all states of a case are tabulated at, rad/s, rising: those of the case; where it names none, from
/// 0.2 times the lowest speed to 1.2 times the highest at equal ratios, so close that nine or more lie between 0.2
/// and 1.2 times any speed.
std::vector<double> tabulated_frequencies(const EquilibriumSettings& equilibrium);

/// Adds to every state the speed of minimum torque on its curve over speed, with the same path, journal and sense of
/// rotation: the vertex of a parabola through the slowest three neighbours whose middle one has the least torque. There
/// a journal lifts off rough surfaces. It is absent without asperities, and if the minimum is at an end of the speeds.
void add_least_torque_speeds(EquilibriumResult& result);

/// The states of a case in the order in which its path reaches them, before any is computed: all have this status.
std::vector<RunningState> planned_states(const EquilibriumSettings& equilibrium, Status status);

/// Paths that lead to the states of a case: a ramp of loads needs loads.
std::vector<FilmPath> possible_paths(const EquilibriumSettings& equilibrium);

}  // namespace bumpfoil
