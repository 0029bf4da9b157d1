#include "support/dense_contacts.hpp"

#include <Eigen/LU>
#include <cmath>

namespace bumpfoil {
namespace {

bool has_friction(const DenseContacts& contacts, Eigen::Index c) {
  return contacts.friction[c] > 0.0 && !contacts.tangential.row(c).isZero();
}

/// Whether a state solved for `mode` obeys the inequalities of the modes.
bool obeys(const DenseContacts& contacts, const ContactLoading& loading, const Vector& previous_x,
           const std::vector<ContactMode>& mode, const DenseState& state, double tolerance) {
  if (!state.x.allFinite()) return false;
  const Vector gap = loading.initial_gap + contacts.normal * state.x;
  const Vector slip = contacts.tangential * (state.x - previous_x);
  for (Eigen::Index c = 0; c < gap.size(); ++c) {
    const double bound = contacts.friction[c] * state.normal_force[c] + tolerance;
    switch (mode[static_cast<std::size_t>(c)]) {
      case ContactMode::open:
        if (gap[c] < -tolerance) return false;
        continue;
      case ContactMode::stick:
        if (std::abs(state.friction_force[c]) > bound) return false;
        break;
      case ContactMode::slip_forward:
        if (slip[c] < -tolerance) return false;
        break;
      case ContactMode::slip_backward:
        if (slip[c] > tolerance) return false;
        break;
    }
    if (state.normal_force[c] < -tolerance) return false;
  }
  return true;
}

}  // namespace

DenseContacts make_dense(const ContactProblem& problem) {
  const Eigen::Index contacts = problem.contacts();
  DenseContacts dense{.K = problem.K.dense(),
                      .normal = Matrix::Zero(contacts, problem.K.rows()),
                      .tangential = Matrix::Zero(contacts, problem.K.rows()),
                      .friction = Vector::Zero(contacts)};
  Eigen::Index c = 0;
  for (const ContactSite& site : problem.sites) {
    const Eigen::Index row = Eigen::Index{site.block} * problem.K.block_size();
    if (site.plus >= 0) dense.normal(c, row + site.plus) = 1.0;
    if (site.minus >= 0) dense.normal(c, row + site.minus) = -1.0;
    if (site.tangential >= 0) dense.tangential(c, row + site.tangential) = 1.0;
    dense.friction[c] = site.friction_coefficient;
    ++c;
  }
  return dense;
}

DenseState solve_dense(const DenseContacts& contacts, const ContactLoading& loading, const Vector& previous_x,
                       const std::vector<ContactMode>& mode) {
  const Eigen::Index n = contacts.K.rows();
  const Eigen::Index m = contacts.normal.rows();
  // Unknowns x, p / scale, t / scale: multipliers of the size of displacements keep the pivots comparable.
  const double scale = contacts.K.diagonal().maxCoeff();
  Matrix system = Matrix::Identity(n + 2 * m, n + 2 * m) * scale;  // p = 0 and t = 0 by default
  Vector right = Vector::Zero(n + 2 * m);
  system.topLeftCorner(n, n) = contacts.K;
  right.head(n) = loading.load;
  for (Eigen::Index c = 0; c < m; ++c) {
    const ContactMode kind = mode[static_cast<std::size_t>(c)];
    if (kind == ContactMode::open) continue;
    const Eigen::Index p = n + c;
    const Eigen::Index t = n + m + c;
    system.col(p).head(n) = -scale * contacts.normal.row(c).transpose();
    system.row(p).setZero();
    system.row(p).head(n) = scale * contacts.normal.row(c);
    right[p] = -scale * loading.initial_gap[c];
    if (!has_friction(contacts, c)) continue;
    system.col(t).head(n) = -scale * contacts.tangential.row(c).transpose();
    if (kind == ContactMode::stick) {
      system.row(t).setZero();
      system.row(t).head(n) = scale * contacts.tangential.row(c);
      right[t] = scale * contacts.tangential.row(c).dot(previous_x);
    } else {
      system(t, p) = (kind == ContactMode::slip_forward ? scale : -scale) * contacts.friction[c];
    }
  }
  const Eigen::PartialPivLU<Matrix> lu(system);
  Vector solution = lu.solve(right);
  solution += lu.solve(right - system * solution);  // one refinement, as this is the reference
  return {.x = solution.head(n),
          .normal_force = scale * solution.segment(n, m),
          .friction_force = scale * solution.tail(m)};
}

std::vector<DenseState> enumerate_solutions(const DenseContacts& contacts, const ContactLoading& loading,
                                            const Vector& previous_x, double tolerance) {
  constexpr ContactMode kinds[] = {ContactMode::open, ContactMode::stick, ContactMode::slip_forward,
                                   ContactMode::slip_backward};
  const auto m = static_cast<std::size_t>(contacts.normal.rows());
  std::vector<DenseState> solutions;
  std::vector<std::size_t> digit(m, 0);
  std::vector<ContactMode> mode(m, ContactMode::open);
  for (bool more = true; more;) {
    const DenseState state = solve_dense(contacts, loading, previous_x, mode);
    if (obeys(contacts, loading, previous_x, mode, state, tolerance)) solutions.push_back(state);
    // Increments the combination: the mode of contact c is a digit.
    more = false;
    for (std::size_t c = 0; c < m && !more; ++c) {
      const std::size_t digits = has_friction(contacts, static_cast<Eigen::Index>(c)) ? 4 : 2;
      digit[c] = (digit[c] + 1) % digits;
      mode[c] = kinds[digit[c]];
      more = digit[c] != 0;
    }
  }
  return solutions;
}

}  // namespace bumpfoil
