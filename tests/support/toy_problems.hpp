#pragma once

#include "bumpfoil/contact/problem.hpp"

/// Contact problems small enough to be solved by hand, with round numbers (N, m, N/m).
namespace bumpfoil::toy {

/// A spring of 1e6 N/m whose end (unknown 0) may touch a wall at x = g0: g = g0 - x.
inline ContactProblem spring_against_a_wall() {
  ContactProblem problem;
  problem.K = BlockTridiagonal(1, 1);
  problem.K.add(0, 0, 0, 0, 1e6);
  problem.sites = in_every_block({{.minus = 0}}, problem.K.blocks());
  return problem;
}

/// A block on a floor, held by a spring of 2e6 N/m along it (unknown 0) and one of 1e6 N/m across it (unknown 1,
/// upward): g = g0 + x1. Friction coefficient 0.5.
inline ContactProblem dragged_block() {
  ContactProblem problem;
  problem.K = BlockTridiagonal(1, 2);
  problem.K.add(0, 0, 0, 0, 2e6);
  problem.K.add(0, 1, 0, 1, 1e6);
  problem.sites = in_every_block({{.plus = 1, .tangential = 0, .friction_coefficient = 0.5}}, problem.K.blocks());
  return problem;
}

/// Pulls the dragged block along the floor and presses it down.
inline ContactLoading pull(double along, double down) {
  return {.initial_gap = Vector::Zero(1), .load = Eigen::Vector2d(along, -down)};
}

/// Two slabs on beds of 1e6 N/m, the upper (unknown 1) over the lower (unknown 0) over the floor: contact 0 is
/// floor/lower, g = g0 + x0; contact 1 is lower/upper, g = g0 + x1 - x0.
inline ContactProblem stacked_slabs() {
  ContactProblem problem;
  problem.K = BlockTridiagonal(1, 2);
  problem.K.add(0, 0, 0, 0, 1e6);
  problem.K.add(0, 1, 0, 1, 1e6);
  problem.sites = in_every_block({{.plus = 0}, {.plus = 1, .minus = 0}}, problem.K.blocks());
  return problem;
}

}  // namespace bumpfoil::toy
