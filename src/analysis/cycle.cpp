#include "bumpfoil/analysis/cycle.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "bumpfoil/analysis/bearing_model.hpp"
#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/uzawa.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// A contact is reported open where its load is below this part of the largest.
constexpr double open_load = 1e-9;

/// Copies the entries of one unknown of every block.
Vector pick(const Vector& x, int block_size, int unknown) {
  const Eigen::Index blocks = x.size() / block_size;
  return Eigen::Map<const Vector, 0, Eigen::InnerStride<Eigen::Dynamic>>(
      x.data() + unknown, blocks, Eigen::InnerStride<Eigen::Dynamic>(block_size));
}

/// Copies the entries of the unknowns of the feet, foot by foot.
Vector pick_feet(const Vector& x, int block_size, const std::vector<int>& unknowns) {
  const auto feet = static_cast<Eigen::Index>(unknowns.size());
  Vector out(x.size() / block_size * feet);
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out[i] = x[i / feet * block_size + unknowns[static_cast<std::size_t>(i % feet)]];
  }
  return out;
}

/// Modes as they are reported: contacts without load are open, frictionless ones slip where they move.
std::vector<ContactMode> reported_modes(const ContactProblem& problem, const ContactState& state, const Vector& slip) {
  std::vector<ContactMode> mode = state.mode;
  const double threshold = open_load * state.normal_force.maxCoeff();
  for (std::size_t c = 0; c < mode.size(); ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    const ContactPair& pair = problem.pairs[c % problem.pairs.size()];
    if (state.normal_force[i] <= threshold) {
      mode[c] = ContactMode::open;
    } else if (pair.tangential >= 0 && pair.friction_coefficient == 0.0) {
      mode[c] = slip[i] > displacement_resolution    ? ContactMode::slip_forward
                : slip[i] < -displacement_resolution ? ContactMode::slip_backward
                                                     : ContactMode::stick;
    }
  }
  return mode;
}

/// Contacts `first` .. `first + count - 1` of every block.
InterfaceFields interface_fields(const ContactProblem& problem, const Vector& gap, const ContactState& state,
                                 const std::vector<ContactMode>& mode, int first, int count) {
  const auto pairs = static_cast<int>(problem.pairs.size());
  const Eigen::Index size = Eigen::Index{problem.K.blocks()} * count;
  InterfaceFields fields{.gap = Vector(size), .normal_force = Vector(size), .friction_force = Vector(size), .mode = {}};
  fields.mode.reserve(static_cast<std::size_t>(size));
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index contact = i / count * pairs + first + i % count;
    const ContactMode m = mode[static_cast<std::size_t>(contact)];
    const bool open = m == ContactMode::open;
    fields.gap[i] = open ? std::max(0.0, gap[contact]) : 0.0;
    fields.normal_force[i] = open ? 0.0 : state.normal_force[contact];
    fields.friction_force[i] = open ? 0.0 : state.friction_force[contact];
    fields.mode.push_back(m);
  }
  return fields;
}

/// One direction of a case, increment by increment.
class CycleRunner {
 public:
  CycleRunner(const BearingModel& model, ContactSolver& solver, double direction, const CycleSettings& settings)
      : model_(model), solver_(solver), normal_(unit_vector(direction)) {
    cycle_.direction = direction;
    cycle_.amplitude = settings.amplitude;
    cycle_.steps = settings.steps;
    cycle_.increments.reserve(static_cast<std::size_t>(2 * settings.steps + 1));
  }

  /// Takes the next increment. @return false if it failed: the cycle ends there.
  bool take_increment(ContactState& state, ContactLoading& loading) {
    const int index = static_cast<int>(cycle_.increments.size());
    const int from_centre = index <= cycle_.steps ? index : 2 * cycle_.steps - index;
    const double displacement = cycle_.amplitude * from_centre / cycle_.steps;
    const ContactState previous = state;
    ContactLoading next = loading_at(model_, displacement * normal_);
    // The assembly starts from the unstressed foils: there is no loading to halve from.
    const IncrementReport report = index == 0
                                       ? IncrementReport{.solve = solver_.solve(next, previous, state), .substeps = 0}
                                       : advance(solver_, loading, next, state);
    if (!state.x.allFinite() || !state.normal_force.allFinite() || !state.friction_force.allFinite()) return false;
    loading = std::move(next);
    record(index, displacement, loading, previous, state, report);
    return cycle_.increments.back().solve.converged;
  }

  /// Derives the quantities of the cycle from its increments.
  Cycle finish(const std::vector<ContactMode>& modes_at_turning_point) {
    const std::vector<Increment>& increments = cycle_.increments;
    const auto all = static_cast<std::size_t>(2 * cycle_.steps + 1);
    const auto good = static_cast<std::size_t>(std::count_if(
        increments.begin(), increments.end(), [](const Increment& increment) { return increment.solve.converged; }));
    cycle_.converged = good == all;
    if (good > 0) {
      cycle_.first_contact = first_contact_displacement(model_, increments.front().top_displacement, normal_);
      cycle_.clearance_5N = clearance_at(increments, 5.0);
      cycle_.clearance_10N = clearance_at(increments, 10.0);
    }
    if (good > static_cast<std::size_t>(cycle_.steps)) {
      const Increment& turning = cycle_.at_turning_point();
      const TangentStiffnesses tangent = tangent_stiffnesses(model_, modes_at_turning_point, normal_);
      cycle_.turning_point = TurningPoint{.max_force = turning.force_direct,
                                          .cross_force = turning.force_cross,
                                          .elastic_energy = turning.elastic_energy,
                                          .tangent_stiffness_loading = tangent.loading,
                                          .tangent_stiffness_unloading = tangent.unloading,
                                          .secant_stiffness = turning.force_direct / cycle_.amplitude};
    }
    if (good == all) {
      cycle_.loop_energy = increments.back().work;
      cycle_.loss_factor =
          loss_factor(*cycle_.loop_energy, cycle_.turning_point->elastic_energy - increments.front().elastic_energy);
    }
    return std::move(cycle_);
  }

 private:
  void record(int index, double displacement, const ContactLoading& loading, const ContactState& previous,
              const ContactState& state, const IncrementReport& report) {
    Increment next;
    next.index = index;
    next.branch = index <= cycle_.steps ? Branch::loading : Branch::unloading;
    next.displacement = displacement;
    next.x = displacement * normal_.x();
    next.y = displacement * normal_.y();
    const Eigen::Vector2d force = journal_force(model_.phi, journal_loads(model_, state.normal_force));
    next.force_x = force.x();
    next.force_y = force.y();
    next.force_direct = force.dot(normal_);
    next.force_cross = force.dot(Eigen::Vector2d(-normal_.y(), normal_.x()));

    const Vector elastic = elastic_forces(model_.structure, state.x);
    next.elastic_energy = elastic_energy(model_.structure, state.x);
    next.residuals = contact_residuals(model_.problem, elastic, loading, previous.x, state);
    next.solve = report.solve;
    next.substeps = report.substeps;

    const Vector slip =
        tangential_displacements(model_.problem, state.x) - tangential_displacements(model_.problem, previous.x);
    add_energies(next, state, slip);

    const int block = model_.problem.K.block_size();
    const BumpDofs& dofs = model_.structure.dofs;
    next.top_displacement = pick(state.x, block, dofs.top_u);
    next.crest_u = pick(state.x, block, dofs.crest_u);
    next.crest_v = pick(state.x, block, dofs.crest_v);
    next.foot_u = pick_feet(state.x, block, dofs.foot_u);
    next.foot_v = pick_feet(state.x, block, dofs.foot_v);
    const std::vector<ContactMode> mode = reported_modes(model_.problem, state, slip);
    const Vector gap = contact_gaps(model_.problem, loading.initial_gap, state.x);
    const auto fields = [&](int first, int count) {
      return interface_fields(model_.problem, gap, state, mode, first, count);
    };
    next.journal_top = fields(BearingModel::journal_top, 1);
    next.top_bump = fields(BearingModel::top_bump, 1);
    next.bump_sleeve = fields(BearingModel::first_foot, dofs.feet());
    cycle_.increments.push_back(std::move(next));
  }

  /// Work by the trapezoidal rule and friction dissipation f p |du|, both since increment 0.
  void add_energies(Increment& next, const ContactState& state, const Vector& slip) {
    double dissipation = 0.0;
    for (Eigen::Index c = 0; c < slip.size(); ++c) {
      const ContactPair& pair = model_.problem.pairs[static_cast<std::size_t>(c) % model_.problem.pairs.size()];
      dissipation += pair.friction_coefficient * state.normal_force[c] * std::abs(slip[c]);
    }
    if (cycle_.increments.empty()) {
      cycle_.assembly_dissipation = dissipation;
      return;
    }
    const Increment& last = cycle_.increments.back();
    next.dissipated_energy = last.dissipated_energy + dissipation;
    next.work = last.work + 0.5 * ((next.force_x + last.force_x) * (next.x - last.x) +
                                   (next.force_y + last.force_y) * (next.y - last.y));
  }

  const BearingModel& model_;
  ContactSolver& solver_;
  Eigen::Vector2d normal_;
  Cycle cycle_;
};

std::unique_ptr<ContactSolver> make_solver(const SolverSettings& settings, const ContactProblem& problem) {
  if (settings.name == SolverName::uzawa) {
    const UzawaParameters& given = settings.uzawa;
    return std::make_unique<UzawaSolver>(
        problem,
        UzawaOptions{.eps_alm = given.eps_alm, .eps_f = given.eps_f, .eps_r = given.eps_r, .tau_f = given.tau_f});
  }
  return std::make_unique<NewtonSolver>(problem);
}

}  // namespace

double Cycle::initial_journal_load() const {
  return increments.empty() ? 0.0 : increments.front().journal_top.normal_force.sum();
}

double Cycle::max_residual() const {
  double largest = 0.0;
  for (const Increment& increment : increments) largest = std::max(largest, increment.residuals.equilibrium);
  return largest;
}

SolveReport Cycle::total() const {
  SolveReport sum;
  for (const Increment& increment : increments) sum += increment.solve;
  return sum;
}

int Cycle::substeps() const {
  int sum = 0;
  for (const Increment& increment : increments) sum += increment.substeps;
  return sum;
}

bool CycleResult::converged() const {
  return std::all_of(cycles.begin(), cycles.end(), [](const Cycle& cycle) { return cycle.converged; });
}

CycleResult run_cycles(const Case& input, const ProgressCallback& progress) {
  const BearingModel model = make_bearing_model(input);
  const std::unique_ptr<ContactSolver> solver = make_solver(input.solver, model.problem);
  CycleResult result{.solver = std::string(solver->name()), .cycles = {}};
  const auto increments = static_cast<std::size_t>(2 * input.cycle.steps + 1);
  bool stopped = false;
  for (const double direction : input.cycle.directions) {
    const auto start = std::chrono::steady_clock::now();
    CycleRunner runner(model, *solver, direction, input.cycle);
    ContactState state = ContactState::unstressed(model.problem);
    ContactLoading loading;
    std::vector<ContactMode> modes_at_turning_point;
    for (std::size_t k = 0; k < increments && !stopped; ++k) {
      if (!runner.take_increment(state, loading)) break;
      if (k == static_cast<std::size_t>(input.cycle.steps)) modes_at_turning_point = state.mode;
      const double done =
          static_cast<double>(result.cycles.size()) + static_cast<double>(k + 1) / static_cast<double>(increments);
      stopped = progress && !progress(done / static_cast<double>(input.cycle.directions.size()));
    }
    result.cycles.push_back(runner.finish(modes_at_turning_point));
    result.cycles.back().wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (stopped) break;
  }
  return result;
}

}  // namespace bumpfoil
