#pragma once

#include <vector>

#include "bumpfoil/analysis/foil_model.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/contact/solver.hpp"

namespace bumpfoil {

enum class Branch { loading, unloading };

/// One interface at one increment: entry i belongs to bump i or, at the sleeve, to foot i. Empty where there is none.
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

  Vector top_displacement;      ///< u_t, m, one per bump; empty without a top foil
  Vector crest_u, crest_v;      ///< m, one per bump
  Vector foot_u, foot_v;        ///< m, one per foot
  InterfaceFields journal_top;  ///< per bump
  InterfaceFields top_bump;     ///< per bump
  InterfaceFields bump_sleeve;  ///< per foot

  FoilStress stress;
};

/// Fields, forces, stress, elastic energy and residuals of a state; index, branch, displacement, work and dissipation
/// are left to the caller.
/// @param position    of the journal centre, m
/// @param direction   unit vector n that direct and cross force refer to
/// @param previous_x  unknowns at the begin of the last part of the increment, which its slip is measured from
Increment record_increment(const FoilModel& model, const Eigen::Vector2d& position, const Eigen::Vector2d& direction,
                           const ContactLoading& loading, const Vector& previous_x, const ContactState& state);

}  // namespace bumpfoil
