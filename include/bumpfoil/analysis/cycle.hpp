#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/contact/problem.hpp"
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
  double dissipated_energy{};   ///< since increment 0, J
  double work{};                ///< of the journal since increment 0, trapezoidal rule, J
  double residual{};            ///< equilibrium, over max(largest contact force, 1 N)
  int iterations{};             ///< linear solves
  int substeps{};               ///< extra solves because the increment had to be halved
  bool converged{true};

  Vector top_displacement;      ///< u_t, m, one per bump
  Vector crest_u, crest_v;      ///< m, one per bump
  Vector foot_u, foot_v;        ///< m, one per foot
  InterfaceFields journal_top;  ///< per bump
  InterfaceFields top_bump;     ///< per bump
  InterfaceFields bump_sleeve;  ///< per foot
};

/// Push and pull in one direction: increments 0..2*steps and what is derived from them. Increment 0 is the assembly at
/// the centred journal, solved in one step from the unstressed foils.
struct Cycle {
  double direction{};                 ///< rad
  double amplitude{};                 ///< m
  int steps{};                        ///< per branch
  bool converged{};                   ///< every increment meets the bounds of contact/residual.hpp
  std::vector<Increment> increments;  ///< fewer than 2*steps+1 after a numerical failure

  // Derived; NaN-free: what could not be computed is absent.
  double max_force{};           ///< direct force at full displacement, N
  double cross_force_at_max{};  ///< N
  double initial_force{};       ///< direct force at increment 0, N
  double initial_force_x{}, initial_force_y{};
  double initial_journal_load{};         ///< sum of journal loads at increment 0, N
  double initial_elastic_energy{};       ///< E0, J
  double assembly_dissipation{};         ///< D0, J
  double loop_energy{};                  ///< closed integral of F.dx by the trapezoidal rule, J
  double elastic_energy_at_max{};        ///< J
  std::optional<double> loss_factor;     ///< loop energy / (2 pi (E_max - E0)); absent where nothing was deformed
  double tangent_stiffness_loading{};    ///< at the turning point, slipping contacts go on slipping, N/m
  double tangent_stiffness_unloading{};  ///< at the turning point, all closed contacts stick, N/m
  double secant_stiffness{};             ///< max_force / amplitude, N/m
  std::optional<double> first_contact;   ///< m; absent if no bump faces the direction
  std::optional<double> clearance_5N;    ///< displacement of the first upward crossing of 5 N, m; absent if never
  std::optional<double> clearance_10N;   ///< m
  Vector bump_loads;                     ///< top foil on crests at full displacement, N, one per bump
  Vector foot_loads;                     ///< feet on the sleeve, N, one per foot
  Vector journal_loads;                  ///< journal on the top foil, N, one per bump
  double max_residual{};
  int iterations{};  ///< sum over increments
  int substeps{};
  double wall_time{};  ///< s
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
