#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"

#include "bumpfoil/experiments/build.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace bumpfoil {
namespace {

constexpr double refinement = 1.5;
constexpr int least_columns = 4;
constexpr int least_rows_to_coarsen = 4;

/// @param step  BumpFoil::least_columns_per_pitch()
FilmResolution other_resolution(const FilmResolution& own, int step) {
  const bool coarser = own.columns_per_pitch > std::max(least_columns, step) && own.rows >= least_rows_to_coarsen;
  const double wanted = coarser ? own.columns_per_pitch / refinement : own.columns_per_pitch * refinement;
  const int columns = step * static_cast<int>(std::lround(wanted / step));
  const double ratio = static_cast<double>(columns) / own.columns_per_pitch;
  return {.columns_per_pitch = columns,
          .rows = static_cast<int>(std::lround(ratio * own.rows)),
          .width_modes = own.width_modes,
          .sheet = own.sheet,
          .width = own.width};
}

/// Values at nodes, interpolated linearly to `count` nodes between the same ends, as if both were equidistant.
Vector resampled(const Vector& values, Eigen::Index count) {
  Vector found(count);
  const double stride = static_cast<double>(values.size() - 1) / static_cast<double>(count - 1);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double place = stride * static_cast<double>(i);
    const Eigen::Index before = std::min(static_cast<Eigen::Index>(place), values.size() - 2);
    const double part = place - static_cast<double>(before);
    found[i] = (1.0 - part) * values[before] + part * values[before + 1];
  }
  return found;
}

/// The same for every row of a field.
Matrix resampled(const Matrix& field, Eigen::Index columns) {
  Matrix along(field.rows(), columns);
  for (Eigen::Index j = 0; j < field.rows(); ++j) along.row(j) = resampled(Vector(field.row(j)), columns);
  return along;
}

Matrix resampled(const Matrix& field, Eigen::Index rows, Eigen::Index columns) {
  const Matrix along = resampled(field, columns);
  Matrix found(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k) found.col(k) = resampled(Vector(along.col(k)), rows);
  return found;
}

/// A state of `from` transferred to the mesh of `to`: not a solution there, but close.
BearingState transferred(const BearingModel& from, const BearingModel& to, const BearingState& state) {
  BearingState found = resting(to, from.film->journal_of(state), state.speed, state.clearance_offset);
  found.contacts.gap = state.contacts.gap;
  found.contacts.normal_force = state.contacts.normal_force;
  found.contacts.friction_force = state.contacts.friction_force;
  found.contacts.mode = state.contacts.mode;
  const Eigen::Index from_size = from.problem.K.block_size();
  const Eigen::Index to_size = to.problem.K.block_size();
  const Eigen::Index shared = from.first_pressure();
  const Eigen::Index lines = from.film->pads.front().foil.lines.count();
  const Eigen::Index behind = from_size - from.behind_pressures();
  for (std::size_t k = 0; k < from.film->pads.size(); ++k) {
    const FilmPad& pad = from.film->pads[k];
    const FilmPad& other = to.film->pads[k];
    const FilmMesh& mesh = other.foil.mesh;
    const Eigen::Index columns = mesh.nodes();
    const Matrix pressure = resampled(part_of(pad, state.film.pressure), mesh.rows + 1, columns);
    mesh.unknown(found.film.pressure, other.first_column) = mesh.unknown(pressure);
    found.film.deflection(Eigen::all, other.columns()) = resampled(part_of(pad, state.film.deflection), columns);
    found.film.moment(Eigen::all, other.columns()) = resampled(part_of(pad, state.film.moment), columns);
    found.film.membrane(Eigen::all, other.columns()) = resampled(part_of(pad, state.film.membrane), columns);
    // The last block also has the displacements of the free end.
    for (Eigen::Index b = 0; b <= pad.bumps(); ++b) {
      const Eigen::Index block = pad.first_block + b;
      auto to_block = found.contacts.x.segment(block * to_size, to_size);
      const auto from_block = state.contacts.x.segment(block * from_size, from_size);
      to_block.head(shared + lines) = from_block.head(shared + lines);
      to_block.tail(behind) = from_block.tail(behind);
    }
    for (int i = 0; i < std::ssize(other.foil.supports); ++i) {
      const Eigen::Index first = other.block_of(i) * to_size + to.first_pressure(other.station_of(i));
      const int crest = other.first_column + other.foil.supports[static_cast<std::size_t>(i)];
      const auto over_crest = found.film.pressure.col(crest).segment(mesh.first_unknown_row(), mesh.unknown_rows());
      found.contacts.x.segment(first, mesh.unknown_rows()) = to.film->scales.thickness * (over_crest.array() - 1.0);
    }
  }
  found.film.thickness += to.film->over_the_width(found.film.deflection);
  return found;
}

/// Error of `own` as fraction of its difference from `other`.
double part_of_difference(const FilmResolution& own, const FilmResolution& other) {
  const double r_squared =
      static_cast<double>(own.columns_per_pitch * own.rows) / static_cast<double>(other.columns_per_pitch * other.rows);
  return 1.0 / (r_squared - 1.0);
}

}  // namespace

MeshComparison::MeshComparison(const Case& input, SharedBearing bearing)
    : bearing_(std::move(bearing)), thickness_floor_(thickness_floor(input) / bearing_->film->scales.thickness) {
  const FilmResolution own = resolution_of(input);
  const FilmResolution other = other_resolution(own, input.bump_foil.least_columns_per_pitch());
  other_ = std::make_shared<const BearingModel>(
      make_film_bearing(*bearing_, bearing_->film->scales.gas, other, bearing_->film->surroundings));
  part_ = part_of_difference(own, other);
}

std::optional<MeshError> MeshComparison::estimate(const RunningState& state) const {
  FilmStepper stepper(other_, {.newton = {.thickness_floor = thickness_floor_}});
  BearingState found = transferred(*bearing_, *other_, *state.last);
  if (stepper.advance(state.requested, found).status != Status::converged) return {};
  const double thickness =
      (found.film.thickness.minCoeff() - state.last->film.thickness.minCoeff()) * bearing_->film->scales.thickness;
  Eigen::Vector2d force = journal_force(*other_->film, found.film, found.speed).head<2>() - state.outcome->force;
  if (state.requested.by_load()) {
    if (!state.stiffness) return {};
    force = state.stiffness->topLeftCorner<2, 2>() * (state.last->position - found.position);
  }
  return MeshError{.minimum_film_thickness = std::abs(part_ * thickness), .force = std::abs(part_) * force.norm()};
}

void estimate_mesh_errors(const Case& input, EquilibriumResult& result) {
  const MeshComparison comparison(input, result.bearing);
  for (RunningState& state : result.states) {
    if (state.found()) state.mesh_error = comparison.estimate(state);
  }
}

}  // namespace bumpfoil
