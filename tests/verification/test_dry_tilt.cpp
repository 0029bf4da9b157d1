// docs/verification/width.md: the bearing without a film and with a tilted journal, against an independent program.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <ostream>
#include <vector>

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "support/cycle_energies.hpp"

namespace bumpfoil {
namespace {

constexpr double length = 38.1e-3;

/// Result of pushing the journal to +X until it carries 100 N.
struct Pushed {
  double x{};
  double moment{};                     ///< N m
  std::vector<double> loads, moments;  ///< of bumps 9 to 19, N and N m
};

/// The reference bearing with a frame as bump foil. As in the independent program, the top foil is bonded to the crests
/// and feet never lift; the contact of the journal is unilateral.
/// @param stuck  feet do not slide either
/// @param tilt   over the width towards X, m
Pushed pushed(bool stuck, int modes, double tilt) {
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.friction = {.top_bump = 0.0, .bump_sleeve = stuck ? 0.1 : 0.0};
  const BearingModel foils = on_lines(make_foils(input), modes, {.slope = Eigen::Vector2d(tilt / length, 0.0)});
  const auto system = make_mode_system(foils.problem);
  std::vector<ContactMode> contacts(static_cast<std::size_t>(foils.problem.contacts()), ContactMode::stick);
  const int lines = foils.crest_contacts();
  const int per_block = foils.contacts_per_block();
  const auto is_journal = [&](int contact) { return contact % per_block < lines; };
  for (int c = 0; c < foils.problem.contacts(); ++c) {
    if (is_journal(c)) contacts[static_cast<std::size_t>(c)] = ContactMode::open;
  }
  ContactState state = ContactState::unstressed(foils.problem);
  const Vector at_rest = Vector::Zero(foils.problem.K.rows());
  const auto force_at = [&](double x) {
    const ContactLoading loading = loading_under(foils, {.position = {x, 0.0}});
    for (bool changed = true; changed;) {
      EXPECT_TRUE(system->set_modes(contacts));
      system->solve(loading, at_rest, state);
      changed = false;
      for (int c = 0; c < foils.problem.contacts(); ++c) {
        if (!is_journal(c)) continue;
        ContactMode& mode = contacts[static_cast<std::size_t>(c)];
        const bool closed = mode != ContactMode::open;
        if (closed ? state.normal_force[c] >= 0.0 : state.gap[c] >= 0.0) continue;
        mode = closed ? ContactMode::open : ContactMode::stick;
        changed = true;
      }
    }
    return holding_force(foils, state.normal_force).x();
  };
  double below = 30e-6;
  double above = 50e-6;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (force_at(middle) < 100.0 ? below : above) = middle;
  }
  Pushed found{.x = below, .moment = holding_moment(foils, state.normal_force).x(), .loads = {}, .moments = {}};
  for (int bump = 8; bump < 19; ++bump) {
    double load = 0.0;
    double moment = 0.0;
    for (int s = 0; s < lines; ++s) {
      const double part = state.normal_force[bump * per_block + s];
      load += part;
      moment += 0.5 * length * foils.lines[static_cast<std::size_t>(s)].zeta * part;
    }
    found.loads.push_back(load);
    found.moments.push_back(moment);
  }
  return found;
}

struct TiltReference {
  bool stuck{};
  int modes{};
  double tilt{}, x{}, moment{}, of_shell{};   ///< um, um, N mm, N mm
  std::array<double, 11> loads{}, moments{};  ///< N, N mm
};
constexpr std::array<double, 11> loads_free{0, 0, 8.0491, 18.742, 24.142, 24.61, 20.045, 10.466, 0, 0, 0};
constexpr std::array<double, 11> moments_free{0, 0, 27.724, 29.117, 31.431, 31.599, 29.585, 28.592, 0, 0, 0};
constexpr TiltReference tilt_references[]{
    {false, 2, 0.0, 44.21150185789828, 0.0, 0.0, loads_free, {}},
    {false, 3, 0.0, 44.211501857895776, 0.0, 0.0, loads_free, {}},
    {false, 2, 5.0, 44.21150185789828, 163.97068391876797, 165.00947437869084, loads_free, moments_free},
    {false, 3, 5.0, 44.211501854851164, 163.9706839188115, 165.00947437869084, loads_free, moments_free},
    {true, 3, 0.0, 33.99564012360373, 0.0, 0.0, {0, 0, 0, 0, 45.332, 49.654, 6.0512, 0, 0, 0, 0}, {}},
    {true,
     2,
     5.0,
     33.6399794737828,
     1015.5687123471024,
     0.0,
     {0, 0, 0, 9.0028, 36.62, 40.887, 15.586, 0, 0, 0, 0},
     {0, 0, 0, 99.018, 383.36, 384.31, 171.42, 0, 0, 0, 0}},
    {true,
     3,
     5.0,
     33.637601198365644,
     977.269259536153,
     962.8136637136656,
     {0, 0, 0, 8.2034, 39.286, 42.446, 11.929, 0, 0, 0, 0},
     {0, 0, 0, 121.05, 342.94, 361.13, 176.02, 0, 0, 0, 0}},
    {false, 4, 5.0, 44.21150184790254, 163.97068391883244, 165.00947437869084, loads_free, moments_free},
    {true,
     4,
     5.0,
     33.61743029017951,
     946.5250196358301,
     962.8136637136656,
     {0, 0, 0, 7.1354, 38.744, 42.292, 13.712, 0, 0, 0, 0},
     {0, 0, 0, 105.43, 339.83, 352.64, 171.02, 0, 0, 0, 0}}};

TEST(DryTilt, IsWhatTheIndependentProgramFinds) {
  for (const TiltReference& reference : tilt_references) {
    const Pushed found = pushed(reference.stuck, reference.modes, 1e-6 * reference.tilt);
    SCOPED_TRACE(testing::Message() << "stuck " << reference.stuck << ", modes " << reference.modes << ", tilt "
                                    << reference.tilt);
    EXPECT_NEAR(1e6 * found.x, reference.x, 1e-5);
    EXPECT_NEAR(1e3 * found.moment, reference.moment, 5e-6 * std::max(reference.moment, 1.0));
    if (reference.of_shell > 0.0) {
      EXPECT_NEAR(1e3 * found.moment, reference.of_shell, 0.02 * reference.of_shell);
    }
    for (std::size_t i = 0; i < found.loads.size(); ++i) {
      EXPECT_NEAR(found.loads[i], reference.loads[i], 1e-3) << "bump " << i + 9;
      EXPECT_NEAR(1e3 * found.moments[i], reference.moments[i], 2e-2) << "bump " << i + 9;
    }
  }
}

/// Foils on a circle, or three pads with top foils formed to a larger radius.
Case some_case(bool pads, double friction) {
  Case input = reference_case();
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  if (!pads) return input;
  input.bump_foil.bumps = 8;
  input.pads.resize(3);
  input.top_foil.formed_radius = {.to = FormedTo::seated};
  return input;
}

/// Moves the journal from the assembled state through `places`.
Increment taken(const BearingModel& foils, const std::vector<Eigen::Vector2d>& places) {
  FoilStepper stepper = make_stepper(std::make_shared<const BearingModel>(foils), {});
  Step step;
  stepper.assemble({}, step);
  for (const Eigen::Vector2d& place : places) {
    const BearingState from = step.state;
    stepper.advance(from, {.position = place}, step);
    EXPECT_TRUE(step.converged());
  }
  Increment last = place_increment(foils, step, Eigen::Vector2d::UnitX());
  check_increment(foils, step.state, last);
  EXPECT_TRUE(last.residuals.within());
  return last;
}

/// Model of the foils over the width.
struct OverWidth {
  int modes{};
  SheetModel sheet{};

  friend std::ostream& operator<<(std::ostream& out, const OverWidth& one) {
    return out << "modes " << one.modes << ", elastic sheet " << (one.sheet == SheetModel::elastic);
  }
};
constexpr OverWidth all_over_width[]{
    {2, SheetModel::held}, {3, SheetModel::held}, {3, SheetModel::elastic}, {5, SheetModel::elastic}};

const std::vector<Eigen::Vector2d> there{{40e-6, 5e-6}, {60e-6, -10e-6}};

TEST(DryTilt, MomentsAndForcesAreDerivativesOfTheEnergyWithoutFriction) {
  for (const bool pads : {false, true}) {
    const BearingModel uniform = make_foils(some_case(pads, 0.0));
    const Eigen::Vector2d slope(3e-4, -2e-4);
    for (const OverWidth& over_width : all_over_width) {
      SCOPED_TRACE(testing::Message() << "pads " << pads << ", " << over_width);
      const auto at = [&](const Eigen::Vector2d& tilted, const Eigen::Vector2d& place) {
        return taken(on_lines(uniform, over_width.modes, {.slope = tilted}, over_width.sheet), {place});
      };
      const Eigen::Vector2d place = there.back();
      const Increment here = at(slope, place);
      const auto difference = [&](auto&& energy, double step) { return (energy(step) - energy(-step)) / (2.0 * step); };
      const auto by_slope = [&](int axis) {
        return difference(
            [&](double step) { return at(slope + step * Eigen::Vector2d::Unit(axis), place).elastic_energy; }, 1e-8);
      };
      const auto by_place = [&](int axis) {
        return difference(
            [&](double step) { return at(slope, place + step * Eigen::Vector2d::Unit(axis)).elastic_energy; }, 1e-10);
      };
      const double moment = std::hypot(here.moment_x, here.moment_y);
      EXPECT_GT(moment, 0.1);
      EXPECT_NEAR(by_slope(0), here.moment_x, 1e-6 * moment);
      EXPECT_NEAR(by_slope(1), here.moment_y, 1e-6 * moment);
      const double force = std::hypot(here.force_x, here.force_y);
      EXPECT_NEAR(by_place(0), here.force_x, 1e-6 * force);
      EXPECT_NEAR(by_place(1), here.force_y, 1e-6 * force);
    }
  }
}

/// A cone narrows one side and widens the other by as much, a barrel widens both: energy falls by the loads there.
TEST(DryTilt, WideningsAreWorkedAgainstLikeTilts) {
  const BearingModel uniform = make_foils(some_case(true, 0.0));
  const Eigen::Vector2d place = there.back();
  const auto energy_at = [&](const WidthProfile& profile) {
    return taken(on_lines(uniform, 3, {.slope = {3e-4, 0.0}, .profile = profile}), {place}).elastic_energy;
  };
  const WidthProfile profile{.conicity = 6e-6, .crowning = -4e-6};
  const BearingModel foils = on_lines(uniform, 3, {.slope = {3e-4, 0.0}, .profile = profile});
  FoilStepper stepper = make_stepper(std::make_shared<const BearingModel>(foils), {});
  Step assembled, pressed;
  stepper.assemble({}, assembled);
  stepper.advance(assembled.state, {.position = place}, pressed);
  ASSERT_TRUE(pressed.converged());
  double by_cone = 0.0;
  double by_barrel = 0.0;
  for (std::size_t s = 0; s < foils.lines.size(); ++s) {
    const double load = pressed.state.contacts.normal_force(foils.pressed(static_cast<int>(s))).sum();
    by_cone -= 0.5 * foils.lines[s].zeta * load;
    by_barrel -= foils.lines[s].zeta * foils.lines[s].zeta * load;
  }
  EXPECT_GT(std::abs(by_cone), 1.0);
  const double step = 1e-10;
  const auto difference = [&](double cone, double barrel) {
    const auto moved = [&](double sign) {
      return energy_at({.conicity = profile.conicity + sign * cone, .crowning = profile.crowning + sign * barrel});
    };
    return (moved(1.0) - moved(-1.0)) / (2.0 * step);
  };
  EXPECT_NEAR(difference(step, 0.0), by_cone, 1e-6 * std::abs(by_barrel));
  EXPECT_NEAR(difference(0.0, step), by_barrel, 1e-6 * std::abs(by_barrel));
}

TEST(DryTilt, IsMirroredWithTheBearing) {
  const BearingModel uniform = make_foils(some_case(true, 0.1));
  const Eigen::Vector2d slope(3e-4, -2e-4);
  const WidthProfile cone{.conicity = 5e-6, .crowning = 3e-6};
  const WidthProfile turned{.conicity = -5e-6, .crowning = 3e-6};
  for (const SheetModel sheet : {SheetModel::held, SheetModel::elastic}) {
    const Increment one = taken(on_lines(uniform, 3, {.slope = slope, .profile = cone}, sheet), there);
    const Increment other = taken(on_lines(uniform, 3, {.slope = -slope, .profile = turned}, sheet), there);
    EXPECT_NEAR(one.force_x, other.force_x, 1e-9 * one.force_x);
    EXPECT_NEAR(one.force_y, other.force_y, 1e-9 * one.force_x);
    EXPECT_NEAR(one.moment_x, -other.moment_x, 1e-9 * std::abs(one.moment_x));
    EXPECT_NEAR(one.moment_y, -other.moment_y, 1e-9 * std::abs(one.moment_x));
  }
}

/// Without tilt nothing varies over the width, also with friction and formed foils.
TEST(DryTilt, OfNothingIsTheAlignedBearing) {
  for (const bool pads : {false, true}) {
    const BearingModel uniform = make_foils(some_case(pads, 0.1));
    const Increment aligned = taken(uniform, there);
    for (const OverWidth& over_width : all_over_width) {
      SCOPED_TRACE(testing::Message() << "pads " << pads << ", " << over_width);
      const Increment one = taken(on_lines(uniform, over_width.modes, {}, over_width.sheet), there);
      EXPECT_NEAR(one.force_x, aligned.force_x, 1e-7 * aligned.force_x);
      EXPECT_NEAR(one.force_y, aligned.force_y, 1e-7 * aligned.force_x);
      EXPECT_NEAR(one.elastic_energy, aligned.elastic_energy, 1e-7 * aligned.elastic_energy);
      EXPECT_NEAR(one.dissipated_energy, aligned.dissipated_energy, 1e-7 * aligned.elastic_energy);
      EXPECT_NEAR(one.moment_x, 0.0, 1e-7 * length * aligned.force_x);
    }
  }
}

/// The work of journal and moment is stored or dissipated: exact to round-off, as steps end at contact events.
TEST(DryTilt, EnergiesOfACycleBalance) {
  const WidthSettings tilted{.modes = 3, .tilt = {3e-4, -2e-4}};
  WidthSettings on_sheet = tilted;
  on_sheet.sheet = true;
  for (const WidthSettings& width : {tilted, on_sheet, WidthSettings{.modes = 3, .moment = {0.4, -0.2}}}) {
    SCOPED_TRACE(testing::Message() << "elastic sheet " << width.sheet << ", by moment " << !width.moment.empty());
    Case input = some_case(false, 0.1);
    input.width = width;
    input.solver.name = SolverName::events;
    CycleSettings& settings = input.settings.get<CycleSettings>();
    settings.directions = {0.3};
    settings.steps = 20;
    const CycleResult result = run_cycles(input);
    ASSERT_TRUE(result.converged());
    const Cycle& cycle = result.cycles.front();
    EXPECT_EQ(cycle.substeps, 0);
    const double most = largest_work(cycle);
    EXPECT_LT(plain_balance_defect(cycle), 1e-9 * most);
    EXPECT_GT(cycle.increments.back().dissipated_energy, 0.05 * most);
    EXPECT_GT(std::abs(cycle.turns.front().moment_x), 0.1);
    EXPECT_EQ(cycle.fields.crest_v_slope.cols(), 26);
    EXPECT_GT(cycle.fields.crest_v_slope.row(20).maxCoeff(), 1e-6);
    EXPECT_EQ(cycle.fields.foot_u_parabola.cols(), width.sheet ? 26 : 0);
    if (!width.sheet) continue;
    EXPECT_GT(cycle.fields.foot_u_parabola.row(20).cwiseAbs().maxCoeff(), 1e-9);
  }
}

/// Without friction nothing depends on the path: the moment that holds a tilt, applied instead, gives the same tilt.
TEST(DryTilt, IsFoundFromTheMomentThatItNeeds) {
  const Eigen::Vector2d slope(3e-4, -2e-4);
  const WidthProfile profile{.conicity = 4e-6, .crowning = 3e-6};
  for (const bool split : {false, true}) {
    Case input = some_case(true, 0.0);
    if (split) {
      input.top_foil.formed_radius = {};
      input.bump_foil.strips = 3;
    }
    const auto foils = [&](const JournalOverWidth& journal) {
      return split ? on_strips(make_foils(input), 3, journal) : on_lines(make_foils(input), 3, journal);
    };
    const Increment held = taken(foils({.slope = slope, .profile = profile}), there);
    const Increment free =
        taken(foils({.moment = Eigen::Vector2d(held.moment_x, held.moment_y), .profile = profile}), there);
    // The spring that holds a journal without contact is 1e-10 of the largest stiffness.
    EXPECT_NEAR(free.tilt_x, slope.x(), 1e-7 * slope.norm());
    EXPECT_NEAR(free.tilt_y, slope.y(), 1e-7 * slope.norm());
    EXPECT_NEAR(free.moment_x, held.moment_x, 1e-7 * held.moment_x);
    EXPECT_NEAR(free.moment_y, held.moment_y, 1e-7 * held.moment_x);
    EXPECT_NEAR(free.force_x, held.force_x, 1e-7 * held.force_x);
    EXPECT_NEAR(free.force_y, held.force_y, 1e-7 * held.force_x);
    EXPECT_NEAR(free.elastic_energy, held.elastic_energy, 1e-7 * held.elastic_energy);
  }
}

/// Without a moment the journal stays parallel to equal halves, even with friction, and tilts if it is conical.
TEST(DryTilt, WithoutAMomentEvensOutBothSides) {
  const BearingModel uniform = make_foils(some_case(true, 0.1));
  const Increment aligned = taken(uniform, there);
  const Eigen::Vector2d none = Eigen::Vector2d::Zero();
  const Increment free = taken(on_lines(uniform, 3, {.moment = none}), there);
  EXPECT_NEAR(free.tilt_x, 0.0, 1e-9);
  EXPECT_NEAR(free.force_x, aligned.force_x, 1e-7 * aligned.force_x);
  EXPECT_NEAR(free.force_y, aligned.force_y, 1e-7 * aligned.force_x);
  const WidthProfile cone{.conicity = 5e-6};
  const Increment held = taken(on_lines(uniform, 3, {.profile = cone}), there);
  const Increment turned = taken(on_lines(uniform, 3, {.moment = none, .profile = cone}), there);
  EXPECT_LT(held.moment_x, -0.1);  // the narrow side carries more
  EXPECT_NEAR(turned.moment_x, 0.0, 1e-7 * std::abs(held.moment_x));
  EXPECT_GT(turned.tilt_x, 0.5 * cone.conicity / length);
}

}  // namespace
}  // namespace bumpfoil
