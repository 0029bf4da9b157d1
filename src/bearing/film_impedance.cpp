#include "bearing/film_impedance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/krylov_space.hpp"

namespace bumpfoil {
namespace {

/// Residual that is left in the equation of what is stored, as part of its right-hand side.
constexpr double tolerance = 1e-10;
/// Directions of a space that is given up: 24 serve 20 frequencies up to twice that of the rotation, on 6 x 16.
constexpr int most_directions = 300;

/// Coordinates of what is stored, and the residual of that.
struct Coordinates {
  Eigen::VectorXcd w;
  double residual{};
};

/// In the Krylov basis of C, in which C V = V H + next v_next e_last^T.
/// @param start  norm of the right-hand side, which is the first direction
Coordinates solve(const Eigen::Ref<const Matrix>& H, double start, double next, std::complex<double> excess) {
  const Eigen::Index m = H.cols();
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(m, m) - excess * H.cast<std::complex<double>>();
  Coordinates found;
  found.w = system.partialPivLu().solve(Eigen::VectorXcd::Unit(m, 0) * start);
  found.residual = std::abs(excess * found.w[m - 1]) * next;
  return found;
}

}  // namespace

std::optional<std::vector<Eigen::Vector2cd>> film_forces(const FilmAnswer& moved,
                                                         const std::function<FilmAnswer(const Vector&)>& stored,
                                                         const std::vector<std::complex<double>>& excess) {
  const double start = moved.content.norm();
  KrylovSpace space(moved.content, std::min<Eigen::Index>(most_directions, moved.content.size()));
  Eigen::Matrix2Xd forces(2, 0);
  while (space.can_grow()) {
    FilmAnswer answer = stored(space.direction());
    space.add(std::move(answer.content));
    forces.conservativeResize(Eigen::NoChange, space.size());
    forces.col(space.size() - 1) = answer.force;
    std::vector<Eigen::Vector2cd> found;
    found.reserve(excess.size());
    for (const std::complex<double> e : excess) {
      const Coordinates coordinates = solve(space.hessenberg(), start, space.next(), e);
      if (!(coordinates.residual <= tolerance * start)) break;
      found.emplace_back(moved.force + e * (forces * coordinates.w));
    }
    if (found.size() == excess.size()) return found;
  }
  return std::nullopt;
}

}  // namespace bumpfoil
