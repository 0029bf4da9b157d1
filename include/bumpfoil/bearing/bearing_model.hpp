#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/film_model.hpp"
#include "bumpfoil/contact/problem.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/bearing_design.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/structure/bump_sheet.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "bumpfoil/structure/stress.hpp"

namespace bumpfoil {

/// What is smaller is none: round-off of quantities as large as the foils are made for.
struct RoundOff {
  double force{};   ///< N: 1e-12 of a bump's stiffness times its rise
  double energy{};  ///< J: that times 1e-6 of the rise
  double stress{};  ///< Pa: 1e-12 of Young's modulus
};

/// `value`, or 0 where it is below a threshold: round-off.
inline double cleared(double value, double threshold) {
  return std::abs(value) < threshold ? 0.0 : value;
}

/// How the foils of a pad lie in the sleeve without a journal, where their top foil is formed otherwise than the circle
/// of the pad. On a rigid sleeve, all around and without friction, a foil that is uniformly flatter by kappa_0 rests on
/// its first bumps, leaves them at psi_0 = 122.57 degrees before its end, where psi_0/2 - sin(2 psi_0)/4 =
/// sin(psi_0) (1 - cos(psi_0)), bulges inward by 0.10474 R^2 kappa_0 at most, and rests on its last bump alone again,
/// with the force 1.18656 EI' kappa_0 / R.
struct PadAssembly {
  double hold_down{};    ///< load of the top foil on the last bump, N
  int lifted{};          ///< bumps before it that the top foil does not rest on
  double load{};         ///< of the top foil on all bumps, N
  double bulge{};        ///< largest inward displacement of the top foil over a crest, m
  double bulge_theta{};  ///< of that crest from the weld, rad
};

/// One of the lines over the width on which the displacement of foils is given (WidthLines): where it lies, the part of
/// the width that it stands for, and where in the block of a bump it has the unknowns of BumpDofs. Lines share the
/// places of what is uniform over the width.
struct FoilLine {
  double zeta{};
  double weight{1.0};
  std::vector<int> places;
  int strip{};  ///< of the bump foil, from 0, over whose crests it is
};

/// How a journal without a film stands over the width.
struct JournalOverWidth {
  Eigen::Vector2d slope{0.0, 0.0};          ///< of its axis towards X and Y, rad; stays so
  std::optional<Eigen::Vector2d> moment{};  ///< on it instead, int z dF, N m: it tilts until the foils balance that
  WidthProfile profile{};                   ///< of journal and sleeve
};

/// A bearing ready to be loaded: placed pads, elastic foils, their contacts with each other, with their support
/// (sleeve, base) and with the journal (or the plate that compresses a strip, called journal below); where it runs,
/// with a gas film in place of the contact with the journal. Immutable, so that any number of runs and threads may
/// share it.
///
/// The journal has a position in the X-Y plane: a displacement d moves it by d.n towards the foils over a bump with the
/// normal n. The plate of a strip moves along X, and all its normals are (1, 0).
///
/// The foils of a bearing of several pads follow each other, bump after bump, pad after pad.
///
/// Where the bump foil is split into strips that do not move alike, each strip supports the top foil at two points over
/// its width. Under each point is a separate bump foil, not connected to any other, whose crest touches the top foil at
/// the displacement u(zeta) of WidthLines. This displacement is an unknown of the block, top_u of the point, and so is
/// the force that ties it to the lines, its top_moment. Crests of staggered strips belong to the same bump, some
/// columns of the mesh of the top foil further along, and the journal may touch the lines there, too. Where the top
/// foil is split as well, there is a slice of it under each point, welded where the strip is, and no displacement is
/// tied.
///
/// Contacts of the block of a bump, in this order: journal/top foil, top foil/crest, then one per foot with the sleeve.
/// Where foils deform differently over the width, there is one on every line between journal and top foil, top foil and
/// crest and, if feet are not uniform, foot and sleeve; with strips the last two are at the points. Without a top foil
/// the first is missing, and the second is that of plate and crest. Under a film the first is missing.
///
/// Unknowns come in blocks: without a film those of FoilStructure; under a film, pad after pad, one for each bump and a
/// last one for the free end. The block of a bump then has the unknowns of its foils, including the top foil over the
/// crest, followed by the pressures of the column over the crest, c (P_j - 1) (m). Staggered strips have crests over
/// several columns, its stations; the pressures of the stations follow each other. The block of the free end has the
/// displacement of the top foil in the place of its first pressure; its other entries stay zero. K of the contact
/// problem is then that of the bump foils alone; it fixes the unused unknowns of the last blocks.
///
/// Where displacements under a film vary over the width, the first line uses the places of the foils' unknowns; the
/// unknowns of the other lines, and then those of the membrane at each station, follow the pressures. Displacements
/// that are symmetric over the width vary at top foil and crest only; those that are linear, as under a tilted journal,
/// vary in the whole bump foil, which then consists of independent slices. Against modes of higher order the crest has
/// springs of held_crest_stiffness(), and the other unknowns are held uniform by almost rigid springs. With
/// SheetModel::elastic the whole bump foil varies instead, and the stress functions of its sheet come between lines and
/// membrane. A bump foil that is split into strips is given at its own points, and the lines are those of the top foil.
struct BearingModel {
  std::vector<PlacedPad> placed;  ///< the pads of a bearing, worked out once; none of a strip
  FoilStructure structure;
  std::vector<StressModel> stress;  ///< of each pad
  ContactProblem problem;
  double rise{};             ///< of the mid-surface of the tallest bump, m
  double clearance{};        ///< gap between the journal, at the origin, and the undeformed foils, m
  Eigen::Matrix2Xd normals;  ///< unit vectors in the X-Y plane that point outward at each crest
  RoundOff round_off;
  Vector assembled_gap;  ///< g0 of each contact without the journal, m: height errors, sleeve gaps and waviness; and
                         ///< by what it stands nearer or farther over the width (JournalOverWidth)
  Vector forming;        ///< FoilStructure::forming on the unknowns of the problem without a film, N
  /// Of each pad, where any top foil is formed otherwise than its circle. None: they lie without stress, or their
  /// assembly was not found.
  std::vector<PadAssembly> assembly;
  std::vector<FoilLine> lines{};   ///< where foils vary over the width, those over the crests that are not staggered
                                   ///< first; none where all is uniform
  SheetModel sheet{};              ///< of a bump foil in one piece on these lines
  std::vector<FoilLine> points{};  ///< of strips that do not move alike; none otherwise: all of the foils is on lines
  bool split_top_foil{};  ///< each strip has one of its own: then the points are the lines, too, and all is on them
  std::vector<Eigen::Matrix2Xd> strip_normals{};         ///< as `normals`, of each strip where any is staggered
  std::vector<std::vector<StressModel>> strip_stress{};  ///< as `stress`, of each strip where any has its own thickness
  JournalOverWidth over_width{};                         ///< how the journal stands to the lines
  /// Where a moment is given: place in each block of how far the journal is tilted, as displacements of its side z > 0
  /// along X and, behind it, Y.
  int journal_tilt{-1};
  std::optional<FilmModel> film{};  ///< none: the journal touches the foils

  [[nodiscard]] bool has_top_foil() const { return structure.dofs.top_u >= 0; }
  /// Not where a wall takes the place of the foils.
  [[nodiscard]] bool has_foils() const { return bumps() > 0; }
  /// Place of the contact of top foil and crest in the block of a bump.
  [[nodiscard]] int top_bump() const { return has_top_foil() && !film ? journal_contacts() : 0; }
  /// Contacts of the journal with what is over the crests of a bump.
  [[nodiscard]] int journal_contacts() const { return lines.empty() ? 1 : static_cast<int>(lines.size()); }
  /// Where crests touch the top foil.
  [[nodiscard]] const std::vector<FoilLine>& crest_lines() const { return points.empty() ? lines : points; }
  /// Contacts of a crest with the top foil, side by side over the width.
  [[nodiscard]] int crest_contacts() const {
    return crest_lines().empty() ? 1 : static_cast<int>(crest_lines().size());
  }
  /// Contacts of a foot with the sleeve.
  [[nodiscard]] int foot_contacts() const { return is_uniform(structure.dofs.foot_u.front()) ? 1 : crest_contacts(); }
  /// Where one of crest_lines() has an unknown of the structure in the block of a bump. @param unknown  among BumpDofs
  [[nodiscard]] int place(Eigen::Index line, int unknown) const { return place(crest_lines(), line, unknown); }
  /// Whether an unknown of the structure is one and the same on all lines. @param unknown  among BumpDofs
  [[nodiscard]] bool is_uniform(int unknown) const {
    return crest_lines().size() < 2 || place(0, unknown) == place(1, unknown);
  }
  /// Unit vectors that point outward at the crests under a line.
  [[nodiscard]] const Eigen::Matrix2Xd& normals_on(int line) const {
    if (strip_normals.empty()) return normals;
    return strip_normals[static_cast<std::size_t>(lines[static_cast<std::size_t>(line)].strip)];
  }
  /// Lines over crests that are not staggered: the first ones. All, where each strip has a top foil of its own.
  [[nodiscard]] std::size_t unstaggered_lines() const;
  [[nodiscard]] int first_foot() const { return top_bump() + crest_contacts(); }
  /// None of a wall in place of the foils.
  [[nodiscard]] int contacts_per_block() const {
    return problem.K.blocks() == 0 ? 0 : problem.contacts() / problem.K.blocks();
  }
  [[nodiscard]] int bumps() const { return structure.bumps(); }
  [[nodiscard]] int pad_count() const { return static_cast<int>(structure.pads.size()); }
  [[nodiscard]] int feet_per_block() const { return structure.dofs.feet(); }
  /// What the assembled foils of a pad (from 0) leave a journal at the centre of a round sleeve, m: C_r less lobe and
  /// bulge. Negative: they press on it at rest.
  [[nodiscard]] double assembled_clearance_in(std::size_t pad) const {
    return clearance - placed[pad].lobe - (assembly.empty() ? 0.0 : assembly[pad].bulge);
  }
  /// Under a film: place of the first pressure in the block of a bump, at one of its stations.
  [[nodiscard]] int first_pressure(int station = 0) const {
    BUMPFOIL_ASSERT(film);
    return structure.dofs.size + station * film->pads.front().foil.mesh.unknown_rows();
  }
  /// Under a film: place behind the pressures of all stations.
  [[nodiscard]] int behind_pressures() const { return first_pressure(film->pads.front().stations); }
  /// Under a film: place of the first unknown of the membrane at a station.
  [[nodiscard]] int first_of_membrane(int station) const {
    BUMPFOIL_ASSERT(film);
    const auto of_station = 2 * static_cast<int>(film->pads.front().foil.stretching.rows());
    return problem.K.block_size() - (film->pads.front().stations - station) * of_station;
  }
  /// Block of the problem that holds a block of the structure.
  [[nodiscard]] int block(int of_structure) const;
  /// The unknowns that the structure knows among those of the problem, in the mean over the width, or those of the bump
  /// foil over one strip, from 0, of several that move apart.
  [[nodiscard]] Vector foil_unknowns(const Vector& x, std::optional<int> strip = {}) const;
  /// Contacts of the journal on a line, the first of each bump: entries of a vector of all contacts. Not under a film.
  [[nodiscard]] auto pressed(int line = 0) const {
    BUMPFOIL_ASSERT(!film);
    return Eigen::seqN(Eigen::Index{structure.first_bump} * contacts_per_block() + line, Eigen::Index{bumps()},
                       Eigen::Index{contacts_per_block()});
  }
  /// Displacements of the top foil over each bump, on a line: entries of a vector of all unknowns. Only where there is
  /// one, under no film.
  [[nodiscard]] auto top_foil(int line = 0) const {
    const Eigen::Index size = problem.K.block_size();
    return Eigen::seqN(structure.first_bump * size + place(lines, line, structure.dofs.top_u), Eigen::Index{bumps()},
                       size);
  }
  /// Where a line or point has an unknown of the structure in the block of a bump.
  static int place(const std::vector<FoilLine>& all, Eigen::Index line, int unknown) {
    if (all.empty()) return unknown;
    return all[static_cast<std::size_t>(line)].places[static_cast<std::size_t>(unknown)];
  }
};

using SharedBearing = std::shared_ptr<const BearingModel>;

/// What drives an increment. A plain value.
struct Excitation {
  Eigen::Vector2d position{0.0, 0.0};  ///< of the journal, m
  /// Added to the initial gap of each contact, m: sampled errors of heights, sleeve and journal. Empty: none.
  Vector gap_offset{};
  /// Forces on the top foil over each crest, N, positive outward: what loads between the crests come to there, see
  /// crest_loads() in structure/span_loads.hpp. Empty: none.
  Vector top_load{};
};

/// The law that a contact problem of the foils needs: absent where K says all.
std::optional<ElasticLaw> elastic_law(const FoilStructure& structure);

/// The foils of a bearing, pressed by its journal. The design must be valid.
BearingModel make_foils(const BearingDesign& design);

/// The foils of a bearing that runs: those of make_foils(), but each strip of a split top foil is a pad by itself, see
/// place_film_pads(). The design must be valid.
BearingModel make_film_foils(const BearingDesign& design);

/// The foils of a bearing whose journal does not press them alike over the width: displacements are given on the lines
/// of so many `modes` over the whole width, as under a film (WidthLines), and each line has contacts of its own with
/// the journal, too. What varies over the width stretches the top foil.
/// @param foils  uniform over the width, with a top foil and without an elastic law
BearingModel on_lines(const BearingModel& foils, int modes, const JournalOverWidth& journal, SheetModel sheet = {});

/// The foils of a bearing whose bump foil is split into strips that do not move alike: they differ, or the journal
/// does not press them alike. A whole top foil is given on lines by so many `modes` over the whole width as on_lines()
/// has them; one that is split is slices. Nothing joins the bump foils under the points of the strips, which slide and
/// lift one by one.
/// @param foils  uniform over the width, with a top foil and without an elastic law; where strips are staggered, it is
///               not formed
BearingModel on_strips(const BearingModel& foils, int modes, const JournalOverWidth& journal);

/// The foils of a bearing without a journal: of strips that differ on_strips(), to which the top foil answers linearly
/// and as a parabola over the width, too. The design must be valid.
BearingModel foils_without_journal(const BearingDesign& design);

/// A strip of foils, see make_strip_design(), between its plate and the base, without clearance. All must be valid.
BearingModel make_foils(const PadDesign& whole, int bumps, StripWeld weld, bool top_foil);

/// Gaps and loads under an excitation with the journal at `position`:
///
///     g_r = r_i + u_t,   g_t = -height_error_i - u_t + v_crest,   g_b = sleeve_gap_i - v_foot
///
/// [Arghir2019, Eqs. 1-4]; without a top foil r_i - height_error_i + v_crest in place of the first two. Its gap offsets
/// are added, its loads act on the top foil.
ContactLoading loading_under(const BearingModel& foils, const Excitation& excitation);

/// Rate of loading_under per metre of displacement along the unit vector `direction`.
ContactLoading loading_rate(const BearingModel& foils, const Eigen::Vector2d& direction);

/// Loads of the journal on the foils, N, one per bump.
Vector pressing_loads(const BearingModel& foils, const Vector& normal_force);

/// Force applied to the journal (or plate), N.
Eigen::Vector2d holding_force(const BearingModel& foils, const Vector& normal_force);

/// Moment of these forces about the mid-plane, int z dF, N m: none where all is uniform over the width.
Eigen::Vector2d holding_moment(const BearingModel& foils, const Vector& normal_force);

/// Slope of the axis of the journal towards X and Y, rad: as given, or what a given moment tilts it by.
Eigen::Vector2d journal_slope(const BearingModel& foils, const Vector& x);

/// What a given moment has worked since the journal stood parallel to the sleeve, J.
double work_of_moment(const BearingModel& foils, const Vector& x);

/// Elastic forces and energy of the foils on the unknowns of their problem, see elastic_response() in structure/. On
/// lines over the width the rows of unknowns that are no displacements hold what they lack.
ElasticResponse elastic_response(const BearingModel& foils, const Vector& x);

/// The part of it that each of several pads takes, one column per pad, N. One pad takes it all, and has no column.
Eigen::Matrix2Xd pad_forces(const BearingModel& foils, const Vector& normal_force);

}  // namespace bumpfoil
