#include "bearing/wall_impedance.hpp"

#include "bearing/film_impedance.hpp"
#include "film/pressure_system.hpp"

namespace bumpfoil {
namespace {

/// A film over a wall, linearised with storage proportional to P H at a real rate.
class LinearWallFilm {
 public:
  LinearWallFilm(const FilmModel& model, const Foundation& foundation, const FilmState& film)
      : model_(model), mesh_(model.pads.front().foil.mesh), foundation_(foundation), film_(film), system_(mesh_) {}

  /// @param shift  the rate, in units of 1 / T0. @return whether the equations are regular there
  bool linearise(double speed, double shift) {
    FilmEquations equations = film_equations(model_, speed);
    squeeze(model_, shift, film_content(film_), equations);
    linearise_reynolds(equations.front(), film_, residual_, jacobian_);
    system_.assemble(jacobian_, foundation_);
    return system_.factor();
  }

  /// The response to a change of H by the journal alone.
  FilmAnswer moved(const Matrix& rigid) {
    residual_ = stencil_product(mesh_, jacobian_.by_thickness, rigid);
    return answer(rigid);
  }

  /// The response to storage rates at the nodes of unknown pressure.
  FilmAnswer stored(const Vector& rates) {
    residual_ = storage_residual(mesh_, rates);
    return answer(mesh_.field(0.0));
  }

 private:
  FilmAnswer answer(const Matrix& rigid) {
    Matrix pressure = mesh_.field(0.0);
    system_.solve(residual_, pressure);
    Matrix thickness = rigid;
    add_yield(foundation_, mesh_, pressure, thickness);
    const Matrix content = pressure.cwiseProduct(film_.thickness) + film_.pressure.cwiseProduct(thickness);
    return {.content = mesh_.unknown(content).reshaped(), .force = film_force(model_, model_.field(1.0) + pressure)};
  }

  const FilmModel& model_;
  const FilmMesh& mesh_;
  const Foundation& foundation_;
  const FilmState& film_;
  PressureSystem system_;
  FilmJacobian jacobian_;
  Matrix residual_;
};

}  // namespace

std::optional<FilmImpedance> wall_impedance(const FilmModel& model, const Foundation& foundation,
                                            const BearingState& state, const std::vector<std::complex<double>>& rates) {
  const double T0 = model.scales.squeeze_time();
  const ShiftedRates shifted(rates, T0);
  FilmImpedance found{.shift = shifted.shift, .squeeze_time = T0, .along = {}};
  LinearWallFilm film(model, foundation, state.film);
  if (!film.linearise(state.speed, found.shift)) return std::nullopt;
  std::vector<FilmAnswer> moved;
  moved.reserve(static_cast<std::size_t>(model.motions()));
  for (Eigen::Index motion = 0; motion < model.motions(); ++motion) {
    moved.push_back(film.moved(model.thickness_change(JournalVector::Unit(model.motions(), motion))));
  }
  const auto stored = [&](const std::vector<Vector>& directions) {
    std::vector<FilmAnswer> answers;
    answers.reserve(directions.size());
    for (const Vector& direction : directions) answers.push_back(film.stored(direction));
    return answers;
  };
  auto reduced = reduce_forces(moved, stored, shifted.excess);
  if (!reduced) return std::nullopt;
  found.along = std::move(*reduced);
  return found;
}

}  // namespace bumpfoil
