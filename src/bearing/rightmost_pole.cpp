#include "bearing/rightmost_pole.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Residual |C w - w / (s - shift)| of poles that have converged, as part of |w / (s - shift)|.
constexpr double pole_tolerance = 1e-10;
/// Directions between two looks at the Ritz values.
constexpr Eigen::Index between_looks = 10;
/// Eigenvalues of C below this part of the largest are roundings of none.
constexpr double eigenvalue_round_off = 1e-9;

/// The rightmost of the poles around which all have converged, if these reach far enough.
std::optional<FilmPole> rightmost_known(const KrylovSpace& space, const SchurForm& form, double frequency) {
  std::vector<SchurEigenvalue> nearest = schur_eigenvalues(form.T);
  std::stable_sort(nearest.begin(), nearest.end(), [](const SchurEigenvalue& a, const SchurEigenvalue& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  const double least = eigenvalue_round_off * std::abs(nearest.front().value);
  const Matrix into_next = space.into_next() * form.U;
  FilmPole pole{.excess = -std::numeric_limits<double>::infinity(), .stored = {}};
  double radius = std::numeric_limits<double>::infinity();
  for (const SchurEigenvalue& ritz : nearest) {
    const Complex excess = 1.0 / ritz.value;
    radius = std::abs(excess);
    if (!(std::abs(ritz.value) > least)) break;
    Eigen::VectorXcd vector = eigenvector_of(form.T, ritz);
    if (!((into_next * vector).norm() <= pole_tolerance * std::abs(ritz.value))) break;
    if (excess.real() > pole.excess.real()) {
      pole.excess = excess;
      pole.stored = std::move(vector);
    }
    radius = std::numeric_limits<double>::infinity();
  }
  if (pole.stored.size() == 0) return std::nullopt;
  pole.covered = std::sqrt(std::max(0.0, radius * radius - pole.excess.real() * pole.excess.real()));
  if (pole.covered < frequency) return std::nullopt;
  pole.stored = (space.basis() * (form.U * pole.stored)).eval();
  if (pole.excess.imag() < 0.0) {
    pole.excess = std::conj(pole.excess);
    pole.stored = pole.stored.conjugate().eval();
  }
  return pole;
}

}  // namespace

Vector random_start(Eigen::Index size) {
  std::mt19937 draw(1);
  return Vector::NullaryExpr(size, [&] { return static_cast<double>(draw()) / std::mt19937::max() - 0.5; });
}

std::optional<FilmPole> rightmost_pole(const StoredContents& stored, KrylovSpace space, std::optional<SchurForm> form,
                                       double frequency) {
  Eigen::Index looked = 0;
  while (true) {
    if (form) {
      if (auto pole = rightmost_known(space, *form, frequency)) return pole;
      form.reset();
      looked = space.size();
    }
    const Eigen::Index next = std::min(looked + between_looks, most_pole_directions);
    if (space.size() >= most_pole_directions) return std::nullopt;
    while (space.can_grow() && space.size() < next) {
      const Matrix directions = space.next();
      for (Vector& image : stored({directions.colwise().begin(), directions.colwise().end()})) {
        space.add(std::move(image));
      }
    }
    if (space.size() == looked) return std::nullopt;
    form = schur_form(space.hessenberg());
    if (!form) return std::nullopt;
  }
}

}  // namespace bumpfoil
