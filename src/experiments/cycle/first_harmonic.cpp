#include "bumpfoil/experiments/cycle/first_harmonic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// A part of the loop on which F = constant + slope cos(tau), with the integrals of its basis functions.
struct Piece {
  Eigen::Vector2d constant, slope;
  double one, cosine, sine, cosine_squared, sine_squared, product;
};

/// @param from, to    cos(tau) at both ends
/// @param force, rise  F = force at the start, and its increase to the end
Piece make_piece(double from, double to, const Eigen::Vector2d& force, const Eigen::Vector2d& rise) {
  // dx/dtau = -X sin(tau): the sine is negative as the displacement increases.
  const double sign = to > from ? -1.0 : 1.0;
  const auto sine = [sign](double cosine) { return sign * std::sqrt((1.0 - cosine) * (1.0 + cosine)); };
  const double one = sign * (std::acos(to) - std::acos(from));
  const double double_angle = 0.5 * (sine(to) * to - sine(from) * from);  // sin(2 tau)/4
  Piece piece;
  piece.slope = rise / (to - from);
  piece.constant = force - piece.slope * from;
  piece.one = one;
  piece.cosine = sine(to) - sine(from);
  piece.sine = from - to;
  piece.cosine_squared = 0.5 * one + double_angle;
  piece.sine_squared = 0.5 * one - double_angle;
  piece.product = 0.5 * (from - to) * (from + to);  // sin^2(tau)/2
  return piece;
}

std::vector<Piece> make_pieces(std::span<const LoopPoint> loop, double bottom, double top) {
  // Exact at the turning points, where round-off of the displacement affects tau by its square root.
  const auto cosine = [bottom, top](double displacement) {
    if (displacement == bottom) return -1.0;
    if (displacement == top) return 1.0;
    return std::clamp(((displacement - bottom) - (top - displacement)) / (top - bottom), -1.0, 1.0);
  };
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const double from = cosine(loop[i - 1].displacement);
    const double to = cosine(loop[i].displacement);
    if (from == to) continue;  // a jump takes zero time
    // Subtracting the force at the start avoids cancellation for a small vibration about a large load.
    pieces.push_back(make_piece(from, to, loop[i - 1].force - loop.front().force, loop[i].force - loop[i - 1].force));
  }
  return pieces;
}

}  // namespace

FirstHarmonic orbit_harmonic(std::span<const Eigen::Vector2d> forces, double radius) {
  const auto angle = [n = static_cast<double>(forces.size())](std::size_t k) {
    return 2.0 * std::numbers::pi * static_cast<double>(k) / n;
  };
  const double weight = 2.0 / static_cast<double>(forces.size());
  Eigen::Vector2d mean(0.0, 0.0);
  Eigen::Vector2d in_phase(0.0, 0.0);    // of cos(tau)
  Eigen::Vector2d quadrature(0.0, 0.0);  // of sin(tau)
  for (std::size_t k = 0; k < forces.size(); ++k) {
    // Subtracting the first force avoids cancellation for a small orbit about a large load.
    const Eigen::Vector2d force = weight * (forces[k] - forces.front());
    mean += 0.5 * force;
    in_phase += std::cos(angle(k)) * force;
    quadrature += std::sin(angle(k)) * force;
  }
  double left = 0.0;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    const Eigen::Vector2d force = forces[k] - forces.front();
    left += weight * (force - mean - std::cos(angle(k)) * in_phase - std::sin(angle(k)) * quadrature).squaredNorm();
  }
  const double first = std::sqrt(in_phase.squaredNorm() + quadrature.squaredNorm());
  return {.stiffness = in_phase / radius, .loss = -quadrature / radius, .residual = std::sqrt(left) / first};
}

FirstHarmonic first_harmonic(std::span<const LoopPoint> loop) {
  const auto lower = [](const LoopPoint& a, const LoopPoint& b) { return a.displacement < b.displacement; };
  const auto [lowest, highest] = std::minmax_element(loop.begin(), loop.end(), lower);
  const double amplitude = 0.5 * (highest->displacement - lowest->displacement);
  BUMPFOIL_ASSERT(amplitude > 0.0);
  const std::vector<Piece> pieces = make_pieces(loop, lowest->displacement, highest->displacement);

  Eigen::Vector2d mean(0.0, 0.0);
  Eigen::Vector2d in_phase(0.0, 0.0);    // of cos(tau)
  Eigen::Vector2d quadrature(0.0, 0.0);  // of sin(tau)
  for (const Piece& piece : pieces) {
    mean += piece.constant * piece.one + piece.slope * piece.cosine;
    in_phase += piece.constant * piece.cosine + piece.slope * piece.cosine_squared;
    quadrature += piece.constant * piece.sine + piece.slope * piece.product;
  }
  mean /= 2.0 * std::numbers::pi;
  in_phase /= std::numbers::pi;
  quadrature /= std::numbers::pi;

  // Sums squared deviations rather than subtracting sums of squares: the residual may be as small as round-off.
  double left = 0.0;
  for (const Piece& piece : pieces) {
    const Eigen::Vector2d constant = piece.constant - mean;
    const Eigen::Vector2d slope = piece.slope - in_phase;
    left += constant.squaredNorm() * piece.one + slope.squaredNorm() * piece.cosine_squared +
            quadrature.squaredNorm() * piece.sine_squared +
            2.0 * (constant.dot(slope) * piece.cosine - constant.dot(quadrature) * piece.sine -
                   slope.dot(quadrature) * piece.product);
  }
  const double first = std::sqrt(in_phase.squaredNorm() + quadrature.squaredNorm());
  return {.stiffness = in_phase / amplitude,
          .loss = -quadrature / amplitude,
          .residual = std::sqrt(std::max(left, 0.0) / std::numbers::pi) / first};
}

}  // namespace bumpfoil
