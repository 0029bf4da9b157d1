#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/model/per_bump.hpp"

/// Geometry and materials of a bearing, as a case file gives them: plain values, SI units.
namespace bumpfoil {

/// Foil direction from the weld, seen with X to the right and Y up.
enum class Wrap { clockwise, counterclockwise };

/// What `BumpFoil::height` measures.
enum class HeightReference {
  overall,     ///< top of the bump over the sleeve; the rise of the mid-surface is height - thickness
  midsurface,  ///< rise of the mid-surface itself
};

/// Waves of a radius around the circumference.
struct Waviness {
  int harmonic{};      ///< their number
  double amplitude{};  ///< m
  double phase{};      ///< rad

  bool operator==(const Waviness&) const = default;
};

/// Radial deviation from nominal at the polar angle phi (from X towards Y).
///
///     w(phi) = sum of amplitude cos(harmonic phi - phase) + d(phi)
struct RadiusProfile {
  std::vector<Waviness> waves{};
  std::vector<double> deviations{};  ///< d, m, at equal angles from X on towards Y, straight between them; none: zero

  bool operator==(const RadiusProfile&) const = default;
};

/// How the clearance varies over the width where journal or sleeve is not cylindrical: at zeta = 2 z / L, from -1 to 1,
/// it is wider than in the middle by conicity zeta / 2 + crowning zeta^2. Foils lie on such a sleeve unstressed, so
/// that only the difference of both surfaces counts. A plain value.
struct WidthProfile {
  double conicity{};  ///< clearance at the side z > 0 less that at the side z < 0, m: of a cone
  double crowning{};  ///< clearance at both sides less that in the middle, m: of a barrel or a bell-mouthed sleeve

  bool operator==(const WidthProfile&) const = default;
  /// Of a place, m.
  [[nodiscard]] double widening(double zeta) const { return (0.5 * conicity + crowning * zeta) * zeta; }
};

/// The bearing and its frame of reference; conventions in docs/theory/conventions.md. SI units throughout.
struct Bearing {
  /// R, m: of the foils, also used for sleeve and journal. Infinite for a strip between plates without a bearing.
  double radius{std::numeric_limits<double>::infinity()};
  double axial_length{};                ///< L, m
  double radial_clearance{};            ///< C_r, m; zero or negative means interference
  double weld_angle{std::numbers::pi};  ///< polar angle of the weld, rad
  Wrap wrap{Wrap::clockwise};
  RadiusProfile sleeve{};
  RadiusProfile journal{};          ///< in the angles of the bearing: the journal does not rotate
  double taper{};                   ///< increase of the sleeve radius from the weld to the free end, m
  std::optional<double> pad_gap{};  ///< free angle after each pad without its own arc, rad

  [[nodiscard]] bool is_flat() const { return radius == std::numeric_limits<double>::infinity(); }

  /// Whether sleeve and journal are circles.
  [[nodiscard]] bool is_round() const {
    return sleeve == RadiusProfile{} && journal == RadiusProfile{} && taper == 0.0;
  }

  bool operator==(const Bearing&) const = default;
};

/// Parts of a pitch that strips may be staggered by.
inline constexpr int staggers_per_pitch = 6;

/// Properties specific to one of the strips into which a bump foil is split over the width.
struct FoilStrip {
  double stagger{};       ///< of the strip along the foil, its weld included, in pitches: a multiple of a sixth
  PerBump height_errors;  ///< m, positive = taller; added to those of the bump foil
  std::optional<double> thickness{};    ///< e_f of its bumps, m; absent: as of the bump foil
  std::vector<BumpSection> sections{};  ///< of its bumps with other lengths and thicknesses, no bump in two of them

  /// Whether its bumps have dimensions of their own.
  [[nodiscard]] bool has_own_bumps() const { return thickness || !sections.empty(); }
  /// Whether it is not as the foil in common.
  [[nodiscard]] bool differs() const {
    return stagger != 0.0 || has_own_bumps() ||
           std::any_of(height_errors.values.begin(), height_errors.values.end(),
                       [](double error) { return error != 0.0; });
  }
  /// The stagger in sixths of a pitch.
  [[nodiscard]] int sixths() const { return static_cast<int>(std::lround(staggers_per_pitch * stagger)); }
  bool operator==(const FoilStrip&) const = default;
};

struct BumpFoil {
  BumpFoilModel model{BumpFoilModel::truss};
  Geometry geometry{Geometry::linear};
  int bumps{};                          ///< N
  PerBump pitch;                        ///< p, m
  PerBump length;                       ///< chord of the arc 2 l0, m
  PerBump height;                       ///< h_b, m, read as `height_reference` says
  PerBump thickness;                    ///< e_f, m
  std::vector<BumpSection> sections{};  ///< of bumps that differ from these, no bump in two of them
  HeightReference height_reference{HeightReference::overall};
  double youngs_modulus{};               ///< E, Pa
  double poisson_ratio{};                ///< nu
  std::optional<double> yield_stress{};  ///< Pa, to compare the bending stress with
  std::vector<double> height_errors;     ///< m, positive = taller; empty or one per bump
  bool stiffness_follows_height{};       ///< a bump's height error changes its own stiffness too (frame model only)
  std::vector<Shim> shims{};             ///< under bumps, no bump on two of them
  std::vector<double> sleeve_gaps;       ///< g0_b, m; empty or one per bump
  int strips{1};                         ///< side by side over the width, of one width
  double strip_gap{};                    ///< between neighbouring strips, m
  std::vector<FoilStrip> strip{};        ///< each, from the side z < 0 on; empty: they are alike
  WeldPosition weld_at{WeldPosition::mid_flat};
  TrussOverrides truss;

  [[nodiscard]] bool is_split() const { return strips > 1; }
  /// Whether any strip differs from the foil in common.
  [[nodiscard]] bool has_own_strips() const {
    return std::any_of(strip.begin(), strip.end(), [](const FoilStrip& one) { return one.differs(); });
  }
  /// Largest stagger of a strip, in pitches.
  [[nodiscard]] double most_stagger() const {
    double most = 0.0;
    for (const FoilStrip& one : strip) most = std::max(most, one.sixths() / double{staggers_per_pitch});
    return most;
  }
  [[nodiscard]] bool is_staggered() const { return most_stagger() > 0.0; }
  /// Places of crests in a pitch, those of all strips: their staggers in sixths, each once, rising from 0.
  [[nodiscard]] std::vector<int> stations() const {
    if (strip.empty()) return {0};
    std::vector<int> places;
    places.reserve(strip.size());
    for (const FoilStrip& one : strip) places.push_back(one.sixths());
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }
  /// The columns per pitch of a mesh must be a multiple of this, so that every crest is a column.
  [[nodiscard]] int least_columns_per_pitch() const {
    constexpr int half = staggers_per_pitch / 2;
    const bool halves =
        std::all_of(strip.begin(), strip.end(), [](const FoilStrip& one) { return one.sixths() % half == 0; });
    return halves ? 2 : staggers_per_pitch;
  }
  bool operator==(const BumpFoil&) const = default;
};

/// Radius that a top foil is formed to before its assembly.
enum class FormedTo {
  bearing,  ///< that of the bearing: the foil lies on its bumps without stress
  seated,   ///< R / (1 - 6 C_r / R): its free end presses on the last bump, and a centred journal has room
  radius,   ///< a given one
};

struct FormedRadius {
  FormedTo to{FormedTo::bearing};
  double radius{};  ///< R_f, m, where it is given

  bool operator==(const FormedRadius&) const = default;
};

struct TopFoil {
  double thickness{};       ///< m
  double youngs_modulus{};  ///< Pa
  double poisson_ratio{};
  std::optional<double> yield_stress{};   ///< Pa, to compare the bending stress with
  FormedRadius formed_radius{};           ///< R_f
  std::optional<double> seat_pressure{};  ///< Pa: forming, beside that of the radius, that presses on all bumps alike
  std::optional<double> overhang{};       ///< from the last crest to the free end, m; absent: half a pitch
  bool split{};                           ///< over the width as the bump foil is; else whole

  bool operator==(const TopFoil&) const = default;
};

/// The edge of a pad that its foils are welded at; the leading one comes first in the sense of `Bearing::wrap`.
enum class WeldEdge {
  leading,   ///< the foils run from the weld in that sense
  trailing,  ///< and against it
};

/// A part of the sleeve with its own foils. Absent values come from the common tables or follow from all pads, see
/// place_pads().
struct Pad {
  std::optional<double> weld_angle{};  ///< polar angle of the weld, rad
  WeldEdge weld_edge{WeldEdge::leading};
  std::optional<double> arc{};  ///< angle from the weld to the free end, which pitches are stretched to fill, rad
  double lobe{};                ///< preload: offset of the centre of its circle away from its middle, m
  std::optional<BumpFoil> bump_foil{};
  std::optional<TopFoil> top_foil{};

  bool operator==(const Pad&) const = default;
};

/// Coulomb friction coefficients; the journal is frictionless.
struct Friction {
  double top_bump{};     ///< between top foil and crests
  double bump_sleeve{};  ///< between feet and sleeve

  bool operator==(const Friction&) const = default;
};

/// How the foils of a strip are held.
enum class StripWeld {
  one_end,  ///< both are clamped before bump 1, as in the bearing
  none,     ///< both are free at both ends
};

/// Foils with the bearing that they lie in: those of a pad by itself, or of a bearing that they go all around.
struct PadDesign {
  Bearing bearing{};
  BumpFoil bump_foil{};
  TopFoil top_foil{};
  Friction friction{};

  bool operator==(const PadDesign&) const = default;
};

/// A bearing: its foils, or those that its pads have in common.
struct BearingDesign : PadDesign {
  std::vector<Pad> pads{};  ///< none: the foils of the bearing go round in one

  /// Whether strips of a bump foil differ, that of the bearing or of a pad.
  [[nodiscard]] bool has_own_strips() const {
    return bump_foil.has_own_strips() || std::any_of(pads.begin(), pads.end(), [](const Pad& pad) {
             return pad.bump_foil && pad.bump_foil->has_own_strips();
           });
  }
  bool operator==(const BearingDesign&) const = default;
};

}  // namespace bumpfoil
