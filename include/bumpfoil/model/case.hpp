#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/model/bearing_design.hpp"
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
  GasSettings gas{};
  FilmSettings film{};
  WidthSettings width{};
  std::optional<AsperitySettings> asperity{};
  SettingsByType settings{};                   ///< of experiments
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

/// A bearing that carries the rotor, as a case with nothing to be done to it.
/// @param place  of the rotor's bearings, from 0
Case bearing_at(const Case& input, std::size_t place);

/// Strips of the bump foil whose bumps have heights drawn of their own in the ensemble of the case: 1 where all strips
/// have the same.
/// @pre  the case has an ensemble
std::size_t strips_drawn_apart(const Case& input);

}  // namespace bumpfoil
