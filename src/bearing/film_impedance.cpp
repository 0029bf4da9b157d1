#include "bearing/film_impedance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/krylov_space.hpp"

namespace bumpfoil {
namespace {

/// Accepted residual of the storage equation relative to its right-hand side, which is far larger than the storage of
/// slow motion.
constexpr double krylov_tolerance = 1e-12;
/// Maximum dimension of the space: 23 suffice for 20 frequencies up to twice that of rotation, on 6 x 16.
constexpr int most_directions = 300;
/// The shift relative to the largest rate: dimensions are fewest from 0.15 to 0.3, and 20 % more at 1.
constexpr double shift_in_rates = 0.3;

/// The last entry of coordinates() while H grows, in 2 m operations each.
class LastCoordinate {
 public:
  LastCoordinate(double start, std::complex<double> excess) : excess_(excess), right_(start) {}

  [[nodiscard]] std::complex<double> excess() const { return excess_; }
  [[nodiscard]] std::complex<double> of(const Eigen::Ref<const Matrix>& H) {
    while (size_ < H.cols()) add_column(size_++, H);
    return right_ / pivot_;
  }

 private:
  /// Elimination of a row by the one below, or vice versa.
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

/// Coordinates of the storage rates in the Krylov basis of C, in which C V = V H + next v_next e_last^T. H is upper
/// Hessenberg: elimination with pivoting between two rows takes m^2 operations.
/// @param found  in: coordinates of the right-hand side
Eigen::VectorXcd coordinates(const Eigen::Ref<const Matrix>& H, Eigen::VectorXcd found, std::complex<double> excess) {
  const Eigen::Index m = H.cols();
  Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> system = -excess * H;
  system.diagonal().array() += 1.0;
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

/// w of ReducedForces
Eigen::VectorXcd stored_rates(const ReducedForces& reduced, std::complex<double> excess) {
  return coordinates(reduced.hessenberg, Eigen::VectorXcd::Unit(reduced.hessenberg.rows(), 0) * reduced.start, excess);
}

/// What ReducedForces say of each motion, as columns.
JournalMatrixC by_motion(const FilmImpedance& film, std::complex<double> rate,
                         JournalVectorC (ReducedForces::*said)(std::complex<double>) const) {
  const auto motions = std::ssize(film.along);
  JournalMatrixC columns(motions, motions);
  const std::complex<double> excess = film.squeeze_time * rate - film.shift;
  for (Eigen::Index i = 0; i < motions; ++i) columns.col(i) = (film.along[static_cast<std::size_t>(i)].*said)(excess);
  return columns;
}

/// The space of one motion while it grows.
class Reduction {
 public:
  Reduction(const FilmAnswer& moved, const std::vector<std::complex<double>>& excess)
      : start_(moved.content.norm()),
        moved_(moved.force),
        space_(moved.content, std::min<Eigen::Index>(most_directions, moved.content.size())),
        forces_(moved.force.size(), 0) {
    last_.reserve(excess.size());
    for (const std::complex<double> e : excess) last_.emplace_back(start_, e);
  }

  [[nodiscard]] bool can_grow() const { return space_.can_grow(); }
  [[nodiscard]] auto direction() const { return space_.direction(); }
  /// @param answer  response to direction()
  void add(FilmAnswer answer) {
    space_.add(std::move(answer.content));
    forces_.conservativeResize(Eigen::NoChange, space_.size());
    forces_.col(space_.size() - 1) = answer.force;
  }
  /// Whether the residual is small at all requested s.
  [[nodiscard]] bool solves() {
    return std::all_of(last_.begin(), last_.end(), [&](LastCoordinate& of_one) {
      return std::abs(of_one.excess() * of_one.of(space_.hessenberg())) * space_.next() <= krylov_tolerance * start_;
    });
  }
  [[nodiscard]] ReducedForces forces() const {
    return {.moved = moved_, .start = start_, .hessenberg = space_.hessenberg(), .forces = forces_};
  }

 private:
  double start_;
  JournalVector moved_;
  KrylovSpace space_;
  Matrix forces_;
  std::vector<LastCoordinate> last_;
};

}  // namespace

JournalVectorC ReducedForces::at(std::complex<double> excess) const {
  return moved + excess * (forces * stored_rates(*this, excess));
}

JournalVectorC ReducedForces::slope(std::complex<double> excess) const {
  return forces * coordinates(hessenberg, stored_rates(*this, excess), excess);
}

JournalMatrixC FilmImpedance::at(std::complex<double> rate) const {
  return by_motion(*this, rate, &ReducedForces::at);
}

JournalMatrixC FilmImpedance::slope(std::complex<double> rate) const {
  return squeeze_time * by_motion(*this, rate, &ReducedForces::slope);
}

FilmImpedance linear_impedance(const JournalMatrix& stiffness, const JournalMatrix& damping, double unit) {
  // A single direction without storage: F = moved + e forces.
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

std::optional<std::vector<ReducedForces>> reduce_forces(
    const std::vector<FilmAnswer>& moved,
    const std::function<std::vector<FilmAnswer>(const std::vector<Vector>& rates)>& stored,
    const std::vector<std::complex<double>>& excess) {
  std::vector<Reduction> reductions;
  reductions.reserve(moved.size());
  for (const FilmAnswer& of_motion : moved) reductions.emplace_back(of_motion, excess);
  std::vector<Reduction*> growing;
  growing.reserve(reductions.size());
  for (Reduction& reduction : reductions) growing.push_back(&reduction);
  std::vector<Vector> directions;
  while (!growing.empty()) {
    directions.clear();
    for (const Reduction* reduction : growing) {
      if (!reduction->can_grow()) return std::nullopt;
      directions.emplace_back(reduction->direction());
    }
    std::vector<FilmAnswer> answers = stored(directions);
    for (std::size_t i = 0; i < growing.size(); ++i) growing[i]->add(std::move(answers[i]));
    std::erase_if(growing, [](Reduction* reduction) { return reduction->solves(); });
  }
  std::vector<ReducedForces> found;
  found.reserve(reductions.size());
  for (const Reduction& reduction : reductions) found.push_back(reduction.forces());
  return found;
}

}  // namespace bumpfoil
