#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/analysis/increment.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

enum class Interface { journal_top, top_bump, bump_sleeve };

/// A change of mode of one contact, as the event-driven solver saw it.
struct CycleEvent {
  Branch branch{};
  double displacement{};  ///< of the journal along the direction, m
  Interface interface {};
  int index{};  ///< bump or, at the sleeve, foot; from 0
  ContactMode from{};
  ContactMode to{};
};

/// Tangent stiffnesses d(F.n)/ds at a state, N/m; absent where the closed contacts leave the foils loose.
struct TangentStiffnesses {
  std::optional<double> loading;    ///< slipping contacts go on slipping
  std::optional<double> unloading;  ///< all closed contacts stick
};

/// Response at the turning point: present once the run got that far.
struct TurningPoint {
  double max_force{};       ///< direct force at full displacement, N
  double cross_force{};     ///< N
  double elastic_energy{};  ///< J
  TangentStiffnesses tangent;
  double secant_stiffness{};  ///< max_force / amplitude, N/m
};

/// Where a foil is bent most.
enum class StressPlace {
  weld,   ///< where it is clamped
  crest,  ///< at a crest; of the top foil, over it
  foot,   ///< at an end of an arc
  arc,    ///< between crest and foot
};

/// The largest bending stress of a foil during a cycle, and where and when it acts first.
struct StressPeak {
  double stress{};  ///< Pa
  StressPlace place{};
  int bump{-1};           ///< from 0; -1 at the weld
  int increment{};        ///< of the cycle
  double displacement{};  ///< at that increment, m

  bool operator==(const StressPeak&) const = default;
};

/// A loop and what is derived from it: push and pull of the journal in one direction, or one cycle of a strip between
/// plates, along the direction 0. Of a bearing, increment 0 is the assembly at the centred journal, solved in one step
/// from the unstressed foils. Quantities that could not be computed are absent.
struct Cycle {
  double direction{};                 ///< rad
  double amplitude{};                 ///< displacement from the start to the turning point, m
  int steps{};                        ///< from the start to the turning point
  int due{};                          ///< increments of the whole loop, the first included
  bool converged{};                   ///< all increments are there, and each meets the bound of its solver
  std::vector<Increment> increments;  ///< fewer than are due after a numerical failure or an interruption

  std::vector<CycleEvent> events;  ///< only from the event-driven solver

  double assembly_dissipation{};  ///< D0: dissipated at increment 0, J
  std::optional<TurningPoint> turning_point;
  std::optional<double> loop_energy;           ///< closed integral of F.dx by the trapezoidal rule, J
  std::optional<double> loss_factor;           ///< loop energy / (2 pi (E_max - E0)); absent where nothing was deformed
  std::optional<double> first_contact;         ///< m; absent if no bump faces the direction
  std::optional<double> clearance_5N;          ///< displacement of the first upward crossing of 5 N, m; absent if never
  std::optional<double> clearance_10N;         ///< m
  std::optional<StressPeak> top_foil_stress;   ///< absent without a top foil
  std::optional<StressPeak> bump_foil_stress;  ///< absent where the model knows none: truss and former model
  double wall_time{};                          ///< s

  /// Increment at full displacement; only where turning_point is present.
  [[nodiscard]] const Increment& at_turning_point() const { return increments[static_cast<std::size_t>(steps)]; }
  [[nodiscard]] double initial_journal_load() const;  ///< sum of journal loads at increment 0, N
  [[nodiscard]] double max_residual() const;          ///< equilibrium, largest of all increments
  [[nodiscard]] SolveReport total() const;            ///< sum over increments
  [[nodiscard]] int substeps() const;                 ///< sum over increments
};

/// What was done to the foils.
enum class Experiment { cycle, strip };

struct CycleResult {
  SolverName solver{};  ///< that was used
  Experiment experiment{Experiment::cycle};
  std::vector<Cycle> cycles;  ///< one per direction, in the order of the case; of a strip, one after the other

  [[nodiscard]] bool converged() const;
};

/// Called after every increment with the fraction of the whole run that is done, 0..1; returning false stops the run
/// (the cycles so far are returned, flagged as not converged).
using ProgressCallback = std::function<bool(double)>;

/// Runs the cycles of a case, each from the unstressed foils. Numerical failures are reported in the result.
/// @throws Error (input) if the case cannot be built.
CycleResult run_cycles(const Case& input, const ProgressCallback& progress = {});

}  // namespace bumpfoil
