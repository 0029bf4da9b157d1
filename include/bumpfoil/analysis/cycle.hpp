#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/contact/solver.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

enum class Branch { loading, unloading };

/// One interface at one increment: entry i belongs to bump i or, at the sleeve, to foot i.
struct InterfaceFields {
  Vector gap;             ///< m, 0 where closed
  Vector normal_force;    ///< N, compression >= 0
  Vector friction_force;  ///< N, on the bump-foil node, positive away from the weld; zero at the journal
  std::vector<ContactMode> mode;
};

/// Everything known at one increment.
struct Increment {
  int index{};
  Branch branch{Branch::loading};
  double displacement{};        ///< of the journal along the direction, m
  double x{}, y{};              ///< journal centre, m
  double force_x{}, force_y{};  ///< force that holds the journal, N
  double force_direct{};        ///< F.n, N
  double force_cross{};         ///< F.t with t = n turned by +90 deg, N
  double elastic_energy{};      ///< J
  double dissipated_energy{};   ///< since increment 0, J; at increment 0 that of the assembly is kept apart
  double work{};                ///< of the journal since increment 0, trapezoidal rule, J
  ContactResiduals residuals;
  SolveReport solve;  ///< what it cost and whether it converged
  int substeps{};     ///< extra solves because the increment had to be halved

  Vector top_displacement;      ///< u_t, m, one per bump
  Vector crest_u, crest_v;      ///< m, one per bump
  Vector foot_u, foot_v;        ///< m, one per foot
  InterfaceFields journal_top;  ///< per bump
  InterfaceFields top_bump;     ///< per bump
  InterfaceFields bump_sleeve;  ///< per foot
};

/// Response at the turning point: present once the run got that far.
struct TurningPoint {
  double max_force{};                    ///< direct force at full displacement, N
  double cross_force{};                  ///< N
  double elastic_energy{};               ///< J
  double tangent_stiffness_loading{};    ///< slipping contacts go on slipping, N/m
  double tangent_stiffness_unloading{};  ///< all closed contacts stick, N/m
  double secant_stiffness{};             ///< max_force / amplitude, N/m
};

/// Push and pull in one direction: increments 0..2*steps and what is derived from them. Increment 0 is the assembly at
/// the centred journal, solved in one step from the unstressed foils. Quantities that could not be computed are absent.
struct Cycle {
  double direction{};                 ///< rad
  double amplitude{};                 ///< m
  int steps{};                        ///< per branch
  bool converged{};                   ///< all increments are there, and each meets the bound of its solver
  std::vector<Increment> increments;  ///< fewer than 2*steps+1 after a numerical failure or an interruption

  double assembly_dissipation{};  ///< D0: dissipated at increment 0, J
  std::optional<TurningPoint> turning_point;
  std::optional<double> loop_energy;    ///< closed integral of F.dx by the trapezoidal rule, J
  std::optional<double> loss_factor;    ///< loop energy / (2 pi (E_max - E0)); absent where nothing was deformed
  std::optional<double> first_contact;  ///< m; absent if no bump faces the direction
  std::optional<double> clearance_5N;   ///< displacement of the first upward crossing of 5 N, m; absent if never
  std::optional<double> clearance_10N;  ///< m
  double wall_time{};                   ///< s

  /// Increment at full displacement; only where turning_point is present.
  [[nodiscard]] const Increment& at_turning_point() const { return increments[static_cast<std::size_t>(steps)]; }
  [[nodiscard]] double initial_journal_load() const;  ///< sum of journal loads at increment 0, N
  [[nodiscard]] double max_residual() const;          ///< equilibrium, largest of all increments
  [[nodiscard]] SolveReport total() const;            ///< sum over increments
  [[nodiscard]] int substeps() const;                 ///< sum over increments
};

struct CycleResult {
  std::string solver;         ///< name of the solver that was used
  std::vector<Cycle> cycles;  ///< one per direction, in the order of the case

  [[nodiscard]] bool converged() const;
};

/// Called after every increment with the fraction of the whole run that is done, 0..1; returning false stops the run
/// (the cycles so far are returned, flagged as not converged).
using ProgressCallback = std::function<bool(double)>;

/// Runs the cycles of a case, each from the unstressed foils. Numerical failures are reported in the result.
/// @throws Error (input) if the case cannot be built.
CycleResult run_cycles(const Case& input, const ProgressCallback& progress = {});

}  // namespace bumpfoil
