#pragma once

#include <vector>

#include "bumpfoil/analysis/foil_model.hpp"
#include "bumpfoil/analysis/increment.hpp"
#include "bumpfoil/analysis/path_solver.hpp"

namespace bumpfoil {

/// Takes foils along straight paths of positions, or to loads, one increment at a time, and keeps what an increment
/// leaves to the next: state, friction history, work and dissipation. After a failure all that is as it was before.
class PathRunner {
 public:
  /// @param model  must outlive the runner
  PathRunner(const FoilModel& model, const SolverSettings& settings);

  /// From the unstressed foils to `position` (m) in one step; whatever was before is forgotten.
  /// @return false after a numerical failure
  [[nodiscard]] bool assemble(const Eigen::Vector2d& position);

  /// Begins the straight path from here to `end` (m). Increments of one path cost the event-driven solver less than
  /// paths of one increment.
  void set_out(const Eigen::Vector2d& end);

  /// One increment, to `fraction` of the path that was set out on, beyond the last. A failure ends the path, and so do
  /// assemble, move_to and load_to. @return false after a numerical failure
  [[nodiscard]] bool advance_to(double fraction);

  /// One increment, straight to `position` (m). @return false after a numerical failure
  [[nodiscard]] bool move_to(const Eigen::Vector2d& position);

  /// One increment along the unit vector `normal` to where the force that holds the pressing body is `load` (N) along
  /// it. The response to one increment is piecewise linear in its length: Newton's method with the tangent of the modes
  /// that it ends with, inside a bracket that shrinks, takes a few tries.
  /// @param load  positive: under no load the place would not be determined
  /// @param reach  the load is not looked for beyond this displacement along `normal`, m
  [[nodiscard]] bool load_to(const Eigen::Vector2d& normal, double load, double reach);

  /// Work, dissipation, and what increments cost start at zero from here.
  void reset_books();

  /// What is known now; index and branch are left to the caller.
  /// @param normal  that displacement, direct and cross force refer to
  [[nodiscard]] Increment record(const Eigen::Vector2d& normal) const;

  [[nodiscard]] const FoilModel& model() const { return model_; }
  [[nodiscard]] bool is_exact() const { return solver_.is_exact(); }
  [[nodiscard]] bool follows_events() const { return solver_.follows_events(); }
  [[nodiscard]] const ContactState& state() const { return now_.state; }
  /// Of the last increment, fractions of it; only from the event-driven solver.
  [[nodiscard]] const std::vector<ContactEvent>& events() const { return now_.events; }
  /// Dissipated by the last assembly, J.
  [[nodiscard]] double assembly_dissipation() const { return assembly_dissipation_; }

 private:
  /// The end of an increment, and what it took.
  struct Stage {
    Eigen::Vector2d position{0.0, 0.0};
    ContactState state;
    ContactLoading loading;
    Vector begin_of_part;  ///< unknowns that the slip of the last part is measured from
    double work{};
    double dissipation{};
    std::vector<ContactEvent> events;
    IncrementReport report;
  };

  /// Fills next_ with the increment from now to `fraction` of the path. @return whether it converged
  [[nodiscard]] bool try_increment(double fraction);

  const FoilModel& model_;
  PathSolver solver_;
  Stage now_;
  Stage next_;
  Eigen::Vector2d path_start_{0.0, 0.0};
  Eigen::Vector2d path_end_{0.0, 0.0};
  double path_done_{1.0};  ///< fraction of the path that lies behind; 1 where there is none
  double assembly_dissipation_{};
};

}  // namespace bumpfoil
