#include "bumpfoil/film/film_solver.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/core/assert.hpp"
#include "film/pressure_system.hpp"

namespace bumpfoil {
namespace {

constexpr int film_max_halvings = 8;
/// Fraction of the step taken if no halving reduces the residual.
constexpr double film_forced_fraction = 0.25;
/// Step lengths of follow(), as fractions of the path.
constexpr double first_step = 0.25;
constexpr double smallest_step = 1e-4;
constexpr double step_growth = 1.5;
/// The next step grows after a solve with at most this many iterations.
constexpr int few_iterations = 8;

}  // namespace

void add_yield(const Foundation& foundation, const FilmMesh& mesh, const Matrix& excess, Matrix& thickness) {
  if (foundation.kind == FoundationKind::pointwise) thickness += foundation.compliance * excess;
  if (foundation.kind != FoundationKind::axial_mean) return;
  for (Eigen::Index k = 0; k < thickness.cols(); ++k) {
    double mean = 0.0;
    for (int j = 0; j <= mesh.rows; ++j) mean += mesh.row_weight(j) / mesh.rows * excess(j, k);
    thickness.col(k).array() += foundation.compliance * mean;
  }
}

double longest_step(const FilmSolverOptions& options, const FilmState& film, const FilmState& step) {
  double fraction = 1.0;
  const auto keep = [&](const Matrix& value, const Matrix& change) {
    const double deepest = (change.array() / value.array()).minCoeff();
    if (deepest * fraction < options.kept_fraction - 1.0) fraction = (options.kept_fraction - 1.0) / deepest;
  };
  keep(film.pressure, step.pressure);
  keep(film.thickness, step.thickness);
  const double approach = step.thickness.cwiseAbs().maxCoeff();
  return approach * fraction > options.largest_approach ? options.largest_approach / approach : fraction;
}

struct FilmSolver::Workspace {
  Workspace(const FilmMesh& film_mesh, const Foundation& film_foundation, const FilmSolverOptions& solver_options)
      : mesh(film_mesh), foundation(film_foundation), options(solver_options), system(film_mesh) {}

  bool linearise(const ReynoldsEquation& equation);
  double residual_norm() const;
  double try_step(const ReynoldsEquation& equation, double fraction);
  FilmReport solve(const ReynoldsEquation& equation, const Matrix& rigid_thickness, FilmState& film);

  FilmMesh mesh;
  Foundation foundation;
  FilmSolverOptions options;
  PressureSystem system;
  FilmJacobian jacobian;
  Matrix residual;
  FilmState iterate, trial;
  FilmState step;
};

/// Residuals and the factored Jacobian at the iterate.
bool FilmSolver::Workspace::linearise(const ReynoldsEquation& equation) {
  linearise_reynolds(equation, iterate, residual, jacobian);
  system.assemble(jacobian, foundation);
  return system.factor();
}

/// Residuals of the equations alone, per cell area.
double FilmSolver::Workspace::residual_norm() const {
  return mesh.unknown(residual).norm() / (mesh.dtheta * mesh.dzeta);
}

/// Applies a fraction of the step to `trial`; returns the norm of its residuals.
double FilmSolver::Workspace::try_step(const ReynoldsEquation& equation, double fraction) {
  trial.pressure = iterate.pressure + fraction * step.pressure;
  trial.thickness = iterate.thickness + fraction * step.thickness;
  reynolds_residual(equation, trial, residual);
  return residual_norm();
}

FilmReport FilmSolver::Workspace::solve(const ReynoldsEquation& equation, const Matrix& rigid_thickness,
                                        FilmState& film) {
  FilmReport report;
  iterate.pressure = film.pressure;
  iterate.thickness = rigid_thickness;
  add_yield(foundation, mesh, film.pressure - mesh.field(1.0), iterate.thickness);
  if (iterate.thickness.minCoeff() <= 0.0) {
    report.status = Status::no_room;
    return report;
  }
  while (report.iterations < options.max_iterations) {
    ++report.iterations;
    if (!linearise(equation)) return report;
    const double norm = residual_norm();
    report.residual = norm;
    step.pressure.setZero(mesh.rows + 1, mesh.nodes());
    system.solve(residual, step.pressure);
    step.thickness.setZero(mesh.rows + 1, mesh.nodes());
    add_yield(foundation, mesh, step.pressure, step.thickness);
    const double fraction = longest_step(options, iterate, step);
    const double largest = std::max(step.pressure.cwiseAbs().maxCoeff(), step.thickness.cwiseAbs().maxCoeff());
    if (fraction == 1.0 && largest < options.step_tolerance) {
      film.pressure = iterate.pressure + step.pressure;
      film.thickness = iterate.thickness + step.thickness;
      const bool touches = film.thickness.minCoeff() < options.thickness_floor;
      report.status = touches ? Status::touchdown : Status::converged;
      return report;
    }
    double part = fraction;
    int halvings = 0;
    while (!(try_step(equation, part) < norm) && halvings < film_max_halvings) {
      part *= 0.5;
      ++halvings;
    }
    if (halvings == film_max_halvings) try_step(equation, film_forced_fraction * fraction);
    std::swap(iterate, trial);
  }
  return report;
}

FilmSolver::FilmSolver(const FilmMesh& mesh, const Foundation& foundation, const FilmSolverOptions& options)
    : workspace_(std::make_unique<Workspace>(mesh, foundation, options)) {}

FilmSolver::~FilmSolver() = default;

FilmReport& FilmReport::operator+=(const FilmReport& next) {
  status = next.status;
  iterations += next.iterations;
  factorisations += next.factorisations;
  residual = next.residual;
  jumps += next.jumps;
  return *this;
}

FilmReport FilmSolver::solve(const ReynoldsEquation& equation, const Matrix& rigid_thickness, FilmState& film) {
  return workspace_->solve(equation, rigid_thickness, film);
}

FilmReport FilmSolver::follow(const ReynoldsEquation& equation, const Matrix& from, const Matrix& to, FilmState& film) {
  FilmReport total;
  double reached = 0.0;
  double step = first_step;
  while (reached < 1.0) {
    const double next = std::min(1.0, reached + step);
    const FilmReport report = workspace_->solve(equation, from + next * (to - from), film);
    total += report;
    if (report.status == Status::converged) {
      reached = next;
      if (report.iterations <= few_iterations) step *= step_growth;
    } else {
      step *= 0.5;
      if (step < smallest_step) return total;
    }
  }
  return total;
}

}  // namespace bumpfoil
