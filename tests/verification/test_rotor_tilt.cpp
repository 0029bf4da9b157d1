// docs/verification/rotor.md: rotors whose bearings resist the tilt of their journals.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/motion/orbit.hpp"
#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/motion/rotor_equilibria.hpp"
#include "bumpfoil/motion/whirl.hpp"
#include "bumpfoil/motion/work_balance.hpp"
#include "bumpfoil/rotor/unbalance.hpp"
#include "experiments/stability/stability_dataset.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

constexpr double earth = 9.81;  // m/s^2
const FilmResolution whole_width{.columns_per_pitch = 4, .rows = 3, .width_modes = 3, .width = WidthPart::whole};

/// A bearing on its whole width. @param tilt  of its journal before the rotor tilts, m at the side
BearingModel tilting_bearing(const JournalTilt& tilt = {}, double conicity = 0.0) {
  const Case input = film_reference_case({.columns_per_pitch = 4, .rows = 3, .width_modes = 3});
  return make_film_bearing(make_foils(input), gas_of(input.gas), whole_width,
                           {.tilt = tilt, .profile = {.conicity = conicity}});
}

RigidRotorDesign rigid(double mass, double transverse_inertia, std::vector<double> bearings) {
  return {.mass = mass,
          .transverse_inertia = transverse_inertia,
          .polar_inertia = 0.2 * transverse_inertia,
          .bearings = std::move(bearings),
          .planes = {0.05}};
}

/// A rotor in equilibrium on bearings that resist tilts, its weight along +X.
struct TiltingMachine {
  TiltingMachine(Rotor carried, const std::vector<BearingModel>& films, double rpm) : rotor(std::move(carried)) {
    for (std::size_t i = 0; i < films.size(); ++i) {
      rotor.bearings[i].half_width = films[i].film->tilts() ? films[i].film->half_width() : 0.0;
      steppers.emplace_back(films[i]);
    }
    for (FilmStepper& stepper : steppers) pointers.push_back(&stepper);
    const RotorEquilibria equilibria(rotor, pointers, {earth, 0.0});
    EXPECT_EQ(equilibria.go_to(speed_of_rpm(rpm), states), Status::converged);
  }
  [[nodiscard]] std::vector<CarryingBearing> bearings() {
    std::vector<CarryingBearing> all;
    for (std::size_t i = 0; i < states.size(); ++i) all.push_back({steppers[i], states[i]});
    return all;
  }
  [[nodiscard]] double speed() const { return states.front().speed; }
  [[nodiscard]] std::vector<Whirl> whirls() {
    auto found = find_whirls(rotor, bearings(), usual_window(speed()));
    EXPECT_TRUE(found.has_value());
    return found ? found->whirls : std::vector<Whirl>{};
  }
  [[nodiscard]] JournalVector force(std::size_t i) const {
    return journal_force(steppers[i].film(), states[i].film, states[i].speed);
  }

  Rotor rotor;
  std::deque<FilmStepper> steppers;
  std::vector<FilmStepper*> pointers;
  std::vector<BearingState> states;
};

double distance_to_nearest(const std::vector<Whirl>& whirls, Complex rate) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Whirl& whirl : whirls) nearest = std::min(nearest, std::abs(whirl.rate - rate));
  return nearest;
}

/// Two equal bearings, level under half the weight each. By symmetry forces do not tilt their journals nor moments
/// displace them: with l the distance to the centre of mass and h half the width, each motion obeys a 2 x 2 equation,
///
///     cylindrical  m s^2 + 2 Z_xx = 0,      conical  I_t s^2 + s Omega I_p J + 2 (h^2 Z_tt + l^2 Z_xx) = 0.
TEST(TiltingRotor, WhirlsAsTheTwoByTwoEquationsOfEqualBearingsSay) {
  const double l = 0.03;
  const Rotor rotor = make_rigid_rotor(rigid(2.0, 1.2e-3, {-l, l}));
  const BearingModel film = tilting_bearing();
  TiltingMachine machine(rotor, {film, film}, -14000.0);
  for (const BearingState& state : machine.states) EXPECT_LT(state.tilt.norm(), 1e-12);
  const double h = film.film->half_width();
  int cylindrical = 0;
  int conical = 0;
  for (const Whirl& whirl : machine.whirls()) {
    const Complex s = whirl.rate;
    if (whirl.is_of_foils()) continue;
    const auto Z = machine.steppers[0].impedances(machine.states[0], {s});
    ASSERT_TRUE(Z.has_value());
    const Eigen::Matrix2cd of_place = Z->front().topLeftCorner(2, 2);
    const Eigen::Matrix2cd of_tilt = Z->front().bottomRightCorner(2, 2);
    EXPECT_LT(Z->front().topRightCorner(2, 2).norm(), 1e-7 * of_place.norm());
    const bool tilts = l * whirl.shape.tail(2).norm() > whirl.shape.head(2).norm();
    Eigen::Matrix2cd D = 2.0 * of_place + 2.0 * s * s * Eigen::Matrix2cd::Identity();
    if (tilts) {
      Eigen::Matrix2cd turning;
      turning << 0.0, 1.0, -1.0, 0.0;
      D = 1.2e-3 * s * s * Eigen::Matrix2cd::Identity() + s * machine.speed() * 0.24e-3 * turning +
          2.0 * (h * h * of_tilt + l * l * of_place);
      // The tilt matters: without it the equation is not satisfied.
      const Eigen::Matrix2cd by_forces_alone = D - 2.0 * h * h * of_tilt;
      EXPECT_GT(std::abs(by_forces_alone.determinant()), 1e-3 * by_forces_alone.squaredNorm());
    }
    ++(tilts ? conical : cylindrical);
    EXPECT_LT(std::abs(D.determinant()), 1e-7 * D.squaredNorm()) << s << tilts;
  }
  EXPECT_GE(cylindrical, 1);
  EXPECT_GE(conical, 1);
}

/// A point mass cannot tilt: on the whole width it whirls as on half of it. Foils are uniform over the width, so that
/// both are one model.
TEST(TiltingRotor, ThatIsHeldLevelWhirlsAsOnHalfTheWidth) {
  FilmResolution uniform{.columns_per_pitch = 4, .rows = 3};
  const BearingModel on_half = film_reference_bearing(uniform);
  const Case input = film_reference_case(uniform);
  uniform.width = WidthPart::whole;
  TiltingMachine whole(make_point_mass(1.0), {make_film_bearing(make_foils(input), gas_of(input.gas), uniform)},
                       -14000.0);
  TiltingMachine half(make_point_mass(1.0), {on_half}, -14000.0);
  ASSERT_EQ(whole.rotor.bearings[0].journal().rows(), 4);
  ASSERT_EQ(half.rotor.bearings[0].journal().rows(), 2);
  EXPECT_LT((whole.states[0].position - half.states[0].position).norm(), 1e-12);
  const std::vector<Whirl> expected = half.whirls();
  ASSERT_FALSE(expected.empty());
  for (const Whirl& whirl : expected) {
    EXPECT_LT(distance_to_nearest(whole.whirls(), whirl.rate), 1e-6 * std::abs(whirl.rate));
  }
}

/// The farther apart the bearings are, the less their moments matter against their forces: as the square.
TEST(TiltingRotor, OnBearingsFarApartTiltsAsOnForcesAlone) {
  double before = 0.0;
  for (const double l : {0.25, 0.5}) {
    const BearingModel film = tilting_bearing();
    TiltingMachine machine(make_rigid_rotor(rigid(2.0, 0.8 * l * l, {-l, l})), {film, film}, -14000.0);
    Rotor by_forces = machine.rotor;
    for (RotorStation& bearing : by_forces.bearings) bearing.tilt.setZero();
    const auto expected = find_whirls(by_forces, machine.bearings(), usual_window(machine.speed()));
    ASSERT_TRUE(expected.has_value());
    const auto conical = std::find_if(expected->whirls.begin(), expected->whirls.end(), [&](const Whirl& whirl) {
      return l * whirl.shape.tail(2).norm() > whirl.shape.head(2).norm() && !whirl.is_of_foils();
    });
    ASSERT_NE(conical, expected->whirls.end());
    const double off = distance_to_nearest(machine.whirls(), conical->rate) / std::abs(conical->rate);
    EXPECT_LT(off, 0.02);
    EXPECT_GT(off, 1e-5);
    if (before > 0.0) {
      EXPECT_NEAR(before / off, 4.0, 0.2);
    }
    before = off;
  }
}

/// Forces and moments of bearings that are misaligned, conical and different balance the weight, and their journals lie
/// on one axis.
TEST(TiltingRotor, RestsWhereForcesAndMomentsBalanceItsWeight) {
  const JournalTilt tilt{Control::displacement, {2e-6, -1e-6}};
  const Rotor rotor = make_rigid_rotor(rigid(3.0, 4e-3, {-0.04, 0.06}));
  TiltingMachine machine(rotor, {tilting_bearing(tilt), tilting_bearing(tilt, 4e-6)}, -18000.0);
  const double h = machine.rotor.bearings[0].half_width;
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  double largest = 0.0;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const JournalVector F = machine.force(i);
    force += F.head<2>();
    moment += machine.rotor.bearings[i].z * F.head<2>() + h * F.tail<2>();
    largest = std::max(largest, h * F.tail<2>().norm());
  }
  EXPECT_LT((force - Eigen::Vector2d(3.0 * earth, 0.0)).norm(), 1e-5);
  EXPECT_LT(moment.norm(), 1e-6);
  EXPECT_GT(largest, 1e-3);  // N m: moments that matter
  const Eigen::Vector2d slope = (machine.states[1].position - machine.states[0].position) / 0.1;
  for (const BearingState& state : machine.states) EXPECT_LT((state.tilt - tilt.value - h * slope).norm(), 1e-12);
}

/// The same rotor seen from its other end.
TEST(TiltingRotor, WhirlsAsItsImageInTheMidPlane) {
  const JournalTilt tilt{Control::displacement, {2e-6, -1e-6}};
  const JournalTilt image{Control::displacement, {-2e-6, 1e-6}};
  TiltingMachine here(make_rigid_rotor(rigid(3.0, 4e-3, {-0.04, 0.06})),
                      {tilting_bearing(tilt), tilting_bearing(tilt, 4e-6)}, -18000.0);
  TiltingMachine there(make_rigid_rotor(rigid(3.0, 4e-3, {-0.06, 0.04})),
                       {tilting_bearing(image, -4e-6), tilting_bearing(image)}, -18000.0);
  const std::vector<Whirl> expected = here.whirls();
  const std::vector<Whirl> found = there.whirls();
  ASSERT_FALSE(expected.empty());
  for (const Whirl& whirl : expected) {
    EXPECT_LT(distance_to_nearest(found, whirl.rate), 1e-6 * std::abs(whirl.rate));
  }
}

/// In time: under a small unbalance the nonlinear march follows the linear response, also in the tilt of its journals,
/// except for time-step errors, and energies balance.
TEST(TiltingRotor, FollowsItsLinearResponseInTime) {
  const JournalTilt tilt{Control::displacement, {1e-6, 0.0}};
  TiltingMachine machine(make_rigid_rotor(rigid(2.0, 1.2e-3, {-0.03, 0.03})),
                         {tilting_bearing(tilt), tilting_bearing(tilt)}, -12000.0);
  const Rotor& rotor = machine.rotor;
  const double speed = machine.speed();
  const Unbalance unbalance{.amount = 3e-7, .phase = 0.0};
  const Eigen::VectorXd weight = rotor.mass * rotor.rigid.col(0) * earth;
  const auto forces = [&](const RotorInstant& now) -> Eigen::VectorXd {
    return weight + unbalance_force(rotor.stations[0], unbalance, now.angle, now.speed, now.acceleration);
  };
  const auto linear = linear_response(rotor, machine.bearings(), unbalance_force(rotor.stations[0], unbalance, speed),
                                      {0.0, std::abs(speed)});
  ASSERT_TRUE(linear.has_value());
  MachineStepper stepper(rotor, machine.pointers);
  MachineState start = stepper.at_rest(machine.states, weight);
  const MachineState rest = start;
  add_motion(stepper, *linear, start);
  MachineState state = start;
  EnergyMeter meter(stepper, forces, state);
  WorkBalance turn;
  constexpr int steps = 100;
  Eigen::VectorXcd once = Eigen::VectorXcd::Zero(rotor.size());
  const double dt = 2.0 * M_PI / std::abs(speed) / steps;
  for (int i = 0; i < 3 * steps; ++i) {
    ASSERT_EQ(stepper.advance({.dt = dt, .speed = speed}, forces, state).status, Status::converged);
    const WorkBalance taken = meter.step_to(state);
    if (i < 2 * steps) continue;
    turn += taken;
    once += std::polar(2.0 / steps, -std::abs(state.angle)) * (state.rotor.y - rest.rotor.y);
  }
  // BDF2 has an error of 2/3 (2 pi / 100)^2 of the inertia, 0.3 %, and the film one of the square of the amplitude.
  EXPECT_LT((once.head(2) - linear->head(2)).norm(), 0.03 * linear->head(2).norm());
  EXPECT_LT((once.tail(2) - linear->tail(2)).norm(), 0.03 * linear->tail(2).norm());
  EXPECT_GT(0.03 * linear->tail(2).norm(), 0.2 * linear->head(2).norm());  // it tilts
  for (std::size_t i = 0; i < 2; ++i) {
    const JournalVector place = machine.steppers[i].film().journal_of(state.bearings[i]);
    EXPECT_LT((place - stepper.journals()[i].place(state.rotor.y)).norm(), 1e-15);
    EXPECT_NE(state.bearings[i].tilt, machine.states[i].tilt);
  }
  // Input equals output: the balance is exact except for the time steps.
  const double in = turn.entrained + turn.forces + turn.supplied + turn.rubbing;
  const double out = turn.dissipated + turn.friction + turn.damping + turn.stored;
  EXPECT_GT(std::abs(turn.forces), 1e-9);
  EXPECT_LT(std::abs(in - out), 0.05 * std::abs(turn.forces));
}

/// Stability of a rotor of 2 kg from its case file, at -14,000 rpm.
StabilityResult stability_of(const std::vector<std::string>& width) {
  std::vector<std::string> keys{"rotor.mass=2 kg",
                                "rotor.transverse_inertia=1.2e-3 kg m2",
                                "rotor.polar_inertia=0.24e-3 kg m2",
                                "rotor.bearings=[\"-30 mm\", \"30 mm\"]",
                                "rotor.gravity=[9.81, 0]",
                                "stability.speeds=[\"-14000 rpm\"]"};
  keys.insert(keys.end(), width.begin(), width.end());
  const Case input = parse_case(case_to_toml(film_reference_case({.columns_per_pitch = 4, .rows = 3})), "tilt.toml",
                                {.overrides = keys, .commands = {"stability"}});
  StabilityResult result = run_stability(input);
  EXPECT_EQ(result.map.points.at(0).status, Status::converged);
  return result;
}

/// Half widths, stations and moments from the case are those of the machine.
TEST(TiltingRotor, IsThatOfItsCase) {
  const BearingModel film = tilting_bearing();
  TiltingMachine machine(make_rigid_rotor(rigid(2.0, 1.2e-3, {-0.03, 0.03})), {film, film}, -14000.0);
  const StabilityResult of_case = stability_of({"width.modes=3"});
  ASSERT_TRUE(of_case.map.points[0].sliding.has_value());
  const std::vector<Whirl> expected = machine.whirls();
  ASSERT_EQ(of_case.map.points[0].sliding->whirls.size(), expected.size());
  for (const Whirl& whirl : of_case.map.points[0].sliding->whirls) {
    EXPECT_LT(distance_to_nearest(expected, whirl.rate), 1e-7 * std::abs(whirl.rate));
  }
  EXPECT_FALSE(stability_of({}).machine.bearings[0]->film->tilts());
  EXPECT_TRUE(
      stability_of({"width.modes=2", "width.tilt=[\"0.1 mrad\", \"0 mrad\"]"}).machine.bearings[0]->film->tilts());
}

/// Results of journals: they tilt with the rotor, on bearings misaligned by 0.1 mrad, and moments and forces of both
/// bearings have no resultant moment about the rotor's centre of mass.
TEST(TiltingRotor, TellsTiltsAndMomentsOfItsJournals) {
  const StabilityResult result =
      stability_of({"width.modes=2", "rotor.bearing=[{width={tilt=[\"0.1 mrad\", \"0 mrad\"]}}, {}]"});
  const Dataset data = stability_dataset(result);
  const auto values = [&data](const std::string& name) {
    for (const Variable& variable : data.variables) {
      if (variable.meaning.name == name) return variable.values();
    }
    return std::vector<double>();
  };
  const std::vector<double> tilts = values("tilt_x");
  ASSERT_EQ(tilts.size(), 2U);
  EXPECT_NEAR(tilts[0] - tilts[1], 1e-4, 1e-12);
  EXPECT_GT(std::abs(tilts[1]), 1e-7);  // the rotor tilts
  double moment = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const BearingModel& bearing = *result.machine.bearings[i];
    const BearingState& state = result.map.points[0].states[i];
    const double arm = result.machine.rotor.bearings[i].z;
    const double of_bearing = values("moment_x")[i];
    moment += of_bearing + arm * journal_force(*bearing.film, state.film, state.speed)[0];
    largest = std::max(largest, std::abs(of_bearing));
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_NEAR(moment, 0.0, 1e-6 * largest);
}

/// Bearings with opposite misalignment are mirror images: each journal responds like the other from the other side, and
/// the rotor stays level.
TEST(TiltingRotor, MayStandOnBearingsThatAreMisalignedEachByItself) {
  const JournalTilt one{.value = 0.5 * 38.1e-3 * Eigen::Vector2d(1e-4, 0.0)};
  const JournalTilt opposite{.value = -one.value};
  TiltingMachine machine(make_rigid_rotor(rigid(2.0, 1.2e-3, {-0.03, 0.03})),
                         {tilting_bearing(one), tilting_bearing(opposite)}, -14000.0);
  const Matrix& film = machine.states[0].film.thickness;
  EXPECT_LT((film.colwise().reverse() - machine.states[1].film.thickness).norm(), 1e-7 * film.norm());
  EXPECT_GT((film - machine.states[1].film.thickness).norm(), 1e-3 * film.norm());
}

}  // namespace
}  // namespace bumpfoil
