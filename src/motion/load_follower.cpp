#include "motion/load_follower.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

namespace bumpfoil {
namespace {

/// Maximum numbers of pieces of one load, and of guesses of the modes of one piece: many more than any response needs.
constexpr int most_pieces = 10000;
constexpr int most_guesses = 50;
/// First trial length of a move, as fraction of the reach, and the growth factor of later ones. A trial only needs to
/// reach the next contact change; following more is wasted.
constexpr double first_length = 1e-3;
constexpr double trial_growth = 4.0;
/// A smaller fraction of a move counts as zero.
constexpr double no_part = 1e-9;
/// Directions within this angle are equal, rad: round-off turns them by less, contact changes by more.
constexpr double no_turn = 1e-9;
/// A tangent whose determinant is below this fraction of its square is singular: it does not determine the motion.
constexpr double least_determinant = 1e-12;

class LoadFollower {
 public:
  LoadFollower(FoilStepper& stepper, const Eigen::Vector2d& load, double tolerance, double reach, Step& step)
      : stepper_(stepper),
        load_(load),
        tolerance_(tolerance),
        reach_(reach),
        longest_(first_length * reach),
        step_(step) {}

  bool follow() {
    for (int i = 0; i < most_pieces; ++i) {
      const Eigen::Vector2d lacking = load_ - force(step_.state);
      if (lacking.norm() <= tolerance_) return true;
      if (!take_piece(lacking)) return false;
    }
    return false;
  }

 private:
  [[nodiscard]] Eigen::Vector2d force(const BearingState& state) const {
    return holding_force(stepper_.foils(), state.contacts.normal_force);
  }

  bool take_piece(const Eigen::Vector2d& lacking);
  bool try_move(const Eigen::Vector2d& move, double part);
  [[nodiscard]] double first_part(const Eigen::Vector2d& move) const;

  FoilStepper& stepper_;
  Eigen::Vector2d load_;
  double tolerance_;
  double reach_;
  double longest_;  ///< trial length of a move, m
  Step& step_;
  Step piece_;
};

/// Tries a fraction of a move from the current state of the foils.
bool LoadFollower::try_move(const Eigen::Vector2d& move, double part) {
  Excitation end = step_.state;
  end.position += move;
  stepper_.set_out(step_.state, end);
  stepper_.advance_to(part, step_.state, piece_);
  step_.cost += piece_.cost;
  return piece_.converged();
}

/// The fraction of the move just tried before its first contact change.
double LoadFollower::first_part(const Eigen::Vector2d& move) const {
  for (const Waypoint& point : piece_.waypoints) {
    const double part = (point.position - step_.state.position).dot(move) / move.squaredNorm();
    if (part > no_part) return std::min(part, 1.0);
  }
  return 1.0;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Brackets the direction of motion: the force turns with it, piecewise continuously.
class Bracket {
 public:
  /// Adds a direction whose force increment `rise` lies to one side of the required one.
  void add(const Eigen::Vector2d& move, const Eigen::Vector2d& rise, const Eigen::Vector2d& wanted) {
    (cross(wanted, rise) > 0.0 ? left_ : right_) = move.normalized();
  }

  /// The direction, or one inside the bracket of the same length if it lies outside or at an edge, which has been
  /// tried.
  [[nodiscard]] Eigen::Vector2d inside(const Eigen::Vector2d& move) const {
    const double turn = no_turn * move.norm();
    if (!left_ || !right_ || (cross(*right_, move) > turn && cross(move, *left_) > turn)) return move;
    return move.norm() * (*left_ + *right_).normalized();
  }

 private:
  std::optional<Eigen::Vector2d> left_, right_;
};

/// Advances towards a load, at most to the next contact change.
bool LoadFollower::take_piece(const Eigen::Vector2d& lacking) {
  const Eigen::Vector2d here = step_.state.position;
  TangentMatrices tangents = stepper_.tangents(step_.state);
  Bracket bracket;
  for (int guess = 0; guess < most_guesses; ++guess) {
    if (!tangents.loading) return false;
    const Eigen::Matrix2d& K = *tangents.loading;
    if (!(K.determinant() > least_determinant * K.squaredNorm())) return false;
    Eigen::Vector2d move = bracket.inside(K.inverse() * lacking);
    const double tried = std::min(1.0, longest_ / move.norm());  // of the load
    move *= tried;
    if (!((here + move).norm() <= reach_) || !try_move(move, 1.0)) return false;
    const double part = first_part(move);
    if (part < 1.0 && !try_move(move, part)) return false;
    // The guess is correct if the force has grown in the required direction.
    const Eigen::Vector2d rise = force(piece_.state) - force(step_.state);
    if ((rise - part * tried * lacking).norm() <= tolerance_) {
      piece_.cost = {};  // counted already
      append(stepper_.foils(), piece_, step_);
      longest_ = trial_growth * (part * move.norm());
      return true;
    }
    bracket.add(move, rise, lacking);
    // At the end, round-off may have changed the modes of the piece.
    if (!try_move(move, 0.5 * part)) return false;
    tangents = stepper_.tangents(piece_.state);
  }
  return false;
}

}  // namespace

void append(const BearingModel& foils, const Step& part, Step& whole) {
  whole.status = part.status;
  whole.cost += part.cost;
  whole.substeps += part.substeps;
  whole.is_linear = whole.is_linear && part.is_linear;
  whole.waypoints.insert(whole.waypoints.end(), part.waypoints.begin(), part.waypoints.end());
  const Vector& loads = part.state.contacts.normal_force;
  whole.waypoints.push_back({part.state.position, holding_force(foils, loads), pad_forces(foils, loads)});
  whole.events.insert(whole.events.end(), part.events.begin(), part.events.end());
  whole.state = part.state;
}

bool follow_load(FoilStepper& stepper, const Eigen::Vector2d& load, double tolerance, double reach, Step& step) {
  return LoadFollower(stepper, load, tolerance, reach, step).follow();
}

}  // namespace bumpfoil
