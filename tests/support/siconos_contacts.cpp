#include "support/siconos_contacts.hpp"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "support/dense_contacts.hpp"

namespace bumpfoil {
namespace {

int identifier_of(SiconosMethod method) {
  switch (method) {
    case SiconosMethod::enumeration:
      return SICONOS_FRICTION_2D_ENUM;
    case SiconosMethod::lemke:
      return SICONOS_FRICTION_2D_LEMKE;
    case SiconosMethod::gauss_seidel:
      return SICONOS_FRICTION_2D_NSGS;
    case SiconosMethod::conjugate_gradients:
      break;
  }
  return SICONOS_FRICTION_2D_CPG;
}

/// Siconos frees what it is given with free().
double* copy_for_siconos(const double* values, Eigen::Index size) {
  auto* copy = static_cast<double*>(std::malloc(static_cast<std::size_t>(size) * sizeof(double)));
  std::copy_n(values, size, copy);
  return copy;
}

}  // namespace

std::string name_of(SiconosMethod method) {
  switch (method) {
    case SiconosMethod::enumeration:
      return "enumeration";
    case SiconosMethod::lemke:
      return "lemke";
    case SiconosMethod::gauss_seidel:
      return "gauss_seidel";
    case SiconosMethod::conjugate_gradients:
      break;
  }
  return "conjugate_gradients";
}

SiconosContacts::SiconosContacts(const ContactProblem& problem) {
  const DenseContacts dense = make_dense(problem);
  B_ = Matrix(2 * problem.contacts(), problem.K.rows());
  for (Eigen::Index c = 0; c < dense.normal.rows(); ++c) {
    B_.row(2 * c) = dense.normal.row(c);
    B_.row(2 * c + 1) = dense.tangential.row(c);
  }
  friction_ = dense.friction;
  K_.compute(dense.K);
  motion_ = K_.solve(B_.transpose());
  W_ = B_ * motion_;
  W_ = 0.5 * (W_ + W_.transpose()).eval();
  // A contact without a tangential unknown gets a separate one that never moves: solvers divide by the diagonal. Its
  // coefficient is arbitrary and set to that of the others, since Siconos 4.4 solves wrong complementarity problems if
  // coefficients differ.
  for (Eigen::Index c = 0; c < friction_.size(); ++c) {
    if (W_(2 * c + 1, 2 * c + 1) != 0.0) continue;
    W_(2 * c + 1, 2 * c + 1) = W_(2 * c, 2 * c);
    friction_[c] = dense.friction.maxCoeff();
  }
}

bool SiconosContacts::solve(SiconosMethod method, const ContactLoading& loading, const Vector& previous_x,
                            ContactState& state, const SiconosOptions& options) {
  const Eigen::Index contacts = friction_.size();
  const Vector unloaded = K_.solve(loading.load);
  Vector q = B_ * unloaded;
  const Vector place = B_ * previous_x;
  for (Eigen::Index c = 0; c < contacts; ++c) {
    q[2 * c] += loading.initial_gap[c];
    q[2 * c + 1] -= place[2 * c + 1];
  }
  // The tolerances of Siconos are absolute: displacements are scaled to forces.
  const double stiffness = static_cast<double>(W_.rows()) / W_.trace();
  const Matrix scaled_W = stiffness * W_;
  const Vector scaled_q = stiffness * q;
  const std::unique_ptr<FrictionContactProblem, decltype(&frictionContactProblem_free)> problem(
      frictionContactProblem_new_with_data(
          2, static_cast<int>(contacts),
          NM_create_from_data(NM_DENSE, static_cast<int>(W_.rows()), static_cast<int>(W_.cols()),
                              copy_for_siconos(scaled_W.data(), W_.size())),
          copy_for_siconos(scaled_q.data(), q.size()), copy_for_siconos(friction_.data(), contacts)),
      frictionContactProblem_free);
  const std::unique_ptr<SolverOptions, decltype(&solver_options_delete)> settings(
      solver_options_create(identifier_of(method)), solver_options_delete);
  settings->dparam[SICONOS_DPARAM_TOL] = options.tolerance;
  settings->iparam[SICONOS_IPARAM_MAX_ITER] = options.max_iterations;

  Vector reaction = Vector::Zero(2 * contacts);
  Vector velocity = Vector::Zero(2 * contacts);
  const bool solved = fc2d_driver(problem.get(), reaction.data(), velocity.data(), settings.get()) == 0;
  state.x = unloaded + motion_ * reaction;
  state.normal_force = reaction(Eigen::seqN(0, contacts, 2));
  state.friction_force = reaction(Eigen::seqN(1, contacts, 2));
  state.gap = (W_ * reaction + q)(Eigen::seqN(0, contacts, 2));
  return solved && state.x.allFinite();
}

}  // namespace bumpfoil
