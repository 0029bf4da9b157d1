#include "bearing/film_impedance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bumpfoil {
namespace {

/// Residual that is left in the equation of what is stored, as part of its right-hand side: that is far larger than
/// what slow motions store.
constexpr double tolerance = 1e-12;
/// Directions of a space that is given up: 40 serve 20 frequencies up to twice that of the rotation, on 6 x 16.
constexpr int most_directions = 300;
/// Of the directions that are expected to be missing, this part is added before the next look, but no more than so
/// many.
constexpr double most_trusted = 0.7;
constexpr double most_at_once = 10.0;
/// The shift, as part of the largest rate: directions are fewest from 0.15 to 0.3, and a fifth more at 1.
constexpr double shift_in_rates = 0.3;

using Complex = std::complex<double>;

/// The solution of (1 - e H) w = start in the directions of a space, by elimination with the largest of the rows that
/// there are below as pivot.
Eigen::MatrixXcd galerkin_solution(const KrylovSpace& space, Complex excess) {
  const Eigen::Index m = space.size();
  const Eigen::Index motions = space.start().cols();
  Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> system(m, m + motions);
  system.leftCols(m) = -excess * space.hessenberg();
  system.diagonal().array() += 1.0;
  system.rightCols(motions) = space.start_of_all();
  for (Eigen::Index k = 0; k + 1 < m; ++k) {
    auto open = system.block(k, k, std::min(motions + 1, m - k), system.cols() - k);
    Eigen::Index pivot = 0;
    open.col(0).cwiseAbs2().maxCoeff(&pivot);
    if (pivot > 0) open.row(0).swap(open.row(pivot));
    for (Eigen::Index i = 1; i < open.rows(); ++i) {
      const Complex factor = open(i, 0) / open(0, 0);
      open.row(i) -= factor * open.row(0);
    }
  }
  Eigen::MatrixXcd found = system.rightCols(motions);
  system.leftCols(m).triangularView<Eigen::Upper>().solveInPlace(found);
  return found;
}

/// The largest of the residuals that a solution leaves in all motions, as part of the right-hand side.
/// @param into_next  what it makes of the next directions
double residual_of(const Eigen::MatrixXcd& solution, const Matrix& into_next, const KrylovSpace& space,
                   Complex excess) {
  const Eigen::MatrixXcd left = excess * (into_next * solution);
  double largest = 0.0;
  for (Eigen::Index i = 0; i < solution.cols(); ++i) {
    if (!solution.col(i).allFinite()) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, left.col(i).norm() / space.start().col(i).norm());
  }
  return largest;
}

/// After how many directions to look at a residual again that falls by equal parts with each.
class NextLook {
 public:
  [[nodiscard]] bool is_at(Eigen::Index size) const { return size >= next_; }
  void see(Eigen::Index size, double residual) {
    const double fall = std::log(last_residual_ / residual) / static_cast<double>(size - last_size_);
    const double missing = std::log(residual / tolerance);
    next_ = size;
    if (fall > 0.0) next_ += static_cast<Eigen::Index>(std::clamp(most_trusted * missing / fall, 0.0, most_at_once));
    last_size_ = size;
    last_residual_ = residual;
  }

 private:
  Eigen::Index next_{}, last_size_{};
  double last_residual_{1.0};
};

/// Brings H to Schur's form, and all that is said of directions with it.
bool transform(const KrylovSpace& space, const Matrix& forces, FilmReduction& reduction) {
  auto form = schur_form(space.hessenberg());
  if (!form) return false;
  reduction.impedance.start = form->U.transpose() * space.start_of_all();
  reduction.impedance.forces = forces * form->U;
  reduction.impedance.schur = std::move(form->T);
  reduction.U = std::move(form->U);
  return true;
}

}  // namespace

Eigen::MatrixXcd FilmImpedance::stored(Complex excess) const {
  return solve_shifted(schur, excess, start.cast<Complex>());
}

JournalMatrixC FilmImpedance::at(Complex rate) const {
  const Complex excess = squeeze_time * rate - shift;
  return moved + excess * (forces * stored(excess));
}

FilmImpedance linear_impedance(const JournalMatrix& stiffness, const JournalMatrix& damping, double unit) {
  // What is stored makes nothing else be stored: F = (moved + e forces) q.
  const Eigen::Index motions = stiffness.cols();
  return {.shift = 1.0,
          .squeeze_time = 1.0 / unit,
          .moved = stiffness + unit * damping,
          .start = Matrix::Identity(motions, motions),
          .schur = Matrix::Zero(motions, motions),
          .forces = unit * damping};
}

ShiftedRates::ShiftedRates(const std::vector<Complex>& rates, double T0) : squeeze_time(T0) {
  double largest = 0.0;
  for (const Complex rate : rates) largest = std::max(largest, squeeze_time * std::abs(rate));
  shift = shift_in_rates * largest;
  excess.reserve(rates.size());
  for (const Complex rate : rates) excess.push_back(squeeze_time * rate - shift);
}

Matrix storage_residual(const FilmMesh& mesh, const Eigen::Ref<const Vector>& rates) {
  Matrix residual = mesh.field(0.0);
  mesh.unknown(residual) = mesh.dtheta * mesh.dzeta * rates.reshaped(mesh.unknown_rows(), mesh.unknown_columns());
  for (int j = 0; j <= mesh.rows; ++j) residual.row(j) *= mesh.row_weight(j);
  residual.array().rowwise() *= mesh.weights.transpose().array();
  return residual;
}

std::optional<FilmReduction> reduce_forces(const std::vector<FilmAnswer>& moved, const StoredAnswers& stored,
                                           const ShiftedRates& at) {
  const auto motions = std::ssize(moved);
  const Eigen::Index size = moved.front().content.size();
  Matrix contents(size, motions);
  JournalMatrix moved_forces(moved.front().force.size(), motions);
  for (Eigen::Index i = 0; i < motions; ++i) {
    contents.col(i) = moved[static_cast<std::size_t>(i)].content;
    moved_forces.col(i) = moved[static_cast<std::size_t>(i)].force;
  }
  FilmReduction found{.impedance = {.shift = at.shift, .squeeze_time = at.squeeze_time, .moved = moved_forces},
                      .space = KrylovSpace(contents, std::min<Eigen::Index>(most_directions, size))};
  KrylovSpace& space = found.space;
  Matrix forces(moved_forces.rows(), 0);
  NextLook look;
  bool solved = false;
  while (!solved) {
    if (!space.can_grow()) return std::nullopt;
    const Matrix directions = space.next();
    for (FilmAnswer& answer : stored({directions.colwise().begin(), directions.colwise().end()})) {
      space.add(std::move(answer.content));
      forces.conservativeResize(Eigen::NoChange, space.size());
      forces.rightCols(1) = answer.force;
    }
    // The first is met last as a rule: the others are looked at from there on.
    if (!at.excess.empty()) {
      if (!look.is_at(space.size()) && space.can_grow()) continue;
      const Complex first = at.excess.front();
      const double residual = residual_of(galerkin_solution(space, first), space.into_next(), space, first);
      look.see(space.size(), residual);
      if (residual > tolerance) continue;
    }
    if (!transform(space, forces, found)) continue;
    const Matrix into_next = space.into_next() * found.U;
    solved = std::all_of(at.excess.begin(), at.excess.end(), [&](Complex e) {
      return residual_of(found.impedance.stored(e), into_next, space, e) <= tolerance;
    });
  }
  return found;
}

}  // namespace bumpfoil
