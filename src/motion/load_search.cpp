#include "bumpfoil/motion/load_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/load_follower.hpp"

namespace bumpfoil {
namespace {

/// Maximum trials: far more than a bracketed search needs on a piecewise linear (large displacements: piecewise smooth)
/// function.
constexpr int most_tries = 100;
/// First step towards a load without contact, as fraction of the reach.
constexpr double first_part = 1e-3;
/// Maximum numbers of Newton steps in the plane, and of halvings of each. A handful suffices; more are needed if the
/// journal rolls from contact to contact.
constexpr int most_steps_in_plane = 100;
constexpr int most_step_halvings = 20;
constexpr double most_overshoot = 0.3;
/// Smallest spring stiffness, as fraction of the stiffness of sticking contacts.
constexpr double softest_spring = 1e-6;
/// As fractions of the reach: the longest of these steps, and the shortest.
constexpr double longest_move = 0.05;
constexpr double shortest_move = 1e-6;

/// Maximum number of halvings of the load.
constexpr int most_load_halvings = 8;
/// Lateral force that counts as zero, in units of the load that replaces a load of zero.
constexpr double most_across = 3.0;
/// A tangent stiffness below this fraction of that of sticking contacts does not determine the position.
constexpr double least_tangent = 1e-9;

/// Even a load as small as the tolerance must distinguish a journal that carries it from one that has lifted.
double load_tolerance(const FoilStepper& stepper, const Eigen::Vector2d& load) {
  return std::min(0.5 * load.norm(), std::max(load.norm(), 1.0) * stepper.bounds().load);
}

class LoadSearch {
 public:
  LoadSearch(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, double reach, Step& step)
      : stepper_(stepper), from_(from), load_(load), reach_(reach), step_(step) {
    tolerance_ = load_tolerance(stepper, load);
    step_.state = from;
    step_.state.begin_increment();
    step_.events.clear();
  }

  /// Moves the journal along the unit vector `direction` until this component of the load is met.
  void along(const Eigen::Vector2d& direction);
  /// Continues in the plane until both components are met.
  void in_plane();
  /// Whether the remaining lateral force on a journal moved along its load counts as zero.
  [[nodiscard]] bool lets_go() const { return missing().norm() <= most_across * load_.norm(); }
  /// Sums the cost of all trials and of `before`.
  void finish(const SolveCost& before, int substeps_before) {
    step_.cost = cost_;
    step_.cost += before;
    step_.substeps = substeps_ + substeps_before;
  }

 private:
  [[nodiscard]] Eigen::Vector2d missing() const {
    return load_ - holding_force(stepper_.foils(), step_.state.contacts.normal_force);
  }
  /// One increment from the start. @return whether it converged
  bool try_at(const Eigen::Vector2d& position) {
    Excitation to = from_;
    to.position = position;
    stepper_.advance(from_, to, step_);
    cost_ += step_.cost;
    substeps_ += step_.substeps;
    return step_.converged();
  }

  FoilStepper& stepper_;
  const BearingState& from_;
  Eigen::Vector2d load_;
  double reach_;
  Step& step_;
  double tolerance_{};  ///< N
  SolveCost cost_;
  int substeps_{};
};

void LoadSearch::along(const Eigen::Vector2d& direction) {
  const Eigen::Vector2d start = from_.position;
  const double most = reach_ - start.dot(direction);
  double below = -HUGE_VAL;  // lengths with too little load, and with too much
  double above = HUGE_VAL;
  double length = 0.0;  // no motion
  for (int i = 0; i < most_tries; ++i) {
    const double lacking = missing().dot(direction);
    if (std::abs(lacking) <= tolerance_) return;
    (lacking > 0.0 ? below : above) = length;

    const TangentStiffnesses tangent = stepper_.tangents(step_.state).along(direction);
    // The first trial reverses or continues in the last direction.
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

/// Whether a free journal is stable under its load.
Status stability(const TangentMatrices& tangents) {
  if (!tangents.loading || !tangents.unloading) return Status::not_unique;
  if (tangents.loading->norm() < least_tangent * tangents.unloading->norm()) return Status::not_unique;
  return tangents.loading->determinant() <= 0.0 ? Status::unstable : Status::converged;
}

/// Newton's move towards a load, at most of length `longest`. A spring as soft as possible restrains directions without
/// stiffness (a journal on one contact rolls until it meets the next).
Eigen::Vector2d newton_move(const TangentMatrices& tangents, const Eigen::Vector2d& lacking, double longest) {
  const double stiff = std::max(tangents.unloading->norm(), lacking.norm() / longest);
  for (double spring = 0.0;; spring = std::max(softest_spring * stiff, 10.0 * spring)) {
    const Eigen::Matrix2d K = *tangents.loading + spring * Eigen::Matrix2d::Identity();
    if (!(std::abs(K.determinant()) > 1e-12 * K.squaredNorm())) continue;
    Eigen::Vector2d move = K.inverse() * lacking;
    if (move.norm() <= longest && move.dot(lacking) > 0.0) return move;
  }
}

void LoadSearch::in_plane() {
  for (int i = 0; i < most_steps_in_plane; ++i) {
    const Eigen::Vector2d lacking = missing();
    const TangentMatrices tangents = stepper_.tangents(step_.state);
    if (lacking.norm() <= tolerance_) {
      step_.status = stability(tangents);
      return;
    }
    if (!tangents.loading || !tangents.unloading) break;
    const Eigen::Vector2d here = step_.state.position;
    Eigen::Vector2d move = newton_move(tangents, lacking, longest_move * reach_);
    if ((here + move).norm() > reach_) {
      const double room = reach_ - here.norm();
      if (room < shortest_move * reach_) {
        step_.status = Status::load_out_of_reach;
        return;
      }
      move *= room / move.norm();
    }
    for (int halvings = 0; halvings < most_step_halvings; ++halvings, move *= 0.5) {
      if (!try_at(here + move)) return;
      // Accepts a move that comes nearer to the load, or overshoots only slightly.
      if (missing().norm() < lacking.norm() || missing().dot(move) > -most_overshoot * lacking.dot(move)) break;
    }
  }
  step_.status = Status::load_not_met;
}

/// Whether all bumps have one normal, so that no lateral force can be carried.
bool is_strip(const BearingModel& foils) {
  return (foils.normals.colwise() - foils.normals.col(0)).isZero();
}

/// Tries to meet the load in one increment.
void try_load(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, bool is_none, double reach,
              Step& step) {
  const SolveCost before = step.cost;
  const int substeps_before = step.substeps;
  step.status = Status::converged;
  LoadSearch search(stepper, from, load, reach, step);
  // If no contact carries the load yet, or it reverses, the journal may have to cross its clearance.
  const bool anew = holding_force(stepper.foils(), from.contacts.normal_force).dot(load) <= 0.0;
  const bool strip = is_strip(stepper.foils());
  if (strip || anew || is_none) search.along(load.normalized());
  const bool met = strip || (is_none && search.lets_go());
  if (!met && step.converged()) search.in_plane();
  search.finish(before, substeps_before);
}

/// Meets the load in one increment, or in two of half the load each, recursively.
void meet_load(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, bool is_none, double reach,
               int halvings, Step& step) {
  try_load(stepper, from, load, is_none, reach, step);
  if (step.status != Status::load_not_met || halvings == 0 || is_strip(stepper.foils())) return;
  const Eigen::Vector2d carried = holding_force(stepper.foils(), from.contacts.normal_force);
  ++step.substeps;
  meet_load(stepper, from, 0.5 * (carried + load), false, reach, halvings - 1, step);
  if (!step.converged()) return;
  const BearingState middle = step.state;
  ++step.substeps;
  meet_load(stepper, middle, load, is_none, reach, halvings - 1, step);
}

/// Continues from the end of `step`, and appends to it.
void go_on(FoilStepper& stepper, const Eigen::Vector2d& load, bool is_none, double reach, Step& step) {
  Step part;
  meet_load(stepper, step.state, load, is_none, reach, most_load_halvings, part);
  append(stepper.foils(), part, step);
}

/// The smallest load on the line between two loads.
double least_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d line = (to - from).normalized();
  return (from - from.dot(line) * line).norm();
}

/// Meets the load along the path of the journal while it grows.
void grow_load(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, double none, double reach,
               Step& step) {
  const Eigen::Vector2d carried = holding_force(stepper.foils(), from.contacts.normal_force);
  const bool is_none = load.norm() <= none;
  step.state = from;
  step.state.begin_increment();
  step.status = Status::converged;
  step.is_linear = true;
  step.events.clear();
  step.waypoints.clear();
  const auto follow = [&](const Eigen::Vector2d& to) {
    return follow_load(stepper, to, load_tolerance(stepper, to), reach, step);
  };
  const bool anew = carried.norm() <= none || (carried.dot(load) <= 0.0 && least_between(carried, load) <= none);
  if (anew) {
    if (carried.norm() > none) follow(none * carried.normalized());
    go_on(stepper, none * load.normalized(), is_none, reach, step);
  }
  if (!step.converged()) return meet_load(stepper, from, load, is_none, reach, most_load_halvings, step);
  if (!(anew && is_none)) {
    if (follow(load)) {
      if (!is_none) step.status = stability(stepper.tangents(step.state));
    } else {
      ++step.substeps;
      go_on(stepper, load, is_none, reach, step);
    }
  }
  if (!step.waypoints.empty()) step.waypoints.pop_back();  // the last waypoint is the end
}

}  // namespace

void advance_to_load(FoilStepper& stepper, const BearingState& from, const Eigen::Vector2d& load, double none,
                     double reach, Step& step) {
  step.cost = {};
  step.substeps = 0;
  if (stepper.follows_events() && !is_strip(stepper.foils())) {
    grow_load(stepper, from, load, none, reach, step);
  } else {
    meet_load(stepper, from, load, load.norm() <= none, reach, most_load_halvings, step);
  }
}

}  // namespace bumpfoil
