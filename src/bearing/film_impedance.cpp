#include "bearing/film_impedance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/krylov_space.hpp"

namespace bumpfoil {
namespace {

/// Residual that is left in the equation of what is stored, as part of its right-hand side: that is far larger than
/// what slow motions store.
constexpr double tolerance = 1e-12;
/// Directions of a space that is given up: 23 serve 20 frequencies up to twice that of the rotation, on 6 x 16.
constexpr int most_directions = 300;
/// The shift, as part of the largest rate: directions are fewest from 0.15 to 0.3, and a fifth more at 1.
constexpr double shift_in_rates = 0.3;

/// The last of coordinates() while H grows, in 2 m operations each.
class LastCoordinate {
 public:
  LastCoordinate(double start, std::complex<double> excess) : excess_(excess), right_(start) {}

  [[nodiscard]] std::complex<double> excess() const { return excess_; }
  [[nodiscard]] std::complex<double> of(const Eigen::Ref<const Matrix>& H) {
    while (size_ < H.cols()) add_column(size_++, H);
    return right_ / pivot_;
  }

 private:
  /// Of a row from the one below, or the other way round.
  struct Elimination {
    std::complex<double> factor;
    bool swaps{};
  };

  void add_column(Eigen::Index m, const Eigen::Ref<const Matrix>& H) {
    Eigen::VectorXcd column = -excess_ * H.col(m).head(m + 1);
    column[m] += 1.0;
    if (m > 0) {
      const std::complex<double> below = -excess_ * H(m, m - 1);
      const bool swaps = std::norm(below) > std::norm(pivot_);
      eliminated_.push_back({swaps ? pivot_ / below : below / pivot_, swaps});
      if (!swaps) right_ *= -eliminated_.back().factor;
    }
    for (Eigen::Index k = 0; k < m; ++k) {
      const Elimination& last = eliminated_[static_cast<std::size_t>(k)];
      if (last.swaps) std::swap(column[k], column[k + 1]);
      column[k + 1] -= last.factor * column[k];
    }
    pivot_ = column[m];
  }

  std::complex<double> excess_, right_, pivot_;
  Eigen::Index size_{};
  std::vector<Elimination> eliminated_;
};

/// Coordinates of what is stored, in the Krylov basis of C, in which C V = V H + next v_next e_last^T. H has one
/// diagonal below its main one: elimination, with the larger of two rows as pivot, takes m^2 operations.
/// @param start  norm of the right-hand side, which is the first direction
Eigen::VectorXcd coordinates(const Eigen::Ref<const Matrix>& H, double start, std::complex<double> excess) {
  const Eigen::Index m = H.cols();
  Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> system = -excess * H;
  system.diagonal().array() += 1.0;
  Eigen::VectorXcd found = Eigen::VectorXcd::Unit(m, 0) * start;
  for (Eigen::Index k = 0; k + 1 < m; ++k) {
    auto row = system.row(k).tail(m - k);
    auto below = system.row(k + 1).tail(m - k);
    if (std::norm(below[0]) > std::norm(row[0])) {
      row.swap(below);
      std::swap(found[k], found[k + 1]);
    }
    const std::complex<double> factor = below[0] / row[0];
    below -= factor * row;
    found[k + 1] -= factor * found[k];
  }
  system.triangularView<Eigen::Upper>().solveInPlace(found);
  return found;
}

}  // namespace

JournalVectorC ReducedForces::at(std::complex<double> excess) const {
  return moved + excess * (forces * coordinates(hessenberg, start, excess));
}

JournalMatrixC FilmImpedance::at(std::complex<double> rate) const {
  const auto motions = std::ssize(along);
  JournalMatrixC impedance(motions, motions);
  const std::complex<double> excess = squeeze_time * rate - shift;
  for (Eigen::Index i = 0; i < motions; ++i) impedance.col(i) = along[static_cast<std::size_t>(i)].at(excess);
  return impedance;
}

FilmImpedance linear_impedance(const JournalMatrix& stiffness, const JournalMatrix& damping, double unit) {
  // One direction that stores nothing: F = moved + e forces.
  FilmImpedance impedance{.shift = 1.0, .squeeze_time = 1.0 / unit, .along = {}};
  for (Eigen::Index motion = 0; motion < stiffness.cols(); ++motion) {
    const JournalVector forces = unit * damping.col(motion);
    impedance.along.push_back(
        {.moved = stiffness.col(motion) + forces, .start = 1.0, .hessenberg = Matrix::Zero(1, 1), .forces = forces});
  }
  return impedance;
}

ShiftedRates::ShiftedRates(const std::vector<std::complex<double>>& rates, double squeeze_time) {
  double largest = 0.0;
  for (const std::complex<double> rate : rates) largest = std::max(largest, squeeze_time * std::abs(rate));
  shift = shift_in_rates * largest;
  excess.reserve(rates.size());
  for (const std::complex<double> rate : rates) excess.push_back(squeeze_time * rate - shift);
}

Matrix storage_residual(const FilmMesh& mesh, const Eigen::Ref<const Vector>& rates) {
  Matrix residual = mesh.field(0.0);
  mesh.unknown(residual) = mesh.dtheta * mesh.dzeta * rates.reshaped(mesh.unknown_rows(), mesh.unknown_columns());
  for (int j = 0; j <= mesh.rows; ++j) residual.row(j) *= mesh.row_weight(j);
  residual.array().rowwise() *= mesh.weights.transpose().array();
  return residual;
}

std::optional<ReducedForces> reduce_forces(const FilmAnswer& moved,
                                           const std::function<FilmAnswer(const Vector&)>& stored,
                                           const std::vector<std::complex<double>>& excess) {
  const double start = moved.content.norm();
  KrylovSpace space(moved.content, std::min<Eigen::Index>(most_directions, moved.content.size()));
  Matrix forces(moved.force.size(), 0);
  std::vector<LastCoordinate> last;
  last.reserve(excess.size());
  for (const std::complex<double> e : excess) last.emplace_back(start, e);
  const auto solves = [&](LastCoordinate& of_one) {
    return std::abs(of_one.excess() * of_one.of(space.hessenberg())) * space.next() <= tolerance * start;
  };
  while (space.can_grow()) {
    FilmAnswer answer = stored(space.direction());
    space.add(std::move(answer.content));
    forces.conservativeResize(Eigen::NoChange, space.size());
    forces.col(space.size() - 1) = answer.force;
    if (!std::all_of(last.begin(), last.end(), solves)) continue;
    return ReducedForces{.moved = moved.force, .start = start, .hessenberg = space.hessenberg(), .forces = forces};
  }
  return std::nullopt;
}

}  // namespace bumpfoil
