#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/journal_law.hpp"
#include "bumpfoil/film/foil_film.hpp"
#include "bumpfoil/model/bearing_design.hpp"
#include "bumpfoil/model/control.hpp"
#include "bumpfoil/model/gas_and_asperities.hpp"
#include "bumpfoil/structure/bump_sheet.hpp"

namespace bumpfoil {

struct BearingState;

/// The gas of a case.
Gas gas_of(const GasSettings& settings);

/// Asperities of a case that is valid.
Asperities asperities_of(const AsperitySettings& settings, const TopFoil& top_foil);

/// c of a bearing, m: its clearance or interference, but not less than 10 um.
double film_thickness_scale(double clearance);

/// How a journal is tilted, or by what. A plain value.
struct JournalTilt {
  Control control{Control::displacement};
  Eigen::Vector2d value{Eigen::Vector2d::Zero()};  ///< its tilt, m, or the moment on it over half the width, N:
                                                   ///< the last two entries of JournalVector

  bool operator==(const JournalTilt&) const = default;
};

/// What else there is between journal and foils. A plain value.
struct FilmSurroundings {
  double inlet_pressure{1.0};               ///< P at the free ends of the foils
  Eigen::Vector2d side_pressure{1.0, 1.0};  ///< P at the sides z < 0 and z > 0; on half the width the same
  std::optional<Asperities> asperities{};   ///< of journal and top foils, in m and Pa; none: smooth surfaces
  JournalTilt tilt{};                       ///< in all states that are requested
  WidthProfile profile{};                   ///< of journal and sleeve
};

/// Mesh of the film over the foil of a bearing.
struct FilmResolution {
  int columns_per_pitch{6};  ///< even, 4 or more: every crest is a column, BumpFoil::least_columns_per_pitch()
  int rows{16};              ///< intervals on half the width
  int width_modes{1};        ///< of the displacement of the foils over the width, see make_width_lines()
  SheetModel sheet{};        ///< of a bump foil in one piece, against the higher ones
  WidthPart width{};         ///< all of it where the journal may tilt
};

/// The film of a pad, and the top foil under it.
struct FilmPad {
  FoilFilm foil;       ///< theta from the weld of the pad; its supports are the stations of bump after bump
  int stations{1};     ///< columns of the mesh that crests of a bump stand on: several where strips are staggered
  double wrap_sign{};  ///< sigma, PlacedPad::sense()
  int first_column{};  ///< among the columns of all pads
  int first_block{};   ///< among the blocks of all pads
  double middle{};     ///< PlacedPad::middle
  double part{1.0};    ///< PlacedPad::part
  /// Whether the edge towards z < 0, and that towards z > 0, is a side of the bearing; else it is at a slit.
  std::array<bool, 2> at_side{true, true};

  [[nodiscard]] int bumps() const { return static_cast<int>(foil.supports.size()) / stations; }
  /// Block that holds what is unknown over a support or, behind the last one, at the free end.
  [[nodiscard]] int block_of(int support) const { return first_block + support / stations; }
  /// Which of its bump's stations a support is; the free end has the first one.
  [[nodiscard]] int station_of(int support) const { return support % stations; }
  /// Among the lines of BearingModel, a line over a support.
  [[nodiscard]] Eigen::Index line_over(int support, Eigen::Index line) const {
    return station_of(support) * foil.lines.count() + line;
  }
  /// Place of a row over the width of the bearing: -1 and 1 at its sides.
  [[nodiscard]] double zeta(int row) const { return middle + part * foil.mesh.zeta(row); }
  /// Its columns in fields of all pads.
  [[nodiscard]] auto columns() const { return Eigen::seqN(first_column, foil.mesh.nodes()); }
};

/// The gas film of a running bearing with all its pads, and the top foil under it: what a BearingModel has in addition
/// to its foils. Immutable, so that solvers and results share it.
///
/// Every pad has its own film from edge to edge, with ambient pressure at both; pads are coupled only by the journal. A
/// bearing without pads is one pad. Fields have the columns of all pads in a row, each from its weld, and the same
/// number of rows for all. Each strip of a top foil that is split over the width is such a pad: its rows cover its part
/// of the width, and at the slits the film ends in ambient pressure.
struct FilmModel {
  FilmScales scales;  ///< c is film_thickness_scale()
  std::vector<FilmPad> pads;
  FilmSurroundings surroundings;
  double assembled_clearance{};  ///< C_r less lobe, bulge and what it is narrower at a side where they take most of it,
                                 ///< m: what a journal at the centre has everywhere in a round sleeve
  Eigen::Matrix2Xd column_normals;  ///< outward at all columns
  Vector sleeve;  ///< how much farther out than the nominal circle the undeformed foils lie at all columns, m: what
                  ///< the sleeve is wider there, and the lobe of the pad

  /// sigma Omega R, m/s: speed of the surface of the journal along theta; `speed` (rad/s) turns X to Y.
  [[nodiscard]] double surface_speed(const FilmPad& pad, double speed) const {
    return pad.wrap_sign * speed * scales.radius;
  }
  /// Columns of nodes of all pads.
  [[nodiscard]] int columns() const;
  /// A field that is `value` everywhere.
  [[nodiscard]] Matrix field(double value) const;
  /// P of gas at rest: 1, and what feeds it at the free ends and the sides between both ends.
  [[nodiscard]] Matrix resting_pressure() const;
  /// Whether the film covers the whole width, and the journal may tilt there.
  [[nodiscard]] bool tilts() const { return pads.front().foil.mesh.width == WidthPart::whole; }
  /// How many motions the journal has: entries of JournalVector.
  [[nodiscard]] Eigen::Index motions() const { return tilts() ? 4 : 2; }
  /// Where the journal of a state is.
  [[nodiscard]] JournalVector journal_of(const BearingState& state) const;
  /// Puts it there.
  static void place_journal(const JournalVector& journal, BearingState& state);
  /// Derivatives dF/dq with slopes (rad) in place of displacements at the side, and moments (N m) in place of forces.
  template <typename Derivatives>
  [[nodiscard]] Derivatives by_slopes(Derivatives derivatives) const {
    if (!tilts()) return derivatives;
    derivatives.bottomRows(2) *= half_width();
    derivatives.rightCols(2) *= half_width();
    return derivatives;
  }
  /// Whether the top foil is split over the width: its strips are the pads.
  [[nodiscard]] bool has_slits() const { return !pads.front().at_side[1]; }
  /// Half the axial length, m.
  [[nodiscard]] double half_width() const {
    return pads.front().foil.mesh.half_width() * scales.radius / pads.front().part;
  }
  /// Whether the film thickness may vary over the width.
  [[nodiscard]] bool varies_over_the_width() const {
    return tilts() || pads.front().foil.lines.count() > 1 || surroundings.profile != WidthProfile{};
  }
  /// Change of H by a displacement of the journal alone (m): the foils stay.
  [[nodiscard]] Matrix thickness_change(const JournalVector& displacement) const;
  /// Adds that by its tilt alone.
  void add_tilt(const JournalVector& displacement, Matrix& H) const;
  /// Displacements of the foils in all rows from those on all lines (FoilFilmState::deflection).
  [[nodiscard]] Matrix over_the_width(const Matrix& deflection) const;
};

/// What a pad has of a field of all.
Matrix part_of(const FilmPad& pad, const Matrix& field);

/// What a pad has of the state of all.
void read_part(const FilmPad& pad, const FoilFilmState& all, FoilFilmState& part);

/// Puts what a pad has in its place in the state of all.
void write_part(const FilmPad& pad, const FoilFilmState& part, FoilFilmState& all);

/// Force that must be applied to the journal under the pressure P at all nodes: the integral of (p - pa) n, and where
/// the journal may tilt of (p - pa) n zeta, N.
JournalVector film_force(const FilmModel& film, const Matrix& pressure);

/// P_c at all nodes of all pads, zero where surfaces are smooth: asperity_pressures().
Matrix asperity_pressures(const FilmModel& film, const Matrix& thickness);

/// Force that must be applied to the journal under asperities that press on it and rub: the integral of p_c (n + f t),
/// and where the journal may tilt of p_c (n + f t) zeta, N; t towards increasing polar angle.
/// @param pressures  P_c at all nodes, or its changes
/// @param friction   f, with the sign of the speed: sliding_friction()
JournalVector asperity_force(const FilmModel& film, const Matrix& pressures, double friction);

/// Coefficient of friction of asperities at a speed Omega (rad/s), with its sign: f tanh(Omega R / U_0), U_0 = 1 mm/s.
/// Below that a joint creeps: friction begins at rest with none.
double sliding_friction(const FilmModel& film, double speed);

/// Both together: what holds the journal in a state of the film at a speed, N.
JournalVector journal_force(const FilmModel& film, const FoilFilmState& state, double speed);

/// The Reynolds equation of a pad at a speed, steady.
ReynoldsEquation film_equation(const FilmModel& film, const FilmPad& pad, double speed);

/// Those of all pads.
using FilmEquations = std::vector<ReynoldsEquation>;
FilmEquations film_equations(const FilmModel& film, double speed);

/// Adds the squeeze term of a step in time.
/// @param squeeze_rate  T0 over BackwardDifference::span
/// @param content       its reference of film_content()
void squeeze(const FilmModel& film, double squeeze_rate, const Matrix& content, FilmEquations& equations);

}  // namespace bumpfoil
