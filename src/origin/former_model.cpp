#include "bumpfoil/origin/former_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/penalty_system.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/structure/single_bump.hpp"

namespace bumpfoil {
namespace {

constexpr double least_displacement = 1e-13;  // m
constexpr double force_tolerance = 1e-11;     // relative to the largest normal force, or least_reference_force()
constexpr double balance_tolerance = 1e-6;    // the same if forces only determine modes
constexpr int rounds_at_first = 12;
constexpr int rounds_after_approach = 6;
constexpr int max_outer_iterations = 200;
constexpr int max_newton_steps = 100;

/// Slip mode of a contact from the signs of its normal force and its displacement. The modes of the linear system
/// assume compression, t = -+f N: under tension they are exchanged.
ContactMode mode_of_system(bool forward, double normal_force) {
  return forward == (normal_force > 0.0) ? ContactMode::slip_forward : ContactMode::slip_backward;
}

/// Penalty of the augmented Lagrangian: the stiffness of the stiffest crest between held feet, N/m. It affects speed,
/// not the result. If it is much larger than the stiffness of the foil, friction bounds follow their normal forces
/// immediately and oscillate endlessly at strong friction, and round-off exceeds the smaller forces of soft foils.
double make_penalty(const FoilStructure& structure) {
  double stiffest = 0.0;
  for (const Matrix& block : structure.K.diagonal) {
    stiffest = std::max(stiffest, block(structure.dofs.crest_v, structure.dofs.crest_v));
  }
  return stiffest;
}

Vector list_or_zeros(const std::vector<double>& list, int size) {
  if (list.empty()) return Vector::Zero(size);
  return Eigen::Map<const Vector>(list.data(), static_cast<Eigen::Index>(list.size()));
}

/// Gaps that the contacts must close; infinite for crests that the journal does not reach.
ContactLoading loading_under(const FormerModel& model, const Eigen::Vector2d& position) {
  ContactLoading loading{.initial_gap = Vector(model.problem.contacts()), .load = Vector::Zero(model.problem.K.rows())};
  const Vector gap = former_crest_gaps(model, position);
  for (Eigen::Index i = 0; i < gap.size(); ++i) {
    loading.initial_gap[2 * i + FormerModel::crest] = gap[i] < 0.0 ? gap[i] : std::numeric_limits<double>::infinity();
    loading.initial_gap[2 * i + FormerModel::foot] = model.sleeve_gaps[i];
  }
  return loading;
}

}  // namespace

FormerModel make_former_model(const Case& input) {
  require_bearing(input, {"cycle"});
  const int bumps = input.bump_foil.bumps;
  FormerModel model;
  model.bearing = input.bearing;
  const FoilDesign foils = make_bearing_design(input);
  model.structure = make_foil_structure(foils);
  model.normals = outward_normals(polar_angles(input.bearing, crest_angles(input)));
  model.height_errors = crest_offsets(input.bump_foil);
  model.sleeve_gaps = list_or_zeros(input.bump_foil.sleeve_gaps, bumps);
  const BumpDofs& dofs = model.structure.dofs;
  model.problem.K = model.structure.K;
  model.problem.force_scale = bump_force_scale(foils);
  model.problem.sites = in_every_block(
      {{.plus = dofs.crest_v, .tangential = dofs.crest_u, .friction_coefficient = input.friction.top_bump},
       {.minus = dofs.foot_v.front(),
        .tangential = dofs.foot_u.front(),
        .friction_coefficient = input.friction.bump_sleeve}},
      model.problem.K.blocks());
  return model;
}

Vector former_crest_gaps(const FormerModel& model, const Eigen::Vector2d& position) {
  return journal_gaps(model.bearing.radial_clearance, model.normals, position) - model.height_errors;
}

Eigen::Vector2d former_journal_force(const FormerModel& model, const ContactState& state) {
  return journal_force(model.normals, state.normal_force(Eigen::seqN(FormerModel::crest, model.bumps(), 2)));
}

ContactResiduals former_residuals(const FormerModel& model, const Eigen::Vector2d& position,
                                  const ContactState& state) {
  // Friction depends on |N| only; the difference to N is applied as a load.
  ContactState checked = state;
  checked.normal_force = state.normal_force.cwiseAbs();
  ContactLoading balanced = loading_under(model, position);
  balanced.load +=
      contact_forces(model.problem, state.normal_force - checked.normal_force, Vector::Zero(model.problem.contacts()));
  return contact_residuals(model.problem, elastic_response(model.structure, state.x).forces, balanced,
                           Vector::Zero(state.x.size()), checked);
}

/// Unknowns, multipliers and friction bounds of the augmented Lagrangian, and derived quantities.
struct FormerSolver::TrescaState {
  TrescaState(Eigen::Index contacts, Eigen::Index rows)
      : x(Vector::Zero(rows)),
        gradient(x),
        lambda(Vector::Zero(contacts)),
        mu(lambda),
        bound(lambda),
        p(lambda),
        t(lambda),
        normal_stiffness(lambda),
        tangential_stiffness(lambda) {}

  Vector x, gradient;
  Vector lambda, mu, bound;
  Vector p, t, normal_stiffness, tangential_stiffness;
};

FormerSolver::~FormerSolver() = default;

FormerSolver::FormerSolver(const FormerModel& model)
    : model_(model),
      penalty_(make_penalty(model.structure)),
      modes_(make_mode_system(model.problem)),
      penalties_(make_penalty_system(model.problem)) {}

FormerSolution FormerSolver::solve(const Eigen::Vector2d& position) {
  const ContactLoading loading = loading_under(model_, position);
  FormerSolution solution;
  ContactState& state = solution.state;
  state = ContactState::unstressed(model_.problem);
  for (std::size_t c = 0; c < state.mode.size(); ++c) {
    const bool held = std::isfinite(loading.initial_gap[static_cast<Eigen::Index>(c)]);
    state.mode[c] = held ? ContactMode::stick : ContactMode::open;
  }
  const bool solved = iterate_modes(loading, rounds_at_first, solution) || approach(loading, solution);
  solution.report.status = solved ? Status::converged : Status::no_modes;
  solution.residuals = former_residuals(model_, position, state);
  state.gap(Eigen::seqN(FormerModel::crest, model_.bumps(), 2)) =
      former_crest_gaps(model_, position) + state.x(Eigen::seqN(model_.structure.dofs.crest_v, model_.bumps(), 4));
  return solution;
}

/// Exact solves from the modes and the signs of normal forces in the solution, with changes of contradicting ones. If
/// the rounds are used up, restores these and keeps the last iterate of all else.
bool FormerSolver::iterate_modes(const ContactLoading& loading, int rounds, FormerSolution& solution) {
  ContactState& state = solution.state;
  const Vector unstressed = Vector::Zero(state.x.size());
  std::vector<ContactMode> mode = state.mode;
  std::vector<ContactMode> of_system = mode;
  Vector sense = state.normal_force;
  for (int round = 0; round < rounds; ++round) {
    for_each_contact(model_.problem, [&](const CoulombContact& c) {
      const ContactMode m = mode[static_cast<std::size_t>(c.index)];
      of_system[static_cast<std::size_t>(c.index)] =
          slips(m) ? mode_of_system(m == ContactMode::slip_forward, sense[c.index]) : m;
    });
    const int factorisations = modes_->factorisations();
    if (!modes_->set_modes(of_system)) return false;
    solution.report.cost.factorisations += modes_->factorisations() - factorisations;
    modes_->solve(loading, unstressed, state);
    ++solution.report.cost.iterations;
    const double negligible =
        force_tolerance * std::max(model_.problem.least_reference_force(), state.normal_force.cwiseAbs().maxCoeff());
    bool changed = false;
    for_each_contact(model_.problem, [&](const CoulombContact& c) {
      ContactMode& m = mode[static_cast<std::size_t>(c.index)];
      const double normal = state.normal_force[c.index];
      const double friction = state.friction_force[c.index];
      const double u = c.tangential(state.x);
      if (m == ContactMode::open || c.f == 0.0) return;
      if (m == ContactMode::stick) {
        if (std::abs(friction) - c.f * std::abs(normal) <= negligible) return;
        m = slip_mode(-friction);
        sense[c.index] = normal;
      } else {
        if (std::abs(normal) <= negligible) return;
        if ((normal > 0.0) != (sense[c.index] > 0.0)) {
          sense[c.index] = normal;
        } else if (std::abs(u) > least_displacement && m != slip_mode(u)) {
          m = ContactMode::stick;
        } else {
          return;
        }
      }
      changed = true;
    });
    state.mode = mode;
    if (!changed) return true;
  }
  return false;
}

/// Proximal augmented Lagrangian with fixed friction bounds in the displacement solve: this energy is convex for any
/// bounds. Its modes are the guess for the exact solves, which decide.
bool FormerSolver::approach(const ContactLoading& loading, FormerSolution& solution) {
  TrescaState s(model_.problem.contacts(), model_.problem.K.rows());
  for (int outer = 0; outer < max_outer_iterations; ++outer) {
    if (!minimise(loading, s, solution.report.cost)) return false;
    ++solution.report.cost.outer_iterations;
    for_each_contact(model_.problem, [&](const CoulombContact& c) {
      const Eigen::Index i = c.index;
      ContactMode& m = solution.state.mode[static_cast<std::size_t>(i)];
      s.lambda[i] = s.p[i];
      if (m != ContactMode::open) m = std::abs(s.t[i]) < s.bound[i] ? ContactMode::stick : slip_mode(-s.t[i]);
      s.bound[i] = c.f * std::abs(s.p[i]);
      s.mu[i] = std::clamp(s.t[i], -s.bound[i], s.bound[i]);
    });
    solution.state.normal_force = s.p;
    if (iterate_modes(loading, rounds_after_approach, solution)) return true;
  }
  return false;
}

/// Displacements for the multipliers and friction bounds of `s`, by Newton's method.
bool FormerSolver::minimise(const ContactLoading& loading, TrescaState& s, SolveCost& cost) {
  evaluate(loading, s);
  for (int step_number = 0; step_number < max_newton_steps; ++step_number) {
    if (!penalties_->set_stiffness(s.normal_stiffness, s.tangential_stiffness)) return false;
    ++cost.factorisations;
    const Vector start = s.x;
    Vector step = -s.gradient;
    penalties_->solve_in_place(step);
    ++cost.iterations;
    // The slope of the energy along the step is positive: halve until it is close to zero.
    const double slope = step.dot(s.gradient);
    for (double length = 1.0; length > 1e-9; length *= 0.5) {
      s.x = start + length * step;
      evaluate(loading, s);
      if (step.dot(s.gradient) <= -0.5 * slope) break;
    }
    if (s.gradient.cwiseAbs().maxCoeff() <= balance_tolerance * s.p.cwiseAbs().maxCoeff()) return true;
  }
  return false;
}

/// Forces at x, their stiffnesses and the imbalance.
void FormerSolver::evaluate(const ContactLoading& loading, TrescaState& s) {
  s.gradient = penalties_->multiply(s.x) - loading.load;
  for_each_contact(model_.problem, [&](const CoulombContact& c) {
    const Eigen::Index i = c.index;
    s.p[i] = s.t[i] = s.normal_stiffness[i] = s.tangential_stiffness[i] = 0.0;
    if (std::isinf(loading.initial_gap[i])) return;
    s.normal_stiffness[i] = penalty_;
    s.p[i] = s.lambda[i] - penalty_ * (loading.initial_gap[i] + c.gap(s.x));
    const double trial = s.mu[i] - penalty_ * c.tangential(s.x);
    s.t[i] = std::clamp(trial, -s.bound[i], s.bound[i]);
    if (std::abs(trial) < s.bound[i]) s.tangential_stiffness[i] = penalty_;
    c.add_forces(s.p[i], s.t[i], -1.0, s.gradient);
  });
}

std::optional<double> FormerSolver::tangent_stiffness(const ContactState& state, const Eigen::Vector2d& direction) {
  std::vector<ContactMode> mode = state.mode;
  ContactLoading rate{.initial_gap = Vector::Zero(model_.problem.contacts()),
                      .load = Vector::Zero(model_.problem.K.rows())};
  for_each_contact(model_.problem, [&](const CoulombContact& c) {
    ContactMode& m = mode[static_cast<std::size_t>(c.index)];
    if (slips(m)) m = mode_of_system(m == ContactMode::slip_forward, state.normal_force[c.index]);
  });
  rate.initial_gap(Eigen::seqN(FormerModel::crest, model_.bumps(), 2)) =
      former_crest_gaps(model_, direction) - former_crest_gaps(model_, Eigen::Vector2d::Zero());
  if (!modes_->set_modes(mode)) return std::nullopt;
  ContactState response = ContactState::unstressed(model_.problem);
  const Vector at_rest = response.x;
  modes_->solve(rate, at_rest, response);
  return former_journal_force(model_, response).dot(direction);
}

}  // namespace bumpfoil
