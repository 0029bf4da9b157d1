#include "bearing/rightmost_pole.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "bearing/krylov_space.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Residual |C w - w / (s - shift)| of converged poles, relative to |w / (s - shift)|.
constexpr double pole_tolerance = 1e-10;
/// Directions between computations of Ritz values, and the maximum dimension: 20 to 40 suffice on 6 x 8 and 12 x 16 at
/// 1,000 to 200,000 rpm.
constexpr Eigen::Index between_looks = 10;
constexpr Eigen::Index most_pole_directions = 200;
/// Eigenvalues of C below this fraction of the largest are round-off.
constexpr double eigenvalue_round_off = 1e-9;

/// Identical on all machines.
Vector random_start(Eigen::Index size) {
  std::mt19937 draw(1);
  return Vector::NullaryExpr(size, [&] { return static_cast<double>(draw()) / std::mt19937::max() - 0.5; });
}

/// The rightmost pole of the region in which all poles have converged, if this region is large enough.
std::optional<FilmPole> rightmost_known(const KrylovSpace& space, double frequency) {
  const std::optional<Eigenpairs> ritz = eigenpairs(space.hessenberg());
  if (!ritz) return std::nullopt;
  const Eigen::VectorXcd& theta = ritz->values;
  const Eigen::MatrixXcd& vectors = ritz->vectors;
  std::vector<Eigen::Index> nearest(static_cast<std::size_t>(theta.size()));
  std::iota(nearest.begin(), nearest.end(), Eigen::Index{0});
  std::stable_sort(nearest.begin(), nearest.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return std::abs(theta[a]) > std::abs(theta[b]); });
  const double least = eigenvalue_round_off * std::abs(theta[nearest.front()]);
  const auto unknown = std::find_if(nearest.begin(), nearest.end(), [&](Eigen::Index i) {
    return !(std::abs(theta[i]) > least) ||
           !(space.next() * std::abs(vectors(space.size() - 1, i)) <= pole_tolerance * std::abs(theta[i]));
  });
  if (unknown == nearest.begin()) return std::nullopt;
  const auto excess = [&](Eigen::Index i) { return 1.0 / theta[i]; };
  const Eigen::Index rightmost = *std::max_element(
      nearest.begin(), unknown, [&](Eigen::Index a, Eigen::Index b) { return excess(a).real() < excess(b).real(); });
  const double radius = unknown == nearest.end() ? std::numeric_limits<double>::infinity() : std::abs(excess(*unknown));
  FilmPole pole{.excess = excess(rightmost), .stored = space.basis() * vectors.col(rightmost)};
  pole.covered = std::sqrt(std::max(0.0, radius * radius - pole.excess.real() * pole.excess.real()));
  if (pole.covered < frequency) return std::nullopt;
  if (pole.excess.imag() < 0.0) {
    pole.excess = std::conj(pole.excess);
    pole.stored = pole.stored.conjugate().eval();
  }
  return pole;
}

}  // namespace

std::optional<FilmPole> rightmost_pole(const std::function<Vector(const Vector&)>& stored, Eigen::Index size,
                                       double frequency) {
  KrylovSpace space(random_start(size), std::min(most_pole_directions, size));
  while (space.can_grow()) {
    space.add(stored(space.direction()));
    if (space.can_grow() && space.size() % between_looks != 0) continue;
    if (auto pole = rightmost_known(space, frequency)) return pole;
  }
  return std::nullopt;
}

}  // namespace bumpfoil
