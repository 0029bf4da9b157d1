#include "bumpfoil/bearing/film_bearing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "bearing/foil_lines.hpp"
#include "bearing/strip_points.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/section.hpp"
#include "bumpfoil/structure/top_foil_on_lines.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Minimum surface speed in asperity friction, m/s: regularises slower rubbing as creep.
constexpr double creep_speed = 1e-3;

/// Lower bound of the thickness scale c, for small clearances or interference, m.
constexpr double least_scale = 10e-6;

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

}  // namespace

Gas gas_of(const GasSettings& settings) {
  return {.viscosity = settings.viscosity.value_or(viscosity(settings.preset, settings.temperature)),
          .ambient_pressure = settings.ambient_pressure,
          .mean_free_path = settings.mean_free_path};
}

Asperities asperities_of(const AsperitySettings& settings, const TopFoil& top_foil) {
  Asperities rough{.roughness = settings.sigma, .friction = settings.friction};
  const double own = top_foil.youngs_modulus / (2.0 * (1.0 - top_foil.poisson_ratio * top_foil.poisson_ratio));
  rough.pressure_factor = settings.pressure_factor
                              ? *settings.pressure_factor
                              : asperity_pressure_factor(settings.sigma, *settings.density, *settings.radius,
                                                         settings.modulus.value_or(own));
  return rough;
}

double film_thickness_scale(double clearance) {
  return std::max(std::abs(clearance), least_scale);
}

int FilmBearing::columns() const {
  return pads.empty() ? 0 : pads.back().first_column + pads.back().foil.mesh.nodes();
}

Matrix FilmBearing::field(double value) const {
  return Matrix::Constant(pads.front().foil.mesh.rows + 1, columns(), value);
}

Matrix FilmBearing::over_the_width(const Matrix& lift) const {
  return product(pads.front().foil.shapes, lift);
}

Matrix FilmBearing::resting_pressure() const {
  Matrix pressure = field(1.0);
  for (const FilmPad& pad : pads) {
    const FilmMesh& mesh = pad.foil.mesh;
    const auto inside = Eigen::seqN(pad.first_column + mesh.first_unknown(), mesh.unknown_columns());
    for (int j = 0; j <= mesh.rows; ++j) {
      const std::size_t side = mesh.zeta(j) < 0.0 ? 0 : 1;
      if (mesh.is_side(j) && pad.at_side[side]) {
        pressure(j, inside).setConstant(surroundings.side_pressure[static_cast<Eigen::Index>(side)]);
      }
    }
    if (mesh.closed) continue;
    pressure.col(pad.first_column + mesh.columns)
        .segment(mesh.first_unknown_row(), mesh.unknown_rows())
        .setConstant(surroundings.inlet_pressure);
  }
  return pressure;
}

JournalVector FilmBearing::journal_of(const BearingState& state) const {
  JournalVector journal(motions());
  journal.head<2>() = state.position;
  if (tilts()) journal.tail<2>() = state.tilt;
  return journal;
}

void FilmBearing::place_journal(const JournalVector& journal, BearingState& state) {
  state.position = journal.head<2>();
  if (journal.size() > 2) state.tilt = journal.tail<2>();
}

namespace {

/// Adds the change of H by the tilt of the journal.
void add_tilt(const FilmBearing& bearing, const JournalVector& journal, Matrix& H) {
  if (journal.size() == 2) return;
  const Eigen::RowVectorXd at_side = journal.tail<2>().transpose() * bearing.column_normals / -bearing.scales.thickness;
  for (const FilmPad& pad : bearing.pads) {
    for (int j = 0; j <= pad.foil.mesh.rows; ++j) H(j, pad.columns()) += pad.zeta(j) * at_side(pad.columns());
  }
}

}  // namespace

Matrix FilmBearing::undeformed_thickness(const JournalVector& journal, double clearance_offset) const {
  Matrix H = field((clearance + clearance_offset) / scales.thickness);
  H.rowwise() += (sleeve.transpose() - journal.head<2>().transpose() * column_normals) / scales.thickness;
  add_tilt(*this, journal, H);
  for (const FilmPad& pad : pads) {
    for (int j = 0; j <= pad.foil.mesh.rows; ++j) {
      H(j, pad.columns()).array() += surroundings.profile.widening(pad.zeta(j)) / scales.thickness;
    }
  }
  return H;
}

Matrix FilmBearing::thinning(const JournalVector& displacement) const {
  Matrix H = (displacement.head<2>().transpose() * column_normals / -scales.thickness)
                 .replicate(pads.front().foil.mesh.rows + 1, 1);
  add_tilt(*this, displacement, H);
  return H;
}

Matrix part_of(const FilmPad& pad, const Matrix& field) {
  return field(Eigen::all, pad.columns());
}

void read_part(const FilmPad& pad, const FoilFilmState& all, FoilFilmState& part) {
  part.pressure = all.pressure(Eigen::all, pad.columns());
  part.thickness = all.thickness(Eigen::all, pad.columns());
  part.lift = all.lift(Eigen::all, pad.columns());
  part.moment = all.moment(Eigen::all, pad.columns());
  part.membrane = all.membrane(Eigen::all, pad.columns());
}

void write_part(const FilmPad& pad, const FoilFilmState& part, FoilFilmState& all) {
  all.pressure(Eigen::all, pad.columns()) = part.pressure;
  all.thickness(Eigen::all, pad.columns()) = part.thickness;
  all.lift(Eigen::all, pad.columns()) = part.lift;
  all.moment(Eigen::all, pad.columns()) = part.moment;
  all.membrane(Eigen::all, pad.columns()) = part.membrane;
}

namespace {

/// Appends one more pad.
void append(const PlacedPad& placed, const FilmResolution& resolution, const std::vector<int>& stations,
            FilmBearing& bearing) {
  const PadDesign& alone = placed.alone;
  FilmPad pad;
  pad.foil = make_foil(alone, bearing.scales, resolution, stations);
  pad.stations = static_cast<int>(stations.size());
  if (const std::optional<Asperities>& rough = bearing.surroundings.asperities) {
    pad.foil.asperities = Asperities{.pressure_factor = rough->pressure_factor / bearing.scales.gas.ambient_pressure,
                                     .roughness = rough->roughness / bearing.scales.thickness,
                                     .friction = rough->friction};
  }
  pad.wrap_sign = placed.sense();
  pad.middle = placed.middle;
  pad.part = placed.part;
  pad.at_side = {placed.strip == 0, placed.strip + 1 == placed.strips};
  pad.first_column = bearing.columns();
  if (!bearing.pads.empty()) pad.first_block = bearing.pads.back().first_block + bearing.pads.back().bumps() + 1;
  const Vector angles = pad.foil.mesh.angles();
  const Eigen::Matrix2Xd normals = outward_normals(placed.polar(angles));
  bearing.pads.push_back(std::move(pad));
  bearing.column_normals.conservativeResize(Eigen::NoChange, bearing.columns());
  bearing.column_normals.rightCols(angles.size()) = normals;
  bearing.sleeve.conservativeResize(bearing.columns());
  bearing.sleeve.tail(angles.size()) = sleeve_deviations(alone, angles) + normals.transpose() * placed.centre;
}

double assembled_clearance_of(const FilmBearing& bearing) {
  double narrowest = bearing.clearance;
  for (std::size_t k = 0; k < bearing.placed.size(); ++k)
    narrowest = std::min(narrowest, bearing.assembled_clearance_in(k));
  double widening = std::numeric_limits<double>::infinity();
  for (const FilmPad& pad : bearing.pads) {
    for (int j = 0; j <= pad.foil.mesh.rows; ++j) {
      widening = std::min(widening, bearing.surroundings.profile.widening(pad.zeta(j)));
    }
  }
  return narrowest + widening;
}

/// Number of unknowns of a block.
int block_size_of(const FilmBearing& bearing) {
  const FilmPad& pad = bearing.pads.front();
  return std::max(bearing.behind_pressures(), unknowns_on_lines(bearing)) + unknowns_of_sheet(bearing, pad.foil.lines) +
         pad.stations * 2 * static_cast<int>(pad.foil.stretching.rows());
}

/// Fixes the unused unknowns at the free ends, but not the displacements there.
void hold_free_ends(const FilmBearing& bearing, BlockTridiagonal& K) {
  const double stiffness = stiffest_of_bump_foils(bearing.structure);
  for (const FilmPad& pad : bearing.pads) {
    const int free_end = pad.first_block + pad.bumps();
    Matrix& last = K.diagonal[static_cast<std::size_t>(free_end)];
    last.diagonal().setConstant(stiffness);
    last.diagonal().segment(bearing.first_pressure(), pad.foil.lines.count()).setZero();
  }
}

}  // namespace

FilmBearing make_film_bearing(const Foils& foils, const Gas& gas, const FilmResolution& resolution,
                              const FilmSurroundings& surroundings) {
  FilmBearing bearing;
  static_cast<Foils&>(bearing) = foils;
  bearing.under_film = true;
  bearing.surroundings = surroundings;
  bearing.scales = {gas, foils.placed.front().alone.bearing.radius, film_thickness_scale(foils.clearance)};
  const BumpFoil& bump_foil = foils.placed.front().alone.bump_foil;
  const bool split = resolution.width_modes > 1 && bump_foil.is_split();
  BUMPFOIL_ASSERT(!split || resolution.sheet == SheetModel::held);
  const std::vector<int> stations = split ? bump_foil.stations() : std::vector<int>{0};
  for (const PlacedPad& placed : foils.placed) append(placed, resolution, stations, bearing);
  const FoilFilm& foil = bearing.pads.front().foil;
  const std::vector<Foils> strips = split ? strips_of(foils) : std::vector<Foils>();
  if (split) {
    lay_out_strips(foil.lines, bearing.behind_pressures(), bearing);
    keep_stress(strips, bearing);
    if (!foils.under_film && !foils.assembly.empty()) {
      bearing.assembly = on_strips(foils, resolution.width_modes, {}).assembly;
    }
  } else {
    bearing.sheet = resolution.sheet;
    bearing.lines = foil_lines_of(foil.lines, resolution.sheet, bearing.dofs(), bearing.behind_pressures());
  }
  bearing.assembled_clearance = assembled_clearance_of(bearing);
  BlockTridiagonal K(foils.structure.K.blocks() + bearing.pad_count(), block_size_of(bearing));
  if (split) {
    add_strips(bearing, strips, foil.lines, K);
  } else {
    add_bump_foils(bearing, foil.lines, K);
  }
  hold_free_ends(bearing, K);
  bearing.problem = {.K = std::move(K), .sites = {}, .force_scale = foils.problem.force_scale};
  // Gaps of the last blocks stay open.
  put_contacts_on_lines(split ? std::span(strips) : std::span(&foils, 1), bearing.scales.thickness, bearing);
  return bearing;
}

FilmBearing formed_by(const FilmBearing& bearing, double part) {
  FilmBearing other = bearing;
  for (FilmPad& pad : other.pads) pad.foil.forming *= part;
  // The contact modes of the assembly stay the same, so the response is proportional.
  for (PadAssembly& pad : other.assembly) {
    pad.hold_down *= part;
    pad.load *= part;
    pad.bulge *= part;
  }
  if (part == 0.0) other.assembly.clear();
  other.assembled_clearance = assembled_clearance_of(other);
  return other;
}

BearingState resting(const FilmBearing& bearing, const JournalVector& journal, double speed, double clearance_offset) {
  BearingState state;
  FilmBearing::place_journal(journal, state);
  state.speed = speed;
  state.clearance_offset = clearance_offset;
  state.contacts = ContactState::unstressed(bearing.problem);
  const FoilFilm& foil = bearing.pads.front().foil;
  const Matrix of_lines = Matrix::Zero(foil.lines.count(), bearing.columns());
  state.film = {{bearing.resting_pressure(), bearing.undeformed_thickness(journal, clearance_offset)},
                of_lines,
                of_lines,
                Matrix::Zero(2 * foil.stretching.rows(), bearing.columns())};
  state.contacts.gap = bearing.assembled_gap;
  state.begin_increment();
  return state;
}

ReynoldsEquation film_equation(const FilmBearing& bearing, const FilmPad& pad, double speed) {
  return {.mesh = pad.foil.mesh,
          .bearing_number = bearing.scales.bearing_number(bearing.surface_speed(pad, speed)),
          .knudsen = bearing.scales.knudsen()};
}

FilmEquations film_equations(const FilmBearing& bearing, double speed) {
  FilmEquations equations;
  equations.reserve(bearing.pads.size());
  for (const FilmPad& pad : bearing.pads) equations.push_back(film_equation(bearing, pad, speed));
  return equations;
}

void squeeze(const FilmBearing& bearing, double squeeze_rate, const Matrix& content, FilmEquations& equations) {
  for (std::size_t k = 0; k < equations.size(); ++k) {
    equations[k].squeeze_rate = squeeze_rate;
    equations[k].previous_content = part_of(bearing.pads[k], content);
  }
}

namespace {

/// Force of the excess over a pressure of `outside`, at nodes where it is positive.
JournalVector pad_force(const FilmBearing& bearing, const FilmPad& pad, const Matrix& pressure, double outside) {
  const FilmMesh& mesh = pad.foil.mesh;
  const Matrix excess = pressure(Eigen::all, pad.columns()).array() - outside;
  const auto sum = [&](const Vector& of_rows) -> Eigen::Vector2d {
    return bearing.column_normals(Eigen::all, pad.columns()) * mesh.weights.cwiseProduct(excess.transpose() * of_rows);
  };
  Vector of_rows(mesh.rows + 1);
  for (int j = 0; j <= mesh.rows; ++j) of_rows[j] = mesh.row_weight(j);
  JournalVector force(bearing.motions());
  force.head<2>() = sum(of_rows);
  if (bearing.tilts()) {
    for (int j = 0; j <= mesh.rows; ++j) of_rows[j] *= pad.zeta(j);  // lever arm
    force.tail<2>() = sum(of_rows);
  }
  return mesh.copies() * bearing.scales.force() * mesh.dtheta * mesh.dzeta * force;
}

}  // namespace

JournalVector film_force(const FilmBearing& bearing, const Matrix& pressure) {
  JournalVector force = JournalVector::Zero(bearing.motions());
  for (const FilmPad& pad : bearing.pads) force += pad_force(bearing, pad, pressure, 1.0);
  return force;
}

Matrix asperity_pressures(const FilmBearing& bearing, const Matrix& thickness) {
  Matrix pressures(thickness.rows(), bearing.columns());
  for (const FilmPad& pad : bearing.pads) {
    pressures(Eigen::all, pad.columns()) = asperity_pressures(pad.foil, part_of(pad, thickness));
  }
  return pressures;
}

namespace {

/// Integral of p_c over a pad, N.
double pressed(const FilmBearing& bearing, const FilmPad& pad, const Matrix& pressures) {
  const FilmMesh& mesh = pad.foil.mesh;
  double sum = 0.0;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      sum += mesh.column_weight(k) * mesh.row_weight(j) * pressures(j, pad.first_column + k);
    }
  }
  return mesh.copies() * bearing.scales.force() * mesh.dtheta * mesh.dzeta * sum;
}

JournalVector pad_asperity_force(const FilmBearing& bearing, const FilmPad& pad, const Matrix& pressures,
                                 double friction) {
  JournalVector force = pad_force(bearing, pad, pressures, 0.0);
  for (Eigen::Index i = 0; i < force.size(); i += 2) {
    force.segment<2>(i) += friction * Eigen::Vector2d(-force[i + 1], force[i]);
  }
  return force;
}

}  // namespace

JournalVector asperity_force(const FilmBearing& bearing, const Matrix& pressures, double friction) {
  JournalVector force = JournalVector::Zero(bearing.motions());
  for (const FilmPad& pad : bearing.pads) force += pad_asperity_force(bearing, pad, pressures, friction);
  return force;
}

double sliding_friction(const FilmBearing& bearing, double speed) {
  const std::optional<Asperities>& rough = bearing.surroundings.asperities;
  return rough ? rough->friction * std::tanh(speed * bearing.scales.radius / creep_speed) : 0.0;
}

JournalVector journal_force(const FilmBearing& bearing, const FoilFilmState& film, double speed) {
  JournalVector force = film_force(bearing, film.pressure);
  if (bearing.surroundings.asperities) {
    force += asperity_force(bearing, asperity_pressures(bearing, film.thickness), sliding_friction(bearing, speed));
  }
  return force;
}

Vector bump_loads(const FilmBearing& bearing, const BearingState& state) {
  const Eigen::Index per_block = bearing.contacts_per_block();
  Vector loads(bearing.bumps());
  Eigen::Index bump = 0;
  for (const FilmPad& pad : bearing.pads) {
    for (int b = 0; b < pad.bumps(); ++b) {
      loads[bump++] =
          state.contacts.normal_force.segment((pad.first_block + b) * per_block, bearing.crest_contacts()).sum();
    }
  }
  return loads;
}

namespace {

/// Integral of (P - 1) dU/dtheta over the whole width; U is the outward deviation of the wall from a circle.
double pressing_slope(const FilmMesh& mesh, const Matrix& pressure, const Matrix& wall) {
  double sum = 0.0;
  for (int k = 0; k < mesh.columns; ++k) {
    const int next = mesh.next(k);
    for (int j = 0; j <= mesh.rows; ++j) {
      const double excess = 0.5 * (pressure(j, k) + pressure(j, next)) - 1.0;
      sum += mesh.copies() * mesh.row_weight(j) * mesh.dzeta * excess * (wall(j, next) - wall(j, k));
    }
  }
  return sum;
}

/// Angle wrapped to (-pi, pi].
double wrapped(double angle) {
  return angle - 2.0 * std::numbers::pi * std::ceil(angle / (2.0 * std::numbers::pi) - 0.5);
}

/// Forces of film and asperities on the bearing, and asperity friction.
/// @return the film force
JournalVector find_forces(const FilmBearing& bearing, const BearingState& state, FilmBearingOutcome& outcome) {
  const Matrix pressures = asperity_pressures(bearing, state.film.thickness);
  const double friction = sliding_friction(bearing, state.speed);
  const JournalVector of_asperities = asperity_force(bearing, pressures, friction);
  JournalVector of_film = film_force(bearing, state.film.pressure);
  outcome.asperity_force = of_asperities.head<2>();
  outcome.force = of_film.head<2>() + outcome.asperity_force;
  if (bearing.tilts()) outcome.moment = bearing.half_width() * (of_film + of_asperities).tail<2>();
  outcome.max_asperity_pressure = pressures.maxCoeff();
  const bool several = bearing.pads.size() > 1;
  if (several) outcome.pad_forces.resize(2, std::ssize(bearing.pads));
  for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
    const FilmPad& pad = bearing.pads[k];
    if (several) {
      outcome.pad_forces.col(static_cast<Eigen::Index>(k)) =
          (pad_force(bearing, pad, state.film.pressure, 1.0) + pad_asperity_force(bearing, pad, pressures, friction))
              .head<2>();
    }
    outcome.asperity_torque += friction * bearing.scales.radius * pressed(bearing, pad, pressures);
  }
  return of_film;
}

/// Sum over all pads of drag, flow and dissipation. @param of_film  force of the film on the journal
void find_drag(const FilmBearing& bearing, const BearingState& state, const JournalVector& of_film,
               FilmBearingOutcome& outcome) {
  const FilmScales& scales = bearing.scales;
  // Includes the increase of the sleeve radius.
  Matrix wall = state.film.thickness - bearing.undeformed_thickness(bearing.journal_of(state), state.clearance_offset);
  wall.rowwise() += bearing.sleeve.transpose() / scales.thickness;
  const double couette = scales.couette_torque(state.speed * scales.radius);
  double poiseuille_torque = 0.0;
  double pressure_dissipation = 0.0;
  double slope = 0.0;
  FoilFilmState part;
  Matrix residual;
  for (const FilmPad& pad : bearing.pads) {
    read_part(pad, state.film, part);
    const ReynoldsEquation equation = film_equation(bearing, pad, state.speed);
    const FilmIntegrals sums = film_integrals(equation, part);
    outcome.couette_torque += couette * sums.couette;
    poiseuille_torque += pad.wrap_sign * scales.poiseuille_torque() * sums.poiseuille;
    pressure_dissipation += scales.gas.ambient_pressure * scales.flow() * sums.dissipation;
    slope += pad.wrap_sign * scales.force() * scales.thickness *
             pressing_slope(pad.foil.mesh, part.pressure, part_of(pad, wall));
    reynolds_residual(equation, part, residual);
    const FilmFlows flows = film_flows(pad.foil.mesh, residual);
    outcome.flows.start += scales.flow() * flows.start;
    outcome.flows.end += scales.flow() * flows.end;
    outcome.flows.sides += scales.flow() * flows.sides;
    const double left_side = flows.sides - flows.right_side;
    if (pad.at_side[1]) outcome.flows.right_side += scales.flow() * flows.right_side;
    outcome.slit_flow +=
        scales.flow() * ((pad.at_side[0] ? 0.0 : left_side) + (pad.at_side[1] ? 0.0 : flows.right_side));
  }
  outcome.torque = outcome.couette_torque + outcome.asperity_torque + poiseuille_torque;
  outcome.power = outcome.torque * state.speed;
  outcome.couette_dissipation = outcome.couette_torque * state.speed;
  outcome.dissipation = outcome.couette_dissipation + pressure_dissipation + outcome.asperity_torque * state.speed;
  // Asperity contact acts normal to the journal surface with friction along it: it does not contribute to the rest.
  const JournalVector journal = bearing.journal_of(state);
  double lever = 0.0;
  for (Eigen::Index i = 0; i < journal.size(); i += 2) {
    lever += journal[i] * of_film[i + 1] - journal[i + 1] * of_film[i];
  }
  outcome.torque_of_moments = outcome.couette_torque + outcome.asperity_torque - 0.5 * (lever + slope);
}

void find_thinnest(const FilmBearing& bearing, const Matrix& H, FilmBearingOutcome& outcome) {
  outcome.thinnest.thickness = outcome.thinnest_crest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
    const FilmPad& pad = bearing.pads[k];
    const ThinnestPlace place = thinnest_place(pad.foil.mesh, part_of(pad, H));
    if (place.thickness < outcome.thinnest.thickness) {
      outcome.thinnest = place;
      outcome.thinnest_pad = static_cast<int>(k);
    }
    for (const int crest : pad.foil.supports) {
      outcome.thinnest_crest = std::min(outcome.thinnest_crest, H.col(pad.first_column + crest).minCoeff());
    }
  }
}

void find_loaded_bumps(const FilmBearing& bearing, const BearingState& state, FilmBearingOutcome& outcome) {
  const Vector loads = bump_loads(bearing, state);
  for (int b = 0; b < loads.size(); ++b) {
    if (loads[b] <= 0.0) continue;
    ++outcome.loaded_bumps;
    if (outcome.first_loaded < 0) outcome.first_loaded = b;
    outcome.last_loaded = b;
  }
}

}  // namespace

FilmBearingOutcome film_bearing_outcome(const FilmBearing& bearing, const BearingState& state) {
  FilmBearingOutcome outcome;
  const JournalVector of_film = find_forces(bearing, state, outcome);
  outcome.eccentricity = state.position.norm() / std::abs(bearing.clearance);
  const double turned =
      std::atan2(state.position.y(), state.position.x()) - std::atan2(outcome.force.y(), outcome.force.x());
  outcome.attitude_angle = wrapped(state.speed < 0.0 ? -turned : turned);
  find_drag(bearing, state, of_film, outcome);
  find_thinnest(bearing, state.film.thickness, outcome);
  outcome.max_pressure = state.film.pressure.maxCoeff();
  outcome.min_pressure = state.film.pressure.minCoeff();
  find_loaded_bumps(bearing, state, outcome);
  return outcome;
}

}  // namespace bumpfoil
