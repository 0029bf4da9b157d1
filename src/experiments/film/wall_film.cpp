#include "bumpfoil/experiments/film/wall_film.hpp"

#include <chrono>
#include <numbers>

#include "bearing/wall_impedance.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"
#include "experiments/equilibrium/small_motions.hpp"

namespace bumpfoil {
namespace {

Foundation foundation_of(const Case& input, const FilmScales& scales) {
  Foundation foundation;
  switch (input.film.wall) {
    case FilmWall::rigid:
      return foundation;
    case FilmWall::springs:
      foundation.kind = FoundationKind::pointwise;
      break;
    case FilmWall::rigid_across:
      foundation.kind = FoundationKind::axial_mean;
      break;
  }
  foundation.compliance = scales.gas.ambient_pressure / (scales.thickness * *input.film.wall_stiffness);
  return foundation;
}

/// Stiffness, small motions and critical mass.
void find_motions(const BearingModel& bearing, const Foundation& foundation, const EquilibriumSettings& settings,
                  RunningState& found) {
  const double speed = found.last->speed;
  std::vector<std::complex<double>> rates = whirling_rates(speed);
  rates.emplace_back(0.0, 0.0);
  const std::vector<double> frequencies = frequencies_of(settings, speed);
  for (const double frequency : frequencies) rates.emplace_back(0.0, frequency);
  const std::optional<FilmImpedance> impedance = wall_impedance(*bearing.film, foundation, *found.last, rates);
  if (!impedance) return;
  found.stiffness = bearing.film->by_slopes(JournalMatrix(impedance->at(0.0).real()));
  for (const double frequency : frequencies) {
    found.whirls.push_back({.frequency = frequency,
                            .impedance = bearing.film->by_slopes(impedance->at({0.0, frequency})),
                            .stuck_impedance = {}});
  }
  found.critical_mass = least_critical_mass(*impedance, speed);
}

/// Computes one film, starting from the centred journal.
FilmReport find_film(FilmSolver& solver, const ReynoldsEquation& equation, const BearingModel& bearing,
                     BearingState& state) {
  const Matrix centred = undeformed_thickness(bearing, Eigen::Vector2d::Zero());
  const Matrix there = undeformed_thickness(bearing, bearing.film->journal_of(state));
  FilmReport report = solver.solve(equation, centred, state.film);
  if (report.status != Status::converged) return report;
  return report += solver.follow(equation, centred, there, state.film);
}

}  // namespace

BearingModel make_wall_bearing(const Case& input) {
  require_bearing(input, {"film"});
  const double R = input.bearing.radius;
  const double half_width = 0.5 * input.bearing.axial_length / R;
  const int columns = input.bump_foil.bumps * input.film.columns_per_pitch;
  BearingModel bearing;
  FilmModel& film = bearing.film.emplace();
  film.scales = {gas_of(input.gas), R, film_thickness_scale(input.bearing.radial_clearance)};
  bearing.placed = place_pads(input);
  FilmPad& pad = film.pads.emplace_back();
  const WidthPart width = resolution_of(input).width;
  const int rows = width == WidthPart::half ? input.film.rows : 2 * input.film.rows;
  pad.foil.mesh = input.film.closed ? make_closed_mesh(columns, rows, half_width, width)
                                    : make_slotted_mesh(columns, rows, half_width, bearing.placed.front().arc, width);
  film.surroundings = surroundings_of(input, input.gas.ambient_pressure);
  pad.wrap_sign = bearing.placed.front().sense();
  bearing.clearance = input.bearing.radial_clearance;
  const Vector angles = pad.foil.mesh.angles();
  film.column_normals = outward_normals(bearing.placed.front().polar(angles));
  film.sleeve = sleeve_deviations(input, angles);
  return bearing;
}

EquilibriumResult run_wall_films(const Case& input, const std::function<bool(double)>& progress) {
  EquilibriumResult result;
  result.bearing = std::make_shared<const BearingModel>(make_wall_bearing(input));
  const BearingModel& bearing = *result.bearing;
  const FilmModel& film = *bearing.film;
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  const std::size_t count = equilibrium.speeds.size() * equilibrium.positions.size();
  const Foundation foundation = foundation_of(input, film.scales);
  FilmSolver solver(film.pads.front().foil.mesh, foundation,
                    {.thickness_floor = input.film.h_floor / film.scales.thickness});
  for (const double speed : equilibrium.speeds) {
    for (const Eigen::Vector2d& position : equilibrium.positions) {
      RunningState& found = result.states.emplace_back();
      found.path = FilmPath::position_ray;
      found.requested = OperatingPoint::held_at({position[0], position[1]}, speed);
      const double done = static_cast<double>(result.states.size() - 1);
      if (progress && !progress(done / static_cast<double>(count))) {
        found.report.status = Status::interrupted;
        return result;
      }
      const auto begin = std::chrono::steady_clock::now();
      BearingState state;
      state.position = found.requested.journal;
      state.tilt = film.surroundings.tilt.value;
      state.speed = speed;
      const Matrix undeformed = Matrix::Zero(1, film.columns());
      state.film = {{film.resting_pressure(), {}}, undeformed, undeformed, Matrix::Zero(0, film.columns())};
      found.report = find_film(solver, film_equation(film, film.pads.front(), speed), bearing, state);
      found.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      if (!found.found()) continue;
      found.outcome = film_bearing_outcome(bearing, state);
      found.last = std::move(state);
      find_motions(bearing, foundation, equilibrium, found);
    }
  }
  return result;
}

}  // namespace bumpfoil
