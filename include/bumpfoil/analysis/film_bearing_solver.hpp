#pragma once

#include <memory>
#include <optional>

#include "bumpfoil/analysis/film_bearing.hpp"
#include "bumpfoil/film/film_solver.hpp"

namespace bumpfoil {

/// Settings of the search for states of a bearing that runs.
struct FilmBearingOptions {
  FilmSolverOptions newton{};
  double first_time_step{0.025};   ///< of the march of a cold start, in units of T0
  double time_growth{1.5};         ///< of time steps that converged; others are quartered
  double last_time_step{10e-3};    ///< s; the march ends at steps longer than this that change little:
  double resting_change{1e-4};     ///< of P and U
  double position_step{0.1};       ///< first length of a step of follow(), in units of c
  double speed_step{0.1};          ///< the same, of the speed at the begin or end, whichever is larger
  double smallest_fraction{1e-3};  ///< of the first step: where shorter ones fail, the path ends
};

/// Finds states of a bearing that runs: gas film, sagging top foil, bump foil, unilateral contact and Coulomb friction
/// in one system. Newton's method on the film; in each step the contact problem of the linearised system, condensed to
/// the crests, is solved exactly (NewtonSolver). Film and foils are never iterated in turn: a foil that has lifted off
/// its bumps is held by the film alone, and only the joint matrix knows that.
///
/// There may be several states at one position and speed, even without friction: which one is found is decided by the
/// path that leads there. Every function says what its path is.
class FilmBearingSolver {
 public:
  explicit FilmBearingSolver(const FilmBearing& bearing, const FilmBearingOptions& options = FilmBearingOptions());
  ~FilmBearingSolver();

  /// The state near `state` at another position and speed, all in one step.
  /// @param previous  state that friction refers to
  /// @param state     first guess; receives the result, and stays as it was unless the status is converged
  [[nodiscard]] FilmReport solve(const Eigen::Vector2d& position, double speed, const ContactState& previous,
                                 FilmBearingState& state);

  /// The journal, held at `position` (where it must not touch the undeformed foils), and turning at `speed` from one
  /// moment to the next: from unstressed foils and ambient pressure the film is marched in time by implicit Euler, the
  /// foils without mass, until nothing moves. Friction refers to the unstressed foils throughout.
  [[nodiscard]] FilmReport cold_start(const Eigen::Vector2d& position, double speed, FilmBearingState& state);

  /// From `state` in a straight line to another position and speed, by steps of adapted length with friction referring
  /// to the step before: for frictionless foils, since with friction increments are part of the path.
  /// @param state  receives the state at the end, or the last that was found
  [[nodiscard]] FilmReport follow(const Eigen::Vector2d& position, double speed, FilmBearingState& state);

  /// Stiffness dF/d(x, y) of the bearing at `state`, N/m, rows x and y: consistent, closed contacts rigid, every
  /// contact keeping its mode; with `stuck` slipping contacts stick, as under a small whirl. Not symmetric.
  /// @return nothing if the modes leave a singular system
  [[nodiscard]] std::optional<Eigen::Matrix2d> stiffness(const FilmBearingState& state, bool stuck = false);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
