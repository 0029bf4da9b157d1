#include "analysis/load_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace bumpfoil {
namespace {

/// Many more than a function with a bracket needs that is linear, or under large displacements smooth, in pieces.
constexpr int most_tries = 100;
/// The first step towards a load where nothing is touched yet, as part of the reach.
constexpr double first_part = 1e-3;
/// Newton's method in the plane needs a handful of steps; each may be halved as often as this.
constexpr int most_steps_in_plane = 50;
constexpr int most_halvings = 12;
/// As parts of the reach: what one such step may take, and what is too little room for one.
constexpr double longest_move = 0.1;
constexpr double shortest_move = 1e-6;

class LoadSearch {
 public:
  LoadSearch(FoilStepper& stepper, const FoilState& from, const Eigen::Vector2d& load, double reach, Step& step)
      : stepper_(stepper), from_(from), load_(load), reach_(reach), step_(step) {
    // A load as small as the tolerance must still tell a body that carries it from one that has lifted.
    tolerance_ = std::min(0.5 * load.norm(), std::max(load.norm(), 1.0) * stepper.bounds().load);
    step_.state = from;
    step_.state.slip_origin = from.contacts.x;
    step_.events.clear();
  }

  /// Leaves the pressing body on the line through where it was along the unit vector `direction`, where the load along
  /// that is met.
  void along(const Eigen::Vector2d& direction);
  /// Goes on from there until both components are met.
  void in_plane();
  /// Hands over what all tries cost together.
  void finish() {
    step_.cost = cost_;
    step_.substeps = substeps_;
  }

 private:
  [[nodiscard]] Eigen::Vector2d missing() const {
    return load_ - holding_force(stepper_.foils(), step_.state.contacts.normal_force);
  }
  /// One increment from the start. @return whether it converged
  bool try_at(const Eigen::Vector2d& position) {
    Excitation to = from_.excitation;
    to.position = position;
    stepper_.advance(from_, to, step_);
    cost_ += step_.cost;
    substeps_ += step_.substeps;
    return step_.converged();
  }

  FoilStepper& stepper_;
  const FoilState& from_;
  Eigen::Vector2d load_;
  double reach_;
  Step& step_;
  double tolerance_{};  ///< N
  SolveCost cost_;
  int substeps_{};
};

void LoadSearch::along(const Eigen::Vector2d& direction) {
  const Eigen::Vector2d start = from_.excitation.position;
  const double most = reach_ - start.dot(direction);
  double below = -HUGE_VAL;  // lengths that end with less load, and with more
  double above = HUGE_VAL;
  double length = 0.0;  // standing still
  for (int i = 0; i < most_tries; ++i) {
    const double lacking = missing().dot(direction);
    if (std::abs(lacking) <= tolerance_) return;
    (lacking > 0.0 ? below : above) = length;

    const TangentStiffnesses tangent = stepper_.tangents(step_.state).along(direction);
    // The first try turns round, or goes on as before.
    const double slope = (i == 0 && lacking < 0.0 ? tangent.unloading : tangent.loading).value_or(0.0);
    const double newton = slope > 0.0 ? length + lacking / slope : HUGE_VAL;
    const double further = std::max(std::abs(length), first_part * reach_);
    if (newton > below && newton < above) {
      length = newton;
    } else if (std::isinf(above)) {
      length = below + further;
    } else if (std::isinf(below)) {
      length = above - further;
    } else {
      length = 0.5 * (below + above);
    }
    if (length > most) {
      if (below >= most) {
        step_.status = Status::load_out_of_reach;
        return;
      }
      length = most;
    }
    if (!try_at(start + length * direction)) return;
  }
  step_.status = Status::load_not_met;
}

void LoadSearch::in_plane() {
  for (int i = 0; i < most_steps_in_plane; ++i) {
    const Eigen::Vector2d lacking = missing();
    if (lacking.norm() <= tolerance_) return;
    const std::optional<Eigen::Matrix2d> K = stepper_.tangents(step_.state).loading;
    if (!K || !(std::abs(K->determinant()) > 0.0)) break;
    const Eigen::Vector2d here = step_.state.excitation.position;
    Eigen::Vector2d move = K->inverse() * lacking;
    move *= std::min(1.0, longest_move * reach_ / move.norm());
    if ((here + move).norm() > reach_) {
      const double room = reach_ - here.norm();
      if (room < shortest_move * reach_) {
        step_.status = Status::load_out_of_reach;
        return;
      }
      move *= room / move.norm();
    }
    for (int halvings = 0; halvings < most_halvings; ++halvings, move *= 0.5) {
      if (!try_at(here + move)) return;
      if (missing().norm() < lacking.norm()) break;
    }
  }
  step_.status = Status::load_not_met;
}

/// Whether all bumps have one normal, so that nothing can be carried across it.
bool is_strip(const Foils& foils) {
  return (foils.normals.colwise() - foils.normals.col(0)).isZero();
}

}  // namespace

void advance_to_load(FoilStepper& stepper, const FoilState& from, const Eigen::Vector2d& load, double reach,
                     Step& step) {
  step.status = Status::converged;
  LoadSearch search(stepper, from, load, reach, step);
  const bool carries = holding_force(stepper.foils(), from.contacts.normal_force).norm() > 0.0;
  const bool strip = is_strip(stepper.foils());
  if (strip || !carries) search.along(load.normalized());
  if (!strip && step.converged()) search.in_plane();
  search.finish();
}

}  // namespace bumpfoil
