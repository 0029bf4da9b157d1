#include "support/drawn_bearings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/ensemble/draws.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

constexpr std::uint64_t seed_of_bearings = 1;

/// Accepted energy defect relative to the largest work: sums of thousands of pieces, each with round-off of 1e-16 of
/// energies that may be larger, such as those of foils with interference.
constexpr double largest_imbalance = 1e-9;
/// Gap that solvers count as zero, m.
constexpr double tolerated_gap = 1e-13;

/// Successive random numbers of a bearing.
class Draws {
 public:
  explicit Draws(std::uint64_t bearing)
      : place_{.seed = seed_of_bearings, .sample = bearing, .variable = 0, .element = 0} {}

  double probability() {
    ++place_.variable;
    return uniform_draw(place_);
  }
  double uniform(double low, double high) { return low + (high - low) * probability(); }
  /// Uniform in the logarithm.
  double decades(double low, double high) { return low * std::pow(high / low, probability()); }

 private:
  DrawPlace place_;
};

/// Change of elastic energy plus the work of contact forces, from two equilibria of linear foils, independent of the
/// path between them:
/// |     W = E_1 - E_0 - sum 1/2 (t_1 + t_0) du + 1/2 sum (p_1 g_0 - p_0 g_1)
double balanced_work(const ContactProblem& problem, const ContactState& before, const ContactState& now) {
  const Vector slip = tangential_displacements(problem, now.x) - tangential_displacements(problem, before.x);
  return 0.5 * (now.normal_force.dot(before.gap) - before.normal_force.dot(now.gap)) -
         0.5 * (now.friction_force + before.friction_force).dot(slip);
}

struct Run {
  SolverVerdict verdict;
  std::vector<Eigen::Vector2d> forces;  ///< at every `every`-th increment
};

/// A push along the direction of the case and back.
class Push {
 public:
  Push(const Case& input, const SharedBearing& foils, SolverName solver)
      : input_(input), foils_(foils), stepper_(make_stepper(foils, {.name = solver, .uzawa = {}})) {}

  Run run(int every);

 private:
  void keep(Step& next);
  void check_state(const Step& step);
  void refuse(const std::string& what) {
    if (verdict().wrong.empty()) verdict().wrong = fmt::format("increment {}: {}", increment_, what);
  }
  SolverVerdict& verdict() { return run_.verdict; }

  const Case& input_;
  const SharedBearing& foils_;
  FoilStepper stepper_;
  Step step_;
  Run run_;
  int increment_{};
  double energy_{};  ///< current elastic energy
  double start_energy_{};
  double start_dissipation_{};  ///< of the assembly
  double largest_work_{};
  double largest_force_{};  ///< of all contacts together
  double imbalance_{};      ///< largest so far
  double balanced_{};       ///< work up to the last check
};

void Push::check_state(const Step& step) {
  Increment checked;
  check_increment(*foils_, step.state, checked);
  const ContactResiduals& r = checked.residuals;
  if (!r.within(1e-9, 1e-12)) {
    refuse(fmt::format(
        "equilibrium {:.2g}, penetration {:.2g} m, slip in stick {:.2g} m, complementarity {:.2g}, cone {:.2g}",
        r.equilibrium, r.penetration, r.slip_in_stick, r.complementarity, r.cone));
  }
  energy_ = checked.elastic_energy;
  largest_force_ = std::max(largest_force_, step.state.contacts.normal_force.sum());
}

/// Checks increments that the solver reports as converged, and continues from there.
void Push::keep(Step& next) {
  verdict().status = next.status;
  verdict().substeps += next.substeps;
  if (!next.converged()) return;
  const double energy_before = energy_;
  check_state(next);
  if (increment_ == 0) {
    start_energy_ = energy_;
    start_dissipation_ = next.state.dissipated_energy;
  } else {
    largest_work_ = std::max(largest_work_, std::abs(next.state.work));
    if (next.is_linear) {
      balanced_ = energy_ - start_energy_ + next.state.dissipated_energy - start_dissipation_;
    } else if (next.substeps == 0) {
      balanced_ += energy_ - energy_before + balanced_work(foils_->problem, step_.state.contacts, next.state.contacts);
    } else {
      balanced_ = next.state.work;  // intermediate halves are unknown
    }
    imbalance_ = std::max(imbalance_, std::abs(next.state.work - balanced_));
  }
  std::swap(step_, next);
  ++increment_;
}

Run Push::run(int every) {
  const CycleSettings& cycle = input_.settings.get<CycleSettings>();
  const int steps = cycle.steps * every;
  Step next;
  stepper_.assemble({}, next);
  keep(next);
  const Excitation centre;
  Excitation full;
  full.position = cycle.amplitude.value * unit_vector(cycle.directions.front());
  for (const Excitation& end : {full, centre}) {
    if (verdict().status != Status::converged) break;
    stepper_.set_out(step_.state, end);
    for (int k = 1; k <= steps && verdict().status == Status::converged; ++k) {
      stepper_.advance_to(static_cast<double>(k) / steps, step_.state, next);
      keep(next);
      if (k % every == 0) run_.forces.push_back(holding_force(*foils_, step_.state.contacts.normal_force));
    }
  }
  const double rounding = 1e-12 * start_energy_;
  // A contact counts as closed although its gap is not exactly zero; its force then does work over this gap.
  const double closing = tolerated_gap * largest_force_;
  if (imbalance_ > largest_imbalance * largest_work_ + rounding + closing) {
    refuse(fmt::format("energies that do not balance by {:.2g} of the work", imbalance_ / largest_work_));
  }
  return std::move(run_);
}

/// Largest difference, as part of the largest force.
double distance(const std::vector<Eigen::Vector2d>& one, const std::vector<Eigen::Vector2d>& other) {
  double largest = 1.0;  // N
  double apart = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    largest = std::max(largest, other[i].norm());
    apart = std::max(apart, (one[i] - other[i]).norm());
  }
  return apart / largest;
}

}  // namespace

Case drawn_bearing(std::uint64_t number) {
  Draws draws(number);
  Case input = reference_case();
  BumpFoil& foil = input.bump_foil;
  foil.model = draws.probability() < 0.75 ? BumpFoilModel::truss : BumpFoilModel::frame;
  input.title = fmt::format("drawn bearing {}, {}", number, foil.model == BumpFoilModel::frame ? "frame" : "truss");
  const int bumps = foil.bumps;
  foil.bumps = 4 + static_cast<int>(draws.uniform(0.0, 37.0));
  input.bearing.radius *= static_cast<double>(foil.bumps) / bumps;  // the foils still cover one circumference
  foil.height_reference = HeightReference::midsurface;
  foil.height = draws.uniform(0.3e-3, 0.7e-3);
  foil.thickness = draws.decades(0.05e-3, 0.2e-3);
  input.top_foil.thickness = draws.decades(0.05e-3, 0.2e-3);
  foil.youngs_modulus = input.top_foil.youngs_modulus = draws.decades(70e9, 300e9);
  input.bearing.axial_length = draws.decades(10e-3, 100e-3);
  input.bearing.radial_clearance = draws.uniform(0.0, 60e-6);
  input.friction.top_bump = draws.uniform(0.0, 0.5);
  const double at_sleeve = draws.uniform(0.0, 0.5);
  input.friction.bump_sleeve = number % 3 == 0 ? input.friction.top_bump : at_sleeve;
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {draws.uniform(0.0, 2.0 * std::numbers::pi)};
  cycle.amplitude.value = input.bearing.radial_clearance + draws.uniform(5e-6, 50e-6);
  cycle.steps = static_cast<int>(std::lround(draws.decades(8.0, 25.0)));
  const double scatter = draws.uniform(0.0, 40e-6);
  for (int bump = 0; bump < foil.bumps; ++bump) {
    foil.height_errors.push_back(scatter * normal_quantile(draws.probability()));
  }
  return input;
}

BearingVerdict check_bearing(const Case& input, bool compared) {
  const SharedBearing foils = make_bearing_foils(input);
  const Run newton = Push(input, foils, SolverName::newton).run(1);
  const Run events = Push(input, foils, SolverName::events).run(1);
  BearingVerdict verdict{.newton = newton.verdict, .events = events.verdict, .apart = {}, .apart_refined = {}};
  const auto converged = [](const Run& run) { return run.verdict.status == Status::converged; };
  if (!compared || !converged(newton) || !converged(events)) return verdict;
  verdict.apart.emplace(distance(newton.forces, events.forces));
  if (*verdict.apart <= agreement) return verdict;
  for (const int parts : {8, 64}) {
    const Run refined = Push(input, foils, SolverName::newton).run(parts);
    verdict.apart_refined.reset();
    if (!converged(refined)) break;
    verdict.apart_refined.emplace(distance(refined.forces, events.forces));
    if (*verdict.apart_refined <= agreement) break;
  }
  return verdict;
}

}  // namespace bumpfoil
