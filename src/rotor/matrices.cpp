#include "bumpfoil/rotor/matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

using Entries = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// Accepted asymmetry of opposite entries, relative to the diagonal entries of both unknowns: files have limited
/// digits.
constexpr double same_entry = 1e-6;
/// Smallest eigenvalues of a matrix scaled to a unit diagonal: round-off of a semidefinite one, and the minimum of a
/// definite one. (A held beam of 75 elements has 1e-7.)
constexpr double least_eigenvalue = -1e-9;
constexpr double least_positive = 1e-13;
/// Energy of a rigid motion, relative to that of its parts, that counts as zero.
constexpr double no_energy = 1e-7;
/// Accepted error of a position relative to that of its tilt, as fraction of the distance of the bearings.
constexpr double same_place_of_tilt = 1e-5;

Eigen::Index unknowns_of(const RotorMatrices& matrices) {
  return std::lround(std::sqrt(static_cast<double>(matrices.mass.size())));
}

Entries entries_of(const std::vector<double>& rows, Eigen::Index n) {
  return {rows.data(), n, n};
}

/// 1 / sqrt of the diagonal, which scales it to ones; 1 for zero entries.
Eigen::VectorXd diagonal_scale(const Eigen::MatrixXd& A) {
  return A.diagonal().unaryExpr([](double entry) { return entry > 0.0 ? 1.0 / std::sqrt(entry) : 1.0; });
}

double least_scaled_eigenvalue(const Eigen::MatrixXd& A) {
  if (A.rows() == 0) return 1.0;
  const Eigen::VectorXd scale = diagonal_scale(A);
  return symmetric_eigenvalues(scale.asDiagonal() * A * scale.asDiagonal())[0];
}

/// Indices of the bearing unknowns, x and y of each bearing in turn, and of all others.
std::pair<std::vector<Eigen::Index>, std::vector<Eigen::Index>> split_unknowns(const RotorMatrices& matrices) {
  std::vector<Eigen::Index> held;
  for (const MatrixPlace& bearing : matrices.bearings) {
    held.push_back(bearing.x);
    held.push_back(bearing.y);
  }
  std::vector<Eigen::Index> rest;
  for (Eigen::Index i = 0; i < unknowns_of(matrices); ++i) {
    if (std::find(held.begin(), held.end(), i) == held.end()) rest.push_back(i);
  }
  return {held, rest};
}

/// Rigid motions, see Rotor::rigid: prescribed at the bearings, and the other unknowns follow.
Eigen::MatrixXd rigid_motions(const RotorMatrices& matrices) {
  const Eigen::MatrixXd K = entries_of(matrices.stiffness, unknowns_of(matrices));
  const auto [held, rest] = split_unknowns(matrices);
  Eigen::MatrixXd places(static_cast<Eigen::Index>(held.size()), 4);
  for (std::size_t i = 0; i < matrices.bearings.size(); ++i) {
    places.middleRows<2>(2 * static_cast<Eigen::Index>(i)) << Eigen::Matrix2d::Identity(),
        matrices.bearings[i].z * Eigen::Matrix2d::Identity();
  }
  Eigen::MatrixXd rigid(K.rows(), 4);
  rigid(held, Eigen::all) = places;
  if (rest.empty()) return rigid;
  const Eigen::MatrixXd inner = K(rest, rest);
  const Eigen::VectorXd scale = diagonal_scale(inner);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * inner * scale.asDiagonal();
  const Eigen::MatrixXd pushed = scale.asDiagonal() * product(K(rest, held), places);
  rigid(rest, Eigen::all) = -(scale.asDiagonal() * solve_symmetric(scaled, pushed));
  return rigid;
}

/// Checks matrices step by step: an invalid matrix is excluded from comparisons with others.
class MatrixCheck {
 public:
  explicit MatrixCheck(const RotorMatrices& matrices) : matrices_(matrices), n_(unknowns_of(matrices)) {}

  std::vector<InputError> errors() {
    if (sizes() && places() && numbers() && symmetries() && stiffness()) rigid();
    return std::move(errors_);
  }

 private:
  bool require(bool right, std::string key, std::string value, std::string what, std::string advice) {
    if (!right) errors_.push_back({"", 0, std::move(key), std::move(value), std::move(what), std::move(advice)});
    return right;
  }

  bool sizes() {
    const std::size_t count = matrices_.mass.size();
    bool right = require(count > 0 && static_cast<std::size_t>(n_ * n_) == count, "M", fmt::format("{} numbers", count),
                         "are not a square matrix", "give n rows of n numbers");
    right = right && require(n_ >= 4, "M", fmt::format("{} rows", n_), "are too few for a rotor that tilts",
                             "give a matrix with the displacements at two bearings among its unknowns");
    right = right && require(n_ <= most_rotor_unknowns, "M", fmt::format("{} rows", n_), "are too many",
                             fmt::format("give at most {}: reduce the rotor", most_rotor_unknowns));
    if (!right) return false;
    for (const auto& [key, rows] : others_) {
      right &= require(rows->size() == count, std::string(key), fmt::format("{} numbers", rows->size()),
                       fmt::format("are not the {0} x {0} of M", n_), "give as many rows and columns as M has");
    }
    return right;
  }

  bool places() {
    bool right = require(matrices_.bearings.size() == 2, "bearing", fmt::format("{}", matrices_.bearings.size()),
                         "is not the number of bearings of a rotor", "give two");
    std::set<std::string> names;
    std::set<int> unknowns;
    const auto check = [&](const MatrixPlace& place, const std::string& key) {
      right &= require(!place.name.empty() && names.insert(place.name).second, key + ".name", place.name,
                       place.name.empty() ? "is empty" : "is given twice", "give each position a unique name");
      right &= require(std::isfinite(place.z), key + ".z", fmt::format("{}", place.z), "is not finite",
                       "give a place along the axis, m");
      for (const auto& [axis, number] : {std::pair(".x", place.x), std::pair(".y", place.y)}) {
        right &= require(number >= 0 && number < n_, key + axis, fmt::format("{}", number), "is not an unknown of M",
                         fmt::format("give the number of its row, from 0 to {}", n_ - 1));
      }
      right &= require(place.x != place.y, key + ".y", fmt::format("{}", place.y), "is the unknown along X, too",
                       "give the number of the displacement along Y");
    };
    for (std::size_t i = 0; i < matrices_.bearings.size(); ++i) {
      const MatrixPlace& bearing = matrices_.bearings[i];
      check(bearing, fmt::format("bearing[{}]", i + 1));
      for (const auto& [axis, number] : {std::pair("x", bearing.x), std::pair("y", bearing.y)}) {
        right &= require(unknowns.insert(number).second || bearing.x == bearing.y,
                         fmt::format("bearing[{}].{}", i + 1, axis), fmt::format("{}", number),
                         "is an unknown of another bearing", "give every bearing its own unknowns");
      }
    }
    for (std::size_t i = 0; i < matrices_.stations.size(); ++i) {
      check(matrices_.stations[i], fmt::format("station[{}]", i + 1));
    }
    return right && require(matrices_.bearings[0].z != matrices_.bearings[1].z, "bearing[2].z",
                            fmt::format("{} m", matrices_.bearings[1].z), "is that of the first bearing",
                            "give two different places");
  }

  bool numbers() {
    bool right = true;
    for (const auto& [key, rows] : all_) {
      const auto wrong = std::find_if(rows->begin(), rows->end(), [](double one) { return !std::isfinite(one); });
      const auto at = wrong - rows->begin();
      right &= require(wrong == rows->end(), fmt::format("{}[{}][{}]", key, at / n_ + 1, at % n_ + 1), "",
                       "is not finite", "give a finite number");
    }
    return right;
  }

  /// @param sign  of an entry relative to its opposite
  bool symmetric(std::string_view key, const std::vector<double>& rows, double sign) {
    const Entries A = entries_of(rows, n_);
    // For a matrix without a diagonal, the largest entry is the reference.
    const double largest = A.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < n_; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        const double scale = sign > 0.0 ? std::sqrt(std::abs(A(i, i) * A(j, j))) : 1e-3 * largest;
        const double error = std::abs(A(i, j) - sign * A(j, i));
        if (error <= same_entry * std::max(scale, std::abs(A(i, j)))) continue;
        return require(false, fmt::format("{}[{}][{}]", key, i + 1, j + 1), fmt::format("{:.9g}", A(i, j)),
                       i == j ? std::string("is not 0 on the diagonal of an antisymmetric matrix")
                              : fmt::format("is not {} of the entry opposite, {:.9g}",
                                            sign > 0.0 ? "that" : "the negative", A(j, i)),
                       fmt::format("give a matrix that is {}symmetric", sign > 0.0 ? "" : "anti"));
      }
    }
    return true;
  }

  bool symmetries() {
    bool right = symmetric("M", matrices_.mass, 1.0);
    right &= symmetric("C", matrices_.damping, 1.0);
    right &= symmetric("G", matrices_.gyroscopic, -1.0);
    right &= symmetric("K", matrices_.stiffness, 1.0);
    if (!right) return false;
    const Eigen::MatrixXd M = entries_of(matrices_.mass, n_);
    right &= require((M.diagonal().array() > 0.0).all() && least_scaled_eigenvalue(M) > least_positive, "M", "",
                     "is not positive definite", "give a matrix that has mass or inertia in every motion");
    const Eigen::MatrixXd K = entries_of(matrices_.stiffness, n_);
    right &= require((K.diagonal().array() >= 0.0).all() && least_scaled_eigenvalue(K) >= least_eigenvalue, "K", "",
                     "is not positive semidefinite", "give a stiffness without negative energy in any motion");
    return right;
  }

  bool stiffness() {
    const Eigen::MatrixXd K = entries_of(matrices_.stiffness, n_);
    const auto rest = split_unknowns(matrices_).second;
    const Eigen::MatrixXd inner = K(rest, rest);
    return require((inner.diagonal().array() > 0.0).all() && least_scaled_eigenvalue(inner) > least_positive, "K", "",
                   "leaves a motion free that moves no bearing",
                   "leave out axial motion and torsion, and name unknowns of the bearings that hold the rotor");
  }

  void rigid() {
    const Eigen::MatrixXd K = entries_of(matrices_.stiffness, n_);
    const Eigen::MatrixXd sizes = K.cwiseAbs();
    const Eigen::MatrixXd moved = rigid_motions(matrices_);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const Eigen::VectorXd one = moved.col(i);
      const Eigen::VectorXd size = one.cwiseAbs();
      const double energy_of_parts = size.dot(Eigen::VectorXd(sizes * size));
      if (!require(std::abs(one.dot(Eigen::VectorXd(K * one))) <= no_energy * energy_of_parts, "K", "",
                   "holds the rotor: a rigid motion has energy",
                   "give the matrices of the rotor alone, without bearings and supports, with all their digits")) {
        return;
      }
    }
    const double span = std::abs(matrices_.bearings[1].z - matrices_.bearings[0].z);
    for (std::size_t i = 0; i < matrices_.stations.size(); ++i) {
      const MatrixPlace& station = matrices_.stations[i];
      const std::string key = fmt::format("station[{}]", i + 1);
      const Eigen::RowVector4d in_x(1.0, 0.0, station.z, 0.0);
      const Eigen::RowVector4d in_y(0.0, 1.0, 0.0, station.z);
      for (const auto& [axis, number, expected] : {std::tuple(".x", station.x, in_x), {".y", station.y, in_y}}) {
        const double off = (moved.row(number) - expected).cwiseAbs().maxCoeff();
        require(off <= same_place_of_tilt * (span + std::abs(station.z)), key + axis, fmt::format("{}", number),
                fmt::format("does not move as a place at z = {:.6g} m does in a rigid motion", station.z),
                "give the number of its displacement, and its z");
      }
    }
    // M and the sign of G: for a rotor from X to Y, the polar inertia has this sign.
    const Eigen::MatrixXd G = entries_of(matrices_.gyroscopic, n_);
    const double polar_inertia = moved.col(2).dot(Eigen::VectorXd(G * moved.col(3)));
    require(polar_inertia >= 0.0, "G", "", fmt::format("has a polar inertia of {:.6g} kg m2", polar_inertia),
            "change its sign: Omega G is of a rotor that turns from X to Y");
  }

  const RotorMatrices& matrices_;
  Eigen::Index n_;
  std::array<std::pair<std::string_view, const std::vector<double>*>, 4> all_{
      {{"M", &matrices_.mass}, {"C", &matrices_.damping}, {"G", &matrices_.gyroscopic}, {"K", &matrices_.stiffness}}};
  std::vector<std::pair<std::string_view, const std::vector<double>*>> others_{all_.begin() + 1, all_.end()};
  std::vector<InputError> errors_;
};

}  // namespace

std::vector<InputError> find_matrix_errors(const RotorMatrices& matrices) {
  return MatrixCheck(matrices).errors();
}

Rotor make_rotor(const RotorMatrices& matrices) {
  const Eigen::Index n = unknowns_of(matrices);
  const auto half_of = [n](const std::vector<double>& rows, double sign) -> Eigen::MatrixXd {
    const Entries A = entries_of(rows, n);
    return 0.5 * (A + sign * A.transpose());
  };
  Rotor rotor;
  rotor.mass = half_of(matrices.mass, 1.0);
  rotor.damping = half_of(matrices.damping, 1.0);
  rotor.gyroscopic = half_of(matrices.gyroscopic, -1.0);
  rotor.stiffness = half_of(matrices.stiffness, 1.0);
  rotor.rigid = rigid_motions(matrices);
  const auto station_of = [n](const MatrixPlace& place) {
    RotorStation station{.name = place.name, .z = place.z, .motion = Eigen::MatrixXd::Zero(2, n)};
    station.motion(0, place.x) = station.motion(1, place.y) = 1.0;
    return station;
  };
  for (const MatrixPlace& bearing : matrices.bearings) rotor.bearings.push_back(station_of(bearing));
  for (const MatrixPlace& station : matrices.stations) rotor.stations.push_back(station_of(station));
  return rotor;
}

}  // namespace bumpfoil
