#include "bumpfoil/bearing/film_bearing.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "bearing/foil_lines.hpp"
#include "bearing/strip_points.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/section.hpp"
#include "bumpfoil/structure/top_foil_on_lines.hpp"

namespace bumpfoil {
namespace {

/// Mean pitch, m: bit-identical to the pitches if they are equal.
double mean_pitch(const std::vector<BumpShape>& bumps) {
  const double first = bumps.front().pitch;
  double beyond = 0.0;
  for (const BumpShape& bump : bumps) beyond += bump.pitch - first;
  return first + beyond / static_cast<double>(bumps.size());
}

/// @param stations  of BumpFoil::stations()
FoilFilm make_foil(const PadDesign& design, const FilmScales& scales, const FilmResolution& resolution,
                   const std::vector<int>& stations) {
  const FoilDesign foils = make_bearing_design(design);
  const auto bumps = static_cast<int>(foils.bumps.size());
  const double pitch = mean_pitch(foils.bumps);
  const int m = resolution.columns_per_pitch;
  BUMPFOIL_ASSERT(m >= 4 && m % 2 == 0);
  std::vector<int> crests;
  crests.reserve(foils.bumps.size() * stations.size());
  for (int i = 0; i < bumps; ++i) {
    for (const int station : stations) {
      BUMPFOIL_ASSERT(station * m % staggers_per_pitch == 0);
      crests.push_back(m / 2 + i * m + station * m / staggers_per_pitch);
    }
  }
  const double R = design.bearing.radius;
  const int rows = resolution.width == WidthPart::half ? resolution.rows : 2 * resolution.rows;
  const FilmMesh mesh = make_slotted_mesh(top_foil_intervals(foils, m, pitch), bumps * pitch / R / (bumps * m), rows,
                                          0.5 * design.bearing.axial_length / R, resolution.width);
  return make_foil_film(mesh, scales, make_top_foil_section(foils).bending_stiffness, pitch, std::move(crests),
                        make_forming(foils),
                        {.modes = resolution.width_modes,
                         .stretching = foils.top_foil->youngs_modulus * foils.top_foil->thickness,
                         .poisson_ratio = foils.top_foil->poisson_ratio});
}

/// Appends the film of one more pad.
void append(const PlacedPad& placed, const FilmResolution& resolution, const std::vector<int>& stations,
            FilmModel& film) {
  const PadDesign& alone = placed.alone;
  FilmPad pad;
  pad.foil = make_foil(alone, film.scales, resolution, stations);
  pad.stations = static_cast<int>(stations.size());
  if (const std::optional<Asperities>& rough = film.surroundings.asperities) {
    pad.foil.asperities = Asperities{.pressure_factor = rough->pressure_factor / film.scales.gas.ambient_pressure,
                                     .roughness = rough->roughness / film.scales.thickness,
                                     .friction = rough->friction};
  }
  pad.wrap_sign = placed.sense();
  pad.middle = placed.middle;
  pad.part = placed.part;
  pad.at_side = {placed.strip == 0, placed.strip + 1 == placed.strips};
  pad.first_column = film.columns();
  if (!film.pads.empty()) pad.first_block = film.pads.back().first_block + film.pads.back().bumps() + 1;
  const Vector angles = pad.foil.mesh.angles();
  const Eigen::Matrix2Xd normals = outward_normals(placed.polar(angles));
  film.pads.push_back(std::move(pad));
  film.column_normals.conservativeResize(Eigen::NoChange, film.columns());
  film.column_normals.rightCols(angles.size()) = normals;
  film.sleeve.conservativeResize(film.columns());
  film.sleeve.tail(angles.size()) = sleeve_deviations(alone, angles) + normals.transpose() * placed.centre;
}

double assembled_clearance_of(const BearingModel& bearing) {
  double narrowest = bearing.clearance;
  for (std::size_t k = 0; k < bearing.placed.size(); ++k)
    narrowest = std::min(narrowest, bearing.assembled_clearance_in(k));
  double widening = std::numeric_limits<double>::infinity();
  for (const FilmPad& pad : bearing.film->pads) {
    for (int j = 0; j <= pad.foil.mesh.rows; ++j) {
      widening = std::min(widening, bearing.film->surroundings.profile.widening(pad.zeta(j)));
    }
  }
  return narrowest + widening;
}

/// Number of unknowns of a block.
int block_size_of(const BearingModel& bearing) {
  const FilmPad& pad = bearing.film->pads.front();
  return std::max(bearing.behind_pressures(), unknowns_on_lines(bearing)) + unknowns_of_sheet(bearing, pad.foil.lines) +
         pad.stations * 2 * static_cast<int>(pad.foil.stretching.rows());
}

/// Fixes the unused unknowns at the free ends, but not the displacements there.
void hold_free_ends(const BearingModel& bearing, BlockTridiagonal& K) {
  const double stiffness = stiffest_of_bump_foils(bearing.structure);
  for (const FilmPad& pad : bearing.film->pads) {
    const int free_end = pad.first_block + pad.bumps();
    Matrix& last = K.diagonal[static_cast<std::size_t>(free_end)];
    last.diagonal().setConstant(stiffness);
    last.diagonal().segment(bearing.first_pressure(), pad.foil.lines.count()).setZero();
  }
}

}  // namespace

BearingModel make_film_bearing(const BearingModel& foils, const Gas& gas, const FilmResolution& resolution,
                               const FilmSurroundings& surroundings) {
  BearingModel bearing = foils;
  FilmModel& film = bearing.film.emplace();
  film.surroundings = surroundings;
  film.scales = {gas, foils.placed.front().alone.bearing.radius, film_thickness_scale(foils.clearance)};
  const BumpFoil& bump_foil = foils.placed.front().alone.bump_foil;
  const bool split = resolution.width_modes > 1 && bump_foil.is_split();
  BUMPFOIL_ASSERT(!split || resolution.sheet == SheetModel::held);
  const std::vector<int> stations = split ? bump_foil.stations() : std::vector<int>{0};
  for (const PlacedPad& placed : foils.placed) append(placed, resolution, stations, film);
  const FoilFilm& foil = film.pads.front().foil;
  const std::vector<BearingModel> strips = split ? strips_of(foils) : std::vector<BearingModel>();
  if (split) {
    lay_out_strips(foil.lines, bearing.behind_pressures(), bearing);
    keep_stress(strips, bearing);
    if (!foils.film && !foils.assembly.empty()) {
      bearing.assembly = on_strips(foils, resolution.width_modes, {}).assembly;
    }
  } else {
    bearing.sheet = resolution.sheet;
    bearing.lines = foil_lines_of(foil.lines, resolution.sheet, bearing.structure.dofs, bearing.behind_pressures());
  }
  film.assembled_clearance = assembled_clearance_of(bearing);
  BlockTridiagonal K(foils.structure.K.blocks() + bearing.pad_count(), block_size_of(bearing));
  if (split) {
    add_strips(bearing, strips, foil.lines, K);
  } else {
    add_bump_foils(bearing, foil.lines, K);
  }
  hold_free_ends(bearing, K);
  bearing.problem = {.K = std::move(K), .sites = {}, .force_scale = foils.problem.force_scale};
  // Gaps of the last blocks stay open.
  put_contacts_on_lines(split ? std::span(strips) : std::span(&foils, 1), film.scales.thickness, bearing);
  return bearing;
}

BearingModel formed_by(const BearingModel& bearing, double part) {
  BearingModel other = bearing;
  for (FilmPad& pad : other.film->pads) pad.foil.forming *= part;
  // The contact modes of the assembly stay the same, so the response is proportional.
  for (PadAssembly& pad : other.assembly) {
    pad.hold_down *= part;
    pad.load *= part;
    pad.bulge *= part;
  }
  if (part == 0.0) other.assembly.clear();
  other.film->assembled_clearance = assembled_clearance_of(other);
  return other;
}

Matrix undeformed_thickness(const BearingModel& bearing, const JournalVector& journal, double clearance_offset) {
  const FilmModel& film = *bearing.film;
  const double c = film.scales.thickness;
  Matrix H = film.field((bearing.clearance + clearance_offset) / c);
  H.rowwise() += (film.sleeve.transpose() - journal.head<2>().transpose() * film.column_normals) / c;
  film.add_tilt(journal, H);
  for (const FilmPad& pad : film.pads) {
    for (int j = 0; j <= pad.foil.mesh.rows; ++j) {
      H(j, pad.columns()).array() += film.surroundings.profile.widening(pad.zeta(j)) / c;
    }
  }
  return H;
}

BearingState resting(const BearingModel& bearing, const JournalVector& journal, double speed, double clearance_offset) {
  const FilmModel& film = *bearing.film;
  BearingState state;
  FilmModel::place_journal(journal, state);
  state.speed = speed;
  state.clearance_offset = clearance_offset;
  state.contacts = ContactState::unstressed(bearing.problem);
  const FoilFilm& foil = film.pads.front().foil;
  const Matrix of_lines = Matrix::Zero(foil.lines.count(), film.columns());
  state.film = {{film.resting_pressure(), undeformed_thickness(bearing, journal, clearance_offset)},
                of_lines,
                of_lines,
                Matrix::Zero(2 * foil.stretching.rows(), film.columns())};
  state.contacts.gap = bearing.assembled_gap;
  state.begin_increment();
  return state;
}

Vector bump_loads(const BearingModel& bearing, const BearingState& state) {
  const Eigen::Index per_block = bearing.contacts_per_block();
  Vector loads(bearing.bumps());
  Eigen::Index bump = 0;
  for (const FilmPad& pad : bearing.film->pads) {
    for (int b = 0; b < pad.bumps(); ++b) {
      loads[bump++] =
          state.contacts.normal_force.segment((pad.first_block + b) * per_block, bearing.crest_contacts()).sum();
    }
  }
  return loads;
}

}  // namespace bumpfoil
