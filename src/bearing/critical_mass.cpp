#include "bumpfoil/bearing/critical_mass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace bumpfoil {
namespace {

/// Number of equal intervals in which both eigenvalues are tracked: in all bearings tested, neither crosses the real
/// axis twice in one.
constexpr int crossing_intervals = 100;
/// Width of the final bracket of a crossing, relative to the highest frequency.
constexpr double crossing_resolution = 1e-11;
constexpr int most_halvings = 60;

using Pair = std::array<std::complex<double>, 2>;

Pair eigenvalues_of(const Eigen::Matrix2cd& Z) {
  const std::complex<double> mean = 0.5 * (Z(0, 0) + Z(1, 1));
  const std::complex<double> half = 0.5 * (Z(0, 0) - Z(1, 1));
  const std::complex<double> root = std::sqrt(half * half + Z(0, 1) * Z(1, 0));
  return {mean + root, mean - root};
}

/// Eigenvalues at `nu`, ordered as the nearest previous ones.
Pair follow_pair(Pair now, const Pair& before) {
  const double kept = std::abs(now[0] - before[0]) + std::abs(now[1] - before[1]);
  const double crossed = std::abs(now[1] - before[0]) + std::abs(now[0] - before[1]);
  if (crossed < kept) std::swap(now[0], now[1]);
  return now;
}

struct Point {
  double frequency{};
  Pair lambda;
};

}  // namespace

std::vector<CriticalMass> critical_masses(const std::function<Eigen::Matrix2cd(double)>& impedance, double lowest,
                                          double highest) {
  const auto next_to = [&](const Point& before, double frequency) {
    return Point{frequency, follow_pair(eigenvalues_of(impedance(frequency)), before.lambda)};
  };
  std::vector<CriticalMass> found;
  Point here{lowest, eigenvalues_of(impedance(lowest))};
  for (int i = 1; i <= crossing_intervals; ++i) {
    const Point there = next_to(here, lowest + (highest - lowest) * i / crossing_intervals);
    for (const std::size_t branch : {std::size_t{0}, std::size_t{1}}) {
      Point a = here;
      Point b = there;
      const auto imaginary = [branch](const Point& point) { return point.lambda.at(branch).imag(); };
      if (imaginary(a) * imaginary(b) > 0.0 || imaginary(b) == 0.0) continue;
      // Regula falsi, with bisection if it stalls; the ends stay on either side of the crossing.
      for (int k = 0; k < most_halvings && b.frequency - a.frequency > crossing_resolution * highest; ++k) {
        const double secant = a.frequency - imaginary(a) * (b.frequency - a.frequency) / (imaginary(b) - imaginary(a));
        const double middle = k % 2 == 0 ? secant : 0.5 * (a.frequency + b.frequency);
        const Point point = next_to(a, middle);
        (imaginary(point) * imaginary(a) > 0.0 ? a : b) = point;
      }
      const Point& end = std::abs(imaginary(a)) < std::abs(imaginary(b)) ? a : b;
      const double mass = end.lambda.at(branch).real() / (end.frequency * end.frequency);
      if (mass > 0.0) found.push_back({mass, end.frequency});
    }
    here = there;
  }
  std::sort(found.begin(), found.end(), [](const CriticalMass& a, const CriticalMass& b) { return a.mass < b.mass; });
  return found;
}

}  // namespace bumpfoil
