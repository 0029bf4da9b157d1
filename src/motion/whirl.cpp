#include "bumpfoil/motion/whirl.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;
/// Without reduction of rectangular matrices, which dominates compile time.
using SquareSVD = Eigen::JacobiSVD<ComplexMatrix, Eigen::NoQRPreconditioner>;

/// Whirl ratios of the first reduction of the films.
constexpr std::array first_whirl_ratios{0.05, 0.2, 0.4, 0.5, 0.7, 1.0, 1.5, 2.0};  // 1: synchronous
/// Newton's method ends at a step below this fraction of |s|.
constexpr double root_tolerance = 1e-12;
constexpr int most_root_steps = 20;
/// Roots of the refined equation lie within this of the matrix eigenvalues, over |s|; other eigenvalues belong to the
/// films alone.
constexpr double same_root = 1e-4;
/// Largest accepted residual of a root.
constexpr double largest_root_residual = 1e-8;
/// Motions with a smaller share of the rotor are those of foils and films without a force on the journals. The share is
/// the distance, over |s|, of the root from a pole of Z. The reduced films have errors of 1e-10 (find_whirls()), so a
/// closer root may or may not be found. Motions that move a journal have shares of at least 1e-3.
constexpr double least_rotor_share = 1e-9;
/// A smaller imaginary part over |s| is round-off.
constexpr double no_frequency = 1e-9;
/// Final bracket of an onset over the speed, and the growth over the speed that counts as zero.
constexpr double onset_resolution = 1e-10;
constexpr double no_growth = 1e-10;
/// A larger growth over the speed in such a narrow bracket is a jump, not a zero.
constexpr double jumping_growth = 1e-6;
constexpr int most_onset_steps = 40;

/// Rotor and reduced films as a function of s.
class WhirlEquation {
 public:
  WhirlEquation(const Rotor& rotor, double speed, const std::vector<FilmImpedance>& bearings)
      : rotor_(rotor), bearings_(bearings), by_rate_(speed * rotor.gyroscopic + rotor.damping) {
    BUMPFOIL_ASSERT(bearings.size() == rotor.bearings.size());
  }

  /// D(s)
  [[nodiscard]] ComplexMatrix at(Complex s) const { return rotor_part(s) + film_part(s); }
  [[nodiscard]] ComplexMatrix rotor_slope(Complex s) const { return 2.0 * s * rotor_.mass + by_rate_; }
  [[nodiscard]] ComplexMatrix film_slope(Complex s) const {
    ComplexMatrix sum = ComplexMatrix::Zero(rotor_.size(), rotor_.size());
    for (std::size_t i = 0; i < bearings_.size(); ++i) sum += rotor_.bearings[i].on_rotor(bearings_[i].slope(s));
    return sum;
  }

  /// Eigenvalues s of the matrix whose unknowns are film storage, y and T0 s y.
  [[nodiscard]] std::vector<Complex> rates() const {
    const double unit = bearings_.front().squeeze_time;
    Eigen::Index stored = 0;
    for (const FilmImpedance& bearing : bearings_) {
      for (const ReducedForces& forces : bearing.along) stored += forces.hessenberg.rows();
    }
    const Eigen::Index n = rotor_.size();
    const Eigen::Index size = stored + 2 * n;
    // A X = sigma E X, sigma = unit s.
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixXd E = Eigen::MatrixXd::Zero(size, size);
    const Eigen::Index y = stored;
    const Eigen::Index v = stored + n;
    A.block(y, v, n, n).setIdentity();
    E.block(y, y, n, n).setIdentity();
    A.block(v, y, n, n) = -rotor_.stiffness;
    A.block(v, v, n, n) = -by_rate_ / unit;
    E.block(v, v, n, n) = rotor_.mass / (unit * unit);
    Eigen::Index w = 0;
    for (std::size_t i = 0; i < bearings_.size(); ++i) {
      const FilmImpedance& bearing = bearings_[i];
      const double ratio = bearing.squeeze_time / unit;
      const Eigen::MatrixXd B = rotor_.bearings[i].journal();
      for (Eigen::Index motion = 0; motion < B.rows(); ++motion) {
        // (1 - e H) w = e_1 q and F = moved q + e start forces w, where w is in units of `start`.
        const ReducedForces& reduced = bearing.along.at(static_cast<std::size_t>(motion));
        const Eigen::Index m = reduced.hessenberg.rows();
        A.block(w, w, m, m) = Eigen::MatrixXd::Identity(m, m) + bearing.shift * reduced.hessenberg;
        A.block(w, y, 1, n) = -B.row(motion);
        E.block(w, w, m, m) = ratio * reduced.hessenberg;
        const Eigen::MatrixXd forces = reduced.start * transposed_product(B, reduced.forces);
        A.block(v, y, n, n) -= product(transposed_product(B, reduced.moved), B.row(motion));
        A.block(v, w, n, m) = bearing.shift * forces;
        E.block(v, w, n, m) = ratio * forces;
        w += m;
      }
    }
    const double shift = bearings_.front().shift;
    const std::optional<Eigen::VectorXcd> inverses = eigenvalues(solve(A - shift * E, E));
    std::vector<Complex> rates;
    if (!inverses) return rates;
    for (const Complex theta : *inverses) {
      if (theta != 0.0) rates.push_back((shift + 1.0 / theta) / unit);
    }
    return rates;
  }

  /// The root of det D near a rate.
  [[nodiscard]] std::optional<Whirl> refined(Complex s) const {
    Whirl found;
    for (int i = 0; i < most_root_steps; ++i) {
      const SquareSVD svd(at(s), Eigen::ComputeFullU | Eigen::ComputeFullV);
      const Eigen::Index last = rotor_.size() - 1;
      const Eigen::VectorXcd left = svd.matrixU().col(last);
      found.shape = svd.matrixV().col(last);
      const Complex of_rotor = left.dot(rotor_slope(s) * found.shape);
      const Complex of_films = left.dot(film_slope(s) * found.shape);
      found.rate = s;
      found.residual = svd.singularValues()[last] / svd.singularValues()[0];
      found.rotor_share = std::abs(of_rotor) / (std::abs(of_rotor) + std::abs(of_films));
      const Complex step = svd.singularValues()[last] / (of_rotor + of_films);
      if (!std::isfinite(std::abs(step))) return std::nullopt;
      if (std::abs(step) <= root_tolerance * std::abs(s)) return found;
      s -= step;
    }
    return found.residual <= largest_root_residual ? std::optional(found) : std::nullopt;
  }

 private:
  [[nodiscard]] ComplexMatrix rotor_part(Complex s) const {
    return s * s * rotor_.mass + s * by_rate_ + rotor_.stiffness.cast<Complex>();
  }
  [[nodiscard]] ComplexMatrix film_part(Complex s) const {
    ComplexMatrix sum = ComplexMatrix::Zero(rotor_.size(), rotor_.size());
    for (std::size_t i = 0; i < bearings_.size(); ++i) sum += rotor_.bearings[i].on_rotor(bearings_[i].at(s));
    return sum;
  }

  const Rotor& rotor_;
  const std::vector<FilmImpedance>& bearings_;
  Eigen::MatrixXd by_rate_;  ///< Omega G + C
};

/// Whirl::direction
double direction_of(const Rotor& rotor, double speed, const Eigen::VectorXcd& shape) {
  double turned = 0.0;
  double size = 0.0;
  for (const RotorStation& bearing : rotor.bearings) {
    const Eigen::Vector2cd orbit = bearing.orbit(shape);
    // x = cos, y = sin of an increasing angle: conj(X) Y = -i.
    turned -= 2.0 * (std::conj(orbit.x()) * orbit.y()).imag();
    size += orbit.squaredNorm();
  }
  return size > 0.0 ? std::copysign(1.0, speed) * turned / size : 0.0;
}

bool is_inside(const WhirlWindow& window, Complex s) {
  const double highest = s.real() > 0.0 ? window.highest_growing_frequency : window.highest_frequency;
  return s.imag() >= -no_frequency * std::abs(s) && s.imag() <= highest && s.real() >= -window.strongest_decay;
}

std::optional<std::vector<FilmImpedance>> impedances_at(const std::vector<CarryingBearing>& bearings,
                                                        const std::vector<Complex>& rates, bool stuck) {
  std::vector<FilmImpedance> impedances;
  for (const CarryingBearing& bearing : bearings) {
    auto impedance = bearing.stepper.impedance(bearing.state, rates, stuck);
    if (!impedance) return std::nullopt;
    impedances.push_back(std::move(*impedance));
  }
  return impedances;
}

}  // namespace

double Whirl::log_decrement() const {
  if (rate.imag() == 0.0) return std::copysign(std::numeric_limits<double>::infinity(), -rate.real());
  return -2.0 * std::numbers::pi * rate.real() / rate.imag();
}

double Whirl::damping_ratio() const {
  return -rate.real() / std::abs(rate);
}

WhirlWindow usual_window(double speed) {
  return {.highest_frequency = 2.0 * std::abs(speed),
          .strongest_decay = std::abs(speed),
          .highest_growing_frequency = 8.0 * std::abs(speed)};
}

std::vector<Whirl> whirls_on(const Rotor& rotor, double speed, const std::vector<FilmImpedance>& bearings,
                             const WhirlWindow& window) {
  const WhirlEquation equation(rotor, speed, bearings);
  std::vector<Whirl> whirls;
  for (const Complex rate : equation.rates()) {
    if (!is_inside(window, rate)) continue;
    std::optional<Whirl> whirl = equation.refined(rate);
    if (!whirl || std::abs(whirl->rate - rate) > same_root * std::abs(rate)) continue;
    if (whirl->rotor_share < least_rotor_share) continue;
    const Complex s = whirl->rate;
    const bool known = std::any_of(whirls.begin(), whirls.end(), [s](const Whirl& other) {
      return std::abs(other.rate - s) <= same_root * std::abs(s);
    });
    if (known) continue;
    if (std::abs(s.imag()) <= no_frequency * std::abs(s)) whirl->rate = s.real();
    whirl->direction = direction_of(rotor, speed, whirl->shape);
    whirls.push_back(std::move(*whirl));
  }
  std::sort(whirls.begin(), whirls.end(), [](const Whirl& a, const Whirl& b) { return a.rate.real() > b.rate.real(); });
  return whirls;
}

std::optional<FreeMotions> find_whirls(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                       const WhirlWindow& window, bool stuck) {
  const double speed = bearings.front().state.speed;
  std::vector<Complex> rates;
  rates.reserve(first_whirl_ratios.size());
  for (const double ratio : first_whirl_ratios) rates.emplace_back(0.0, ratio * std::abs(speed));
  const auto first = impedances_at(bearings, rates, stuck);
  if (!first) return std::nullopt;
  for (const Whirl& whirl : whirls_on(rotor, speed, *first, window)) rates.push_back(whirl.rate);
  auto second = impedances_at(bearings, rates, stuck);
  if (!second) return std::nullopt;
  std::vector<Whirl> whirls = whirls_on(rotor, speed, *second, window);
  return FreeMotions{std::move(whirls), std::move(*second)};
}

std::vector<Whirl> whirls_on_coefficients(const Rotor& rotor, double speed, const std::vector<FilmImpedance>& bearings,
                                          const WhirlWindow& window) {
  const double frequency = std::abs(speed);
  std::vector<FilmImpedance> linear;
  linear.reserve(bearings.size());
  for (const FilmImpedance& bearing : bearings) {
    const JournalMatrixC Z = bearing.at({0.0, frequency});
    linear.push_back(linear_impedance(Z.real(), Z.imag() / frequency, frequency));
  }
  return whirls_on(rotor, speed, linear, window);
}

std::optional<Onset> find_onset(const std::function<std::optional<std::complex<double>>(double speed)>& rate_at,
                                double from, double to) {
  struct Point {
    double speed{};
    Complex rate;

    [[nodiscard]] double growth() const { return rate.real() / std::abs(speed); }
  };
  const auto point_at = [&](double speed) -> std::optional<Point> {
    const std::optional<Complex> rate = rate_at(speed);
    return rate ? std::optional(Point{speed, *rate}) : std::nullopt;
  };
  std::optional<Point> a = point_at(from);
  std::optional<Point> b = point_at(to);
  if (!a || !b || a->growth() * b->growth() > 0.0) return std::nullopt;
  // Regula falsi; the retained end is halved after two steps on the same side (Illinois).
  double growth_a = a->growth();
  double growth_b = b->growth();
  Point best = std::abs(growth_a) < std::abs(growth_b) ? *a : *b;
  for (int i = 0; i < most_onset_steps && std::abs(b->speed - a->speed) > onset_resolution * std::abs(to) &&
                  std::abs(best.growth()) > no_growth;
       ++i) {
    const auto middle = point_at(a->speed - growth_a * (b->speed - a->speed) / (growth_b - growth_a));
    if (!middle) return std::nullopt;
    best = *middle;
    if (middle->growth() * growth_b > 0.0) {
      growth_a *= 0.5;
    } else {
      a = b;
      growth_a = growth_b;
    }
    b = middle;
    growth_b = middle->growth();
  }
  return Onset{.speed = best.speed,
               .whirl_ratio = best.rate.imag() / std::abs(best.speed),
               .jumps = std::abs(best.growth()) > jumping_growth};
}

}  // namespace bumpfoil
