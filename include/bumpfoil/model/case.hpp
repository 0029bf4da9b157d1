#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/model/bearing_design.hpp"
#include "bumpfoil/model/control.hpp"
#include "bumpfoil/model/gas_and_asperities.hpp"
#include "bumpfoil/model/scatter.hpp"
#include "bumpfoil/model/settings_by_type.hpp"

namespace bumpfoil {

enum class SolverName { newton, uzawa, events };

/// Parameters of the augmented Lagrangian method with penalty friction [Arghir2019, Eqs. 14-25]; see
/// origin/uzawa.hpp for what each does. Those that are absent follow from the stiffness of the foils, see
/// uzawa_options_for() there.
struct UzawaParameters {
  std::optional<double> eps_alm{};  ///< penalty of the normal contacts, N/m
  std::optional<double> eps_f{};    ///< penalty of sticking contacts, N/m
  std::optional<double> eps_r{};    ///< penalty of the journal contact, N/m
  std::optional<double> tau_f{};    ///< slip over which the friction force reverses, m

  bool operator==(const UzawaParameters&) const = default;
};

struct SolverSettings {
  std::optional<SolverName> name{};  ///< if the case names one
  UzawaParameters uzawa;

  bool operator==(const SolverSettings&) const = default;

  /// The solver that runs the case.
  [[nodiscard]] SolverName chosen() const { return name.value_or(SolverName::newton); }
};

/// A displacement (m) of the journal (or plate) from its initial position, or a load (N) on it.
struct Target {
  Control control{Control::displacement};
  double value{};

  bool operator==(const Target&) const = default;
};

/// A position (m) of the journal from the centre of the bearing, or a load (N), along X and Y.
struct PlaneTarget {
  Control control{Control::displacement};
  Eigen::Vector2d value{0.0, 0.0};

  bool operator==(const PlaneTarget&) const = default;
};

/// Cycles of the journal along each direction, each from the unstressed foils. One-sided cycles go from the centre to
/// full displacement or load and back. About a preload, or with `swing`, they are fully reversed: to the same distance
/// on the other side, and back.
struct CycleSettings {
  std::vector<double> directions;  ///< rad, from the X axis towards Y
  Target amplitude;
  std::optional<PlaneTarget> preload{};  ///< that cycles go about
  bool swing{};
  int cycles{1};                                    ///< at most, until the loop has settled
  int steps{100};                                   ///< equal increments from the start to full displacement or load
  std::vector<double> clearance_forces{5.0, 10.0};  ///< N, see Clearance

  bool operator==(const CycleSettings&) const = default;

  [[nodiscard]] bool is_fully_reversed() const { return swing || preload.has_value(); }
};

/// Cycles of a flat strip of the foils between a rigid base and a rigid plate. Without a preload each goes from zero to
/// `amplitude` and back; with one, from the preload up by `amplitude`, down by twice as much, and back.
struct StripSettings {
  int bumps{};  ///< the first bumps of the foil
  StripWeld weld{StripWeld::one_end};
  bool top_foil{true};  ///< there is one between plate and bumps
  Target amplitude;     ///< of the plate, from where it touches nominal foils, towards the base
  std::optional<Target> preload{};
  int cycles{1};   ///< one after the other, with friction carried over
  int steps{100};  ///< equal increments from the start of a cycle to its full amplitude

  bool operator==(const StripSettings&) const = default;
};

/// Points of a prescribed path, in order: positions (m) of the journal centre, or loads (N) on it.
struct PathPoints {
  Control control{Control::displacement};
  std::vector<Eigen::Vector2d> values;

  bool operator==(const PathPoints&) const = default;
};

/// Sense of an orbit, seen with X to the right and Y up.
enum class Sense { counterclockwise, clockwise };

/// How a journal vibrates.
enum class Motion {
  line,   ///< along a direction alone
  orbit,  ///< round a circle
};

/// Vibrations of the journal about static loads: about each load in each direction, or round a circle in either sense,
/// with each amplitude, until the loop has settled.
struct VibrationSettings {
  std::vector<Eigen::Vector2d> loads;  ///< N
  Motion motion{Motion::line};
  std::vector<double> directions;   ///< rad, from the X axis towards Y; one, or two at right angles; none for orbits
  std::vector<double> amplitudes;   ///< from the middle to a turning point, m
  std::vector<double> frequencies;  ///< at which the damping is evaluated, rad/s
  int steps{100};                   ///< equal increments up to a load, and from the middle to a turning point

  bool operator==(const VibrationSettings&) const = default;

  [[nodiscard]] bool orbits() const { return motion == Motion::orbit; }
  /// Vibrations about one load with one amplitude: one for each direction, or sense.
  [[nodiscard]] std::size_t motions() const { return orbits() ? 2 : directions.size(); }
};

/// Bearing surface that replaces the foils in the command film.
enum class FilmWall {
  rigid,
  springs,       ///< elastic (Winkler) foundation: deflects at every point under the pressure there
  rigid_across,  ///< axially uniform elastic foundation: deflects under the mean pressure over the width
};

/// Mesh of the film over the foils, limits of its thickness, and bearing surfaces that replace the foils.
struct FilmSettings {
  int columns_per_pitch{6};                ///< even, 4 or more: every crest is a column
  int rows{16};                            ///< intervals on half the width
  double h_floor{0.1e-6};                  ///< m; contact threshold: a thinner film counts as contact
  std::optional<double> inlet_pressure{};  ///< at the free ends of the foils, Pa; absent: ambient
  std::vector<double> side_pressure{};     ///< at the sides z < 0 and z > 0, Pa; empty: ambient
  FilmWall wall{FilmWall::rigid};
  std::optional<double> wall_stiffness{};  ///< foundation modulus: pressure over displacement, Pa/m
  bool closed{};                           ///< no slot at the weld
  std::optional<double> h_lift_off{};      ///< m; minimum film thickness after lift-off: no default

  /// Whether they are the same at both sides.
  [[nodiscard]] bool has_equal_sides() const {
    return side_pressure.empty() || side_pressure.front() == side_pressure.back();
  }
  bool operator==(const FilmSettings&) const = default;
};

/// How the film of a running bearing and its foils vary over the width.
struct WidthSettings {
  int modes{1};                        ///< of the displacement of the foils, see make_width_lines(): P_0, P_1, ...
  bool sheet{};                        ///< whether that of a bump foil gives way to P_2 and higher: SheetModel
  std::vector<double> tilt{0.0, 0.0};  ///< slope of the axis of the journal towards X and Y, rad
  std::vector<double> moment{};        ///< on the journal instead, int z dF along X and Y, N m; empty: by the tilt
  double conicity{};                   ///< WidthProfile, m
  double crowning{};                   ///< WidthProfile, m

  [[nodiscard]] WidthProfile profile() const { return {conicity, crowning}; }
  /// Whether the axis of the journal is not parallel to the sleeve's, or need not be.
  [[nodiscard]] bool tilts() const {
    return !moment.empty() || std::any_of(tilt.begin(), tilt.end(), [](double slope) { return slope != 0.0; });
  }
  bool operator==(const WidthSettings&) const = default;
};

/// Path along which a running bearing reaches its states: there may be several at one speed and load, and the path
/// decides.
enum class FilmPath {
  load_ramp,     ///< one load after the other, restarted at every speed
  speed_ramp,    ///< one speed after the other, restarted for every load or position
  position_ray,  ///< one position after the other, restarted at every speed
  cold_start,    ///< every state by itself, from ambient pressure
};

/// Number of paths by which the command `equilibrium` reaches its states.
enum class ComparedPaths {
  one,  ///< its own alone
  two,  ///< also a second one, whose states are compared but not kept
  all,  ///< every path that leads to the states; all states are kept
};

/// States of a running bearing: all speeds with all loads or with all positions.
struct EquilibriumSettings {
  std::vector<double> speeds{};              ///< Omega, rad/s; positive turns X to Y
  std::vector<Eigen::Vector2d> loads{};      ///< on the journal, N; empty with positions
  std::vector<Eigen::Vector2d> positions{};  ///< of the journal, m; empty with loads
  FilmPath path{FilmPath::load_ramp};
  ComparedPaths paths{ComparedPaths::two};  ///< of one run; sweeps and ensembles take one path
  bool prefer_stable{};                     ///< look for another state by other paths where one is unstable
  int steps{10};                            ///< equal increments of the ramp to the first state of a path
  std::vector<double> frequencies{};  ///< of motions for which coefficients are computed, rad/s; none: that of the
                                      ///< rotation
  int ross_version{3};                ///< that coefficients.toml is for, 2 or 3
  bool limits{};  ///< find lift-off speeds and load capacities, too; ensembles go by MonteCarloSettings::limits

  bool operator==(const EquilibriumSettings&) const = default;
};

/// Tables of a bearing that carries a rotor which differ from those of the case: whole tables.
struct RotorBearing {
  std::optional<Bearing> bearing{};
  std::optional<BumpFoil> bump_foil{};
  std::optional<TopFoil> top_foil{};
  std::vector<Pad> pads{};  ///< none: those of the case
  std::optional<Friction> friction{};
  std::optional<GasSettings> gas{};
  std::optional<FilmSettings> film{};
  std::optional<WidthSettings> width{};
  std::optional<AsperitySettings> asperity{};

  bool operator==(const RotorBearing&) const = default;
};

/// A case as interpreted: a bearing and the experiments on it. SI units, defaults filled in.
struct Case : BearingDesign {
  std::string title;
  SolverSettings solver;
  CycleSettings cycle;
  std::optional<StripSettings> strip{};
  std::optional<VibrationSettings> vibration{};
  GasSettings gas{};
  FilmSettings film{};
  WidthSettings width{};
  std::optional<AsperitySettings> asperity{};
  std::optional<EquilibriumSettings> equilibrium{};
  SettingsByType settings{};                   ///< of other experiments
  std::vector<RotorBearing> rotor_bearings{};  ///< one for each place of the rotor; none: all are that of the case
  std::optional<MonteCarloSettings> montecarlo{};
  /// Choices of the reader that the case file leaves open, in plain words: warnings of every result.
  std::vector<std::string> remarks{};

  /// Whether foils without a film deform differently over the width.
  [[nodiscard]] bool varies_over_the_width() const {
    return width.tilts() || width.profile() != WidthProfile{} || has_own_strips();
  }
  /// Whether strips of the bump foil may move independently: the top foil can follow that. Under a film they do.
  [[nodiscard]] bool lets_strips_move_apart() const {
    return bump_foil.is_split() && (width.modes > 1 || top_foil.split);
  }
  /// Whether films and foils are computed on half the width, as they are the same on both: where the top foil is split
  /// on half of every strip, none of which is at a side alone.
  [[nodiscard]] bool has_equal_halves() const {
    if (top_foil.split) return !width.tilts() && width.profile() == WidthProfile{} && film.side_pressure.empty();
    return !width.tilts() && width.conicity == 0.0 && film.has_equal_sides() && !lets_strips_move_apart();
  }
  bool operator==(const Case&) const = default;
};

/// The first-generation bearing of [Arghir2019, Table 1] with friction coefficient 0.1, pushed to 2.5 clearances along
/// +X, -X, +Y and -Y.
Case reference_case();

/// A bearing that carries the rotor, as a case with nothing to be done to it.
/// @param place  of the rotor's bearings, from 0
Case bearing_at(const Case& input, std::size_t place);

/// Strips of the bump foil whose bumps have heights drawn of their own in the ensemble of the case: 1 where all strips
/// have the same.
/// @pre  the case has an ensemble
std::size_t strips_drawn_apart(const Case& input);

}  // namespace bumpfoil
