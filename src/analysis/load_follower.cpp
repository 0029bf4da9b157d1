#include "analysis/load_follower.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace bumpfoil {
namespace {

/// Pieces of one load, and guesses of the modes of one piece: many more than any response needs.
constexpr int most_pieces = 10000;
constexpr int most_guesses = 20;
/// A part of the way that is no part.
constexpr double no_part = 1e-9;
/// Tangents this close to singular, as part of their square, do not determine where the body goes.
constexpr double least_determinant = 1e-12;

class LoadFollower {
 public:
  LoadFollower(FoilStepper& stepper, const Eigen::Vector2d& load, double tolerance, double reach, Step& step)
      : stepper_(stepper), load_(load), tolerance_(tolerance), reach_(reach), step_(step) {}

  bool follow() {
    for (int i = 0; i < most_pieces; ++i) {
      if (missing(step_.state).norm() <= tolerance_) return true;
      if (!take_piece()) return false;
    }
    return false;
  }

 private:
  [[nodiscard]] Eigen::Vector2d missing(const FoilState& state) const {
    return load_ - holding_force(stepper_.foils(), state.contacts.normal_force);
  }

  bool take_piece();
  bool try_piece(const Eigen::Vector2d& move, double part);
  [[nodiscard]] double first_part(const Eigen::Vector2d& move) const;

  FoilStepper& stepper_;
  Eigen::Vector2d load_;
  double tolerance_;
  double reach_;
  Step& step_;
  Step piece_;
};

/// Goes from where the foils are along a part of a move.
bool LoadFollower::try_piece(const Eigen::Vector2d& move, double part) {
  Excitation end = step_.state.excitation;
  end.position += move;
  stepper_.set_out(step_.state, end);
  stepper_.advance_to(part, step_.state, piece_);
  step_.cost += piece_.cost;
  return piece_.converged();
}

/// The part of a whole move, which was just tried, that lies before the first change of contact on it.
double LoadFollower::first_part(const Eigen::Vector2d& move) const {
  for (const Waypoint& point : piece_.waypoints) {
    const double part = (point.position - step_.state.excitation.position).dot(move) / move.squaredNorm();
    if (part > no_part) return std::min(part, 1.0);
  }
  return 1.0;
}

/// On to the next change of contact, or to the load.
bool LoadFollower::take_piece() {
  const Eigen::Vector2d lacking = missing(step_.state);
  TangentMatrices tangents = stepper_.tangents(step_.state);
  for (int guess = 0; guess < most_guesses; ++guess) {
    if (!tangents.loading) return false;
    const Eigen::Matrix2d& K = *tangents.loading;
    if (!(K.determinant() > least_determinant * K.squaredNorm())) return false;
    const Eigen::Vector2d move = K.inverse() * lacking;
    if (!((step_.state.excitation.position + move).norm() <= reach_) || !try_piece(move, 1.0)) return false;
    const double part = first_part(move);
    if (part < 1.0 && !try_piece(move, part)) return false;
    // The guess was right if the force has gone where it should.
    if ((missing(piece_.state) - (1.0 - part) * lacking).norm() <= tolerance_) {
      SolveCost no_more{};
      std::swap(piece_.cost, no_more);  // counted already
      append(stepper_.foils(), piece_, step_);
      return true;
    }
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
  whole.waypoints.push_back({part.state.excitation.position, holding_force(foils, part.state.contacts.normal_force)});
  whole.events.insert(whole.events.end(), part.events.begin(), part.events.end());
  whole.state = part.state;
}

bool follow_load(FoilStepper& stepper, const Eigen::Vector2d& load, double tolerance, double reach, Step& step) {
  return LoadFollower(stepper, load, tolerance, reach, step).follow();
}

}  // namespace bumpfoil
