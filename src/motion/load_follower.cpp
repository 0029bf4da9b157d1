#include "motion/load_follower.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

namespace bumpfoil {
namespace {

/// Pieces of one load, and guesses of the modes of one piece: many more than any response needs.
constexpr int most_pieces = 10000;
constexpr int most_guesses = 50;
/// Moves are tried so far, as part of the reach, and then so many times as far as the last: one change of contact is
/// looked for, and those behind it would be followed in vain.
constexpr double first_length = 1e-3;
constexpr double growth = 4.0;
/// A part of a move that is none.
constexpr double no_part = 1e-9;
/// A way within this of another is the same, rad: roundings turn it by less, changes of contact by more.
constexpr double no_turn = 1e-9;
/// Tangents this close to singular, as part of their square, do not determine where the body goes.
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
  double longest_;  ///< that a move is tried, m
  Step& step_;
  Step piece_;
};

/// Goes from where the foils are along a part of a move.
bool LoadFollower::try_move(const Eigen::Vector2d& move, double part) {
  Excitation end = step_.state;
  end.position += move;
  stepper_.set_out(step_.state, end);
  stepper_.advance_to(part, step_.state, piece_);
  step_.cost += piece_.cost;
  return piece_.converged();
}

/// The part of a move, which was just tried, that lies before the first change of contact on it.
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

/// Narrows down where to go: the force turns with the way, in pieces.
class Bracket {
 public:
  /// A way that makes the force grow by `rise`, to one side of where it should.
  void add(const Eigen::Vector2d& way, const Eigen::Vector2d& rise, const Eigen::Vector2d& wanted) {
    (cross(wanted, rise) > 0.0 ? left_ : right_) = way.normalized();
  }

  /// The way, or where it lies outside the bracket or at its edge, which has been tried, one inside of the same length.
  [[nodiscard]] Eigen::Vector2d inside(const Eigen::Vector2d& way) const {
    const double turn = no_turn * way.norm();
    if (!left_ || !right_ || (cross(*right_, way) > turn && cross(way, *left_) > turn)) return way;
    return way.norm() * (*left_ + *right_).normalized();
  }

 private:
  std::optional<Eigen::Vector2d> left_, right_;
};

/// On towards a load, no further than to the next change of contact.
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
    // The guess was right if the force has grown as it should.
    const Eigen::Vector2d rise = force(piece_.state) - force(step_.state);
    if ((rise - part * tried * lacking).norm() <= tolerance_) {
      piece_.cost = {};  // counted already
      append(stepper_.foils(), piece_, step_);
      longest_ = growth * (part * move.norm());
      return true;
    }
    bracket.add(move, rise, lacking);
    // At its end a rounding may have changed the modes of the piece.
    if (!try_move(move, 0.5 * part)) return false;
    tangents = stepper_.tangents(piece_.state);
  }
  return false;
}

}  // namespace

void append(const Foils& foils, const Step& part, Step& whole) {
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
