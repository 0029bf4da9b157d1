// docs/verification/rotor.md: rotors on their bearings, marched in time, against closed forms, an independent prototype
// and symmetry. Gas enters at the weld, load along +X.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <deque>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/motion/orbit.hpp"
#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "bumpfoil/motion/whirl.hpp"
#include "bumpfoil/motion/work_balance.hpp"
#include "bumpfoil/rotor/unbalance.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

constexpr double earth_gravity = 9.81;  // m/s^2

double step_of(double speed, int steps_per_turn) {
  return 2.0 * std::numbers::pi / (std::abs(speed) * steps_per_turn);
}

/// A rotor on springs and dampers, in units of its mass and speed, with cross-coupled stiffness. Its forces are those
/// of an unbalance of 1.
struct Jeffcott {
  Jeffcott() {
    rotor.stiffness << 0.6, 0.02, -0.02, 0.78;
    rotor.damping = 0.05 * Eigen::Matrix2d::Identity();
    rotor.bearings.clear();
    const Complex s(0.0, 1.0);
    const Eigen::Matrix2cd D = s * s * rotor.mass + s * rotor.damping + rotor.stiffness;
    amplitude = D.inverse() * Eigen::Vector2cd(1.0, -s);
  }
  [[nodiscard]] Eigen::VectorXd place(double t) const { return (amplitude * std::polar(1.0, t)).real(); }
  [[nodiscard]] RotorMotion at(double t) const { return {.y = place(t), .v = place(t + 0.5 * std::numbers::pi)}; }
  /// Largest error of a component in four turns, from the exact orbit. @param uneven  length ratio of successive steps
  [[nodiscard]] double error(int steps_per_turn, double uneven = 1.0) const {
    MachineStepper stepper(rotor, {});
    const double mean = 2.0 * std::numbers::pi / steps_per_turn;
    const double lengths[2] = {mean * 2.0 / (1.0 + uneven), mean * 2.0 * uneven / (1.0 + uneven)};
    MachineState state{.speed = 1.0, .rotor = at(0.0), .last_dt = lengths[0], .rotor_before = at(-lengths[0])};
    double largest = 0.0;
    for (int i = 0; i < 4 * steps_per_turn; ++i) {
      const MachineReport report = stepper.advance(
          {.dt = lengths[i % 2], .speed = 1.0},
          [](const RotorInstant& now) -> Eigen::VectorXd {
            return Eigen::Vector2d(std::cos(now.angle), std::sin(now.angle));
          },
          state);
      EXPECT_EQ(report.status, Status::converged);
      largest = std::max(largest, (state.rotor.y - place(state.time)).cwiseAbs().maxCoeff());
    }
    return largest;
  }

  Rotor rotor = make_point_mass(1.0);
  Eigen::Vector2cd amplitude;
};

TEST(RotorMarch, OnSpringsHasTheErrorsOfThePrototype) {
  const Jeffcott machine;
  const double even[] = {0.3105355393568239, 0.07981854122242193, 0.020095487991128813, 0.005032005225839242};
  const double uneven[] = {0.3106899172073323, 0.07983335428489191, 0.0200963621411665, 0.005031927381260459};
  for (int i = 0; i < 4; ++i) {
    const int steps = 50 << i;
    EXPECT_NEAR(machine.error(steps), even[i], 1e-6 * even[i]) << steps;
    EXPECT_NEAR(machine.error(steps, 1.5), uneven[i], 1e-6 * uneven[i]) << steps;
  }
}

/// Rate of a whirl, 1/s, from x at equal times: x_n = a x_{n-l} + b x_{n-2l} + c, Z^2 = a Z + b, Z = e^{s l dt}.
Complex fitted_rate(const std::vector<double>& x, std::size_t lag, double dt) {
  const auto rows = static_cast<Eigen::Index>(x.size() - 2 * lag);
  Eigen::MatrixX3d known(rows, 3);
  Eigen::VectorXd next(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto n = static_cast<std::size_t>(i);
    known.row(i) << x[n + lag], x[n], 1.0;
    next[i] = x[n + 2 * lag];
  }
  const Eigen::Vector3d fit = known.colPivHouseholderQr().solve(next);
  const Complex Z = 0.5 * fit[0] + std::sqrt(Complex(0.25 * fit[0] * fit[0] + fit[1], 0.0));
  return std::log(Z) / (static_cast<double>(lag) * dt);
}

/// A whirl of 1e-5 C_r, which decays in BDF2 steps at a slightly different rate.
TEST(RotorMarch, DecaysAsInThePrototype) {
  FilmStepper bearing(film_reference_bearing({6, 8}));
  const double speed = speed_of_rpm(-12000.0);
  MachineStepper stepper(make_point_mass(1.0), {&bearing});
  const Eigen::Vector2d load(earth_gravity, 0.0);
  const BearingState rest = state_under(bearing, load, speed);
  const auto whirls = find_whirls(stepper.rotor(), {{bearing, rest}}, usual_window(speed));
  ASSERT_TRUE(whirls && !whirls->whirls.empty());
  const std::pair<int, Complex> references[] = {{100, {-0.021362173905116867, 0.5240933909606523}},
                                                {200, {-0.021375465609289157, 0.5242353216386717}}};
  for (const auto& [steps, expected] : references) {
    MachineState state = stepper.at_rest({rest}, load);
    state.rotor.v = Eigen::Vector2d(1e-5 * bearing.bearing().clearance * std::abs(speed), 0.0);
    std::vector<double> x;
    for (int i = 0; i < 14 * steps; ++i) {
      const MachineReport report = stepper.advance(
          {.dt = step_of(speed, steps), .speed = speed}, [&](const RotorInstant&) { return load; }, state);
      ASSERT_EQ(report.status, Status::converged);
      if (i >= 6 * steps) x.push_back(state.rotor.y[0]);
    }
    const Complex rate = fitted_rate(x, static_cast<std::size_t>(steps) / 4, step_of(speed, steps)) / std::abs(speed);
    EXPECT_NEAR(std::abs(rate - expected), 0.0, 2e-6);
    // The same from the closed form of BDF2 for linear motions.
    const Complex closed = bdf2_rate(whirls->whirls.front().rate, step_of(speed, steps)) / std::abs(speed);
    EXPECT_NEAR(std::abs(rate - closed), 0.0, 2e-6);
  }
}

/// BDF2's d/dt of motions e^{i nu t} in even steps: the linear response at this rate is that of the steps.
Complex bdf2_derivative(double nu, double dt) {
  const Complex back = std::polar(1.0, -nu * dt);
  return (1.5 - 2.0 * back + 0.5 * back * back) / dt;
}

/// A point mass of 1 kg at -45,000 rpm that carries 100 N, its weight included, and an unbalance along +X at angle 0.
struct UnbalancedMass {
  explicit UnbalancedMass(double friction) : bearing(film_reference_bearing({6, 8}, friction)) {
    // As in the prototype: held at 0.1 C_r, then loaded in ten equal increments.
    const BearingModel& of = bearing.bearing();
    EXPECT_EQ(start_from_ambient(bearing, 0.1 * of.clearance * load.normalized(), speed, rest).status,
              Status::converged);
    const Eigen::Vector2d held = film_force(*of.film, rest.film.pressure);
    for (int i = 1; i <= 10; ++i) {
      const Eigen::Vector2d to = held + 0.1 * i * (load - held);
      EXPECT_EQ(follow(bearing, OperatingPoint::loaded_by(to, speed), rest).status, Status::converged);
    }
  }

  [[nodiscard]] Unbalance unbalance(double eccentricity) const {
    return {.amount = stepper.rotor().total_mass() * eccentricity};
  }
  /// Linear response Y to the force of the unbalance, at a rate.
  [[nodiscard]] Eigen::Vector2cd linear(double eccentricity, Complex rate, bool stuck = false) {
    const Rotor& rotor = stepper.rotor();
    const auto found = linear_response(
        rotor, {{bearing, rest}}, unbalance_force(rotor.bearings.front(), unbalance(eccentricity), speed), rate, stuck);
    EXPECT_TRUE(found.has_value());
    return found ? Eigen::Vector2cd(*found) : Eigen::Vector2cd::Zero();
  }
  [[nodiscard]] RotorForces forces(double eccentricity) const {
    return [this, eccentricity](const RotorInstant& now) -> Eigen::VectorXd {
      return load + unbalance_force(stepper.rotor().bearings.front(), unbalance(eccentricity), now.angle, now.speed,
                                    now.acceleration);
    };
  }
  /// Starts from the linear orbit.
  [[nodiscard]] Orbit orbit(double eccentricity, bool stuck = false, int max_turns = 60) {
    MachineState start = stepper.at_rest({rest}, load);
    add_motion(stepper, linear(eccentricity, {0.0, std::abs(speed)}, stuck), start);
    return find_orbit(stepper, forces(eccentricity), start, {.steps_per_turn = steps, .max_turns = max_turns});
  }

  static constexpr int steps = 100;
  double speed = speed_of_rpm(-45000.0);
  Eigen::Vector2d load{100.0, 0.0};
  FilmStepper bearing;
  MachineStepper stepper{make_point_mass(1.0), {&bearing}};
  BearingState rest;
};

/// Amplitudes in um and phases in degrees, along X and Y.
struct OrbitReference {
  double amplitude[2], phase[2], mean[2], half_peak_to_peak[2];
};

void expect_orbit(const StationOrbit& orbit, const OrbitReference& reference, double tolerance) {
  for (const int axis : {0, 1}) {
    const double amplitude = reference.amplitude[axis];
    EXPECT_NEAR(1e6 * std::abs(orbit.once[axis]), amplitude, tolerance * amplitude);
    EXPECT_NEAR(std::arg(orbit.once[axis]) * 180.0 / std::numbers::pi, reference.phase[axis],
                tolerance * 180.0 / std::numbers::pi);
    EXPECT_NEAR(1e6 * orbit.mean[axis], reference.mean[axis], tolerance * amplitude);
    EXPECT_NEAR(1e6 * orbit.half_peak_to_peak[axis], reference.half_peak_to_peak[axis], tolerance * amplitude);
  }
}

TEST(RotorMarch, FindsTheOrbitsOfThePrototype) {
  UnbalancedMass machine(0.0);
  const Orbit small = machine.orbit(1e-6);
  ASSERT_EQ(small.status, Status::converged);
  EXPECT_LT(small.change, 1e-7);
  expect_orbit(small.bearings.front(),
               {{1.3234544172995537, 1.1672953826781367},
                {179.11496246745423, -85.7847843396375},
                {31.935999227452914, -9.608118256479058},
                {1.3232973933734136, 1.1672249849793366}},
               1e-5);
  EXPECT_NEAR(1e6 * small.turn.front().thinnest, 6.769655814408143, 1e-5);
  EXPECT_NEAR(small.turn.front().power, 38.01946170404876, 1e-5);
  EXPECT_EQ(small.turn.front().friction, 0.0);
  // Free whirl that is left after a turn: the larger exponentials of the eigenvalues, as changed by BDF2.
  const auto whirls =
      find_whirls(machine.stepper.rotor(), {{machine.bearing, machine.rest}}, usual_window(machine.speed));
  ASSERT_TRUE(whirls.has_value());
  ASSERT_GE(small.multipliers.size(), 4U);
  const double dt = step_of(machine.speed, UnbalancedMass::steps);
  for (std::size_t i = 0; i < 2; ++i) {
    const Complex expected = std::exp(bdf2_rate(whirls->whirls[i].rate, dt) * (dt * UnbalancedMass::steps));
    double nearest = 1.0;
    for (const Complex found : small.multipliers) nearest = std::min(nearest, std::abs(found - expected));
    EXPECT_LT(nearest, 2e-2);  // the finite orbit has an effect: e^2
  }

  const Orbit large = machine.orbit(5e-6);
  ASSERT_EQ(large.status, Status::converged);
  expect_orbit(large.bearings.front(), {{6.57669, 5.81459}, {179.230, -85.866}, {31.435, -9.424}, {6.5762, 5.8140}},
               1e-4);  // printed digits
  EXPECT_NEAR(1e6 * large.turn.front().thinnest, 4.8219, 1e-4);
  // This orbit is unstable: another motion, of twice the period, grows by 9 % per turn and changes its sign.
  EXPECT_NEAR(large.multipliers.front().real(), -1.0908, 1e-3);

  // Both depart from the linear response in the same steps as e^2. (That in continuous time differs by another 4e-3.)
  const Complex rate = bdf2_derivative(std::abs(machine.speed), dt);
  const auto departure = [&](const Orbit& orbit, double eccentricity) {
    const Eigen::Vector2cd linear = machine.linear(eccentricity, rate);
    return (orbit.bearings.front().once - linear).norm() / linear.norm();
  };
  EXPECT_LT(departure(small, 1e-6), 5e-4);
  EXPECT_NEAR(departure(large, 5e-6) / departure(small, 1e-6), 25.0, 2.5);
}

/// Balance of one turn of the machine, from `state` on.
WorkBalance balance_of_turn(MachineStepper& stepper, const RotorForces& forces, int steps, MachineState& state) {
  EnergyMeter meter(stepper, forces, state);
  WorkBalance turn;
  for (int i = 0; i < steps; ++i) {
    const MachineReport report =
        stepper.advance({.dt = step_of(state.speed, steps), .speed = state.speed}, forces, state);
    EXPECT_EQ(report.status, Status::converged);
    turn += meter.step_to(state);
  }
  return turn;
}

/// The work that drives an orbiting rotor is dissipated by the films: exact in space, of fourth order in the steps.
TEST(RotorMarch, BalancesTheEnergyOfAnOrbit) {
  UnbalancedMass machine(0.0);
  double defects[2];
  for (const int refined : {0, 1}) {
    const int steps = refined == 0 ? 100 : 200;
    const RotorForces forces = machine.forces(1e-6);
    MachineState start = machine.stepper.at_rest({machine.rest}, machine.load);
    add_motion(machine.stepper, machine.linear(1e-6, {0.0, std::abs(machine.speed)}), start);
    Orbit orbit = find_orbit(machine.stepper, forces, start, {.steps_per_turn = steps, .tolerance = 1e-8});
    ASSERT_EQ(orbit.status, Status::converged);
    const WorkBalance turn = balance_of_turn(machine.stepper, forces, steps, orbit.state);
    // Prototype, J: the work of the unbalance, of the moving surface, and the dissipation of the flow.
    EXPECT_NEAR(turn.forces, refined == 0 ? 4.556603558126453e-06 : 4.556142976879104e-06, 2e-10);
    EXPECT_NEAR(turn.entrained, refined == 0 ? 0.004009817480778845 : 0.004009855259488219, 1e-8);
    EXPECT_NEAR(turn.dissipated, refined == 0 ? 0.004014356307879507 : 0.004014410310412094, 1e-8);
    EXPECT_LT(std::abs(turn.stored), 1e-9);
    EXPECT_EQ(turn.friction, 0.0);
    defects[refined] = std::abs(turn.defect());
    EXPECT_NEAR(defects[refined], refined == 0 ? 1.77763736230747e-08 : 1.1078158396848865e-09, 2e-10);
  }
  EXPECT_NEAR(defects[0] / defects[1], 16.0, 3.0);
}

/// The same with friction, where the mean position still creeps.
TEST(RotorMarch, BalancesTheEnergyWithFriction) {
  UnbalancedMass machine(0.1);
  const RotorForces forces = machine.forces(1e-6);
  MachineState state = machine.stepper.at_rest({machine.rest}, machine.load);
  add_motion(machine.stepper, machine.linear(1e-6, {0.0, std::abs(machine.speed)}, true), state);
  balance_of_turn(machine.stepper, forces, 100, state);
  const WorkBalance turn = balance_of_turn(machine.stepper, forces, 100, state);
  EXPECT_GT(turn.friction, 1e-6);
  EXPECT_LT(std::abs(turn.defect()), 0.02 * turn.friction);  // error of the time steps; the prototype's was 1.7 %
}

/// With friction the mean position creeps, so that no orbit repeats to 1e-7 within a few turns: the search reports this
/// and returns the last turn. The prototype's own changed by 2e-5 in a turn.
TEST(RotorMarch, SaysWhereFrictionStillCreeps) {
  UnbalancedMass machine(0.1);
  const Eigen::Vector2cd linear = machine.linear(1e-6, {0.0, std::abs(machine.speed)}, true);
  EXPECT_NEAR(1e6 * std::abs(linear[0]), 1.72156, 5e-4);  // load paths differ by 1e-4
  EXPECT_NEAR(1e6 * std::abs(linear[1]), 1.21776, 5e-4);
  const Orbit orbit = machine.orbit(1e-6, true, 16);
  ASSERT_EQ(orbit.status, Status::not_converged);
  EXPECT_EQ(orbit.turns, 17);
  EXPECT_LT(orbit.change, 1e-2);
  EXPECT_NEAR(1e6 * std::abs(orbit.bearings.front().once[0]), 1.7042, 0.02);
  EXPECT_NEAR(1e6 * std::abs(orbit.bearings.front().once[1]), 1.1885, 0.02);
  EXPECT_NEAR(orbit.turn.front().friction, 1.287e-6, 0.1e-6);
}

/// A rigid rotor that tilts, on bearings of different clearances.
TEST(RotorMarch, FindsTheOrbitOfARigidRotor) {
  const double speed = speed_of_rpm(-10000.0);
  const Rotor rotor = make_rigid_rotor({.mass = 2.2,
                                        .transverse_inertia = 9e-3,
                                        .polar_inertia = 1.1e-3,
                                        .bearings = {-0.07, 0.09},
                                        .planes = {-0.02, 0.05}});
  std::deque<FilmStepper> bearings;
  for (const double clearance : {31.8e-6, 28e-6}) {
    Case input = film_reference_case({6, 8});
    input.bearing.radial_clearance = clearance;
    bearings.emplace_back(make_film_bearing(input));
  }
  const auto loads = weights_on_bearings(rotor, {earth_gravity, 0.0});
  MachineStepper stepper(rotor, {&bearings[0], &bearings[1]});
  const std::vector<BearingState> rest{state_under(bearings[0], loads[0], speed),
                                       state_under(bearings[1], loads[1], speed)};
  const Eigen::VectorXd weight = rotor.mass * rotor.rigid.col(0) * earth_gravity;
  // At a tenth of the unbalance, and at all of it.
  const std::pair<double, std::vector<OrbitReference>> references[] = {{0.1,
                                                                        {{{0.10705286201597126, 0.08249443812288734},
                                                                          {-120.83678872371337, -82.60034051977802},
                                                                          {13.675520401617069, -12.884857929965637},
                                                                          {0.1070128426275631, 0.08249391611525578}},
                                                                         {{0.1591371286561863, 0.15607198914601098},
                                                                          {-164.14433035142403, -113.6679965346888},
                                                                          {8.031220299876114, -9.82007222362456},
                                                                          {0.15908590262716246, 0.15601662343258282}}}},
                                                                       {1.0,
                                                                        {{{1.080660622211908, 0.8354045472433701},
                                                                          {-121.53870852060744, -83.32674734258968},
                                                                          {13.644945434166736, -12.883546730339066},
                                                                          {1.0803746332982433, 0.8355865205043145}},
                                                                         {{1.5842311398377737, 1.523529679519735},
                                                                          {-163.05755270316962, -112.2124428340914},
                                                                          {7.991605747868437, -9.778485864162782},
                                                                          {1.5850873301076256, 1.5223176810030898}}}}};
  for (const auto& [part, expected] : references) {
    const Unbalance unbalances[] = {{.amount = part * 1.5e-6, .phase = 0.0},
                                    {.amount = part * 1e-6, .phase = 0.5 * std::numbers::pi}};
    const auto forces = [&](const RotorInstant& now) -> Eigen::VectorXd {
      Eigen::VectorXd sum = weight;
      for (std::size_t i = 0; i < 2; ++i) {
        sum += unbalance_force(rotor.stations[i], unbalances[i], now.angle, now.speed, now.acceleration);
      }
      return sum;
    };
    const auto linear = linear_response(rotor, {{bearings[0], rest[0]}, {bearings[1], rest[1]}},
                                        unbalance_force(rotor.stations[0], unbalances[0], speed) +
                                            unbalance_force(rotor.stations[1], unbalances[1], speed),
                                        {0.0, std::abs(speed)});
    ASSERT_TRUE(linear.has_value());
    MachineState start = stepper.at_rest(rest, weight);
    add_motion(stepper, *linear, start);
    const Orbit orbit = find_orbit(stepper, forces, start);
    ASSERT_EQ(orbit.status, Status::converged);
    for (std::size_t i = 0; i < 2; ++i) expect_orbit(orbit.bearings[i], expected[i], 1e-5);
  }
}

/// A short march of a point mass from rest, kicked and unbalanced.
Eigen::Matrix2Xd kicked(const BearingModel& bearing, const BearingState& rest, const Eigen::Vector2d& load,
                        const Eigen::Matrix2d& image) {
  FilmStepper film(bearing);
  MachineStepper stepper(make_point_mass(1.0), {&film});
  MachineState state = stepper.at_rest({rest}, load);
  state.rotor.v = image * Eigen::Vector2d(0.05, 0.02);
  Eigen::Matrix2Xd places(2, 25);
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const MachineReport report = stepper.advance(
        {.dt = step_of(rest.speed, 50), .speed = rest.speed},
        [&](const RotorInstant& now) -> Eigen::VectorXd {
          const double angle = image.determinant() * now.angle;
          return load + image * (20.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        },
        state);
    EXPECT_EQ(report.status, Status::converged);
    places.col(i) = state.rotor.y;
  }
  return places;
}

/// Everything turned, and everything mirrored: the same march, turned or mirrored. States start equal, so that
/// differences are round-off.
TEST(RotorMarch, IsTurnedAndMirroredWithItsBearing) {
  Case input = film_reference_case({4, 4}, 0.1);
  const BearingModel bearing = make_film_bearing(input);
  FilmStepper stepper(bearing);
  const Eigen::Vector2d load(60.0, 10.0);
  const BearingState rest = state_under(stepper, load, speed_of_rpm(-45000.0));
  const Eigen::Matrix2Xd places = kicked(bearing, rest, load, Eigen::Matrix2d::Identity());
  EXPECT_GT((places.colwise() - rest.position).cwiseAbs().maxCoeff(), 1e-6);

  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  Case turned = input;
  turned.bearing.weld_angle += 0.7;
  BearingState turned_rest = rest;
  turned_rest.position = turn * rest.position;
  EXPECT_LT((kicked(make_film_bearing(turned), turned_rest, turn * load, turn) - turn * places).cwiseAbs().maxCoeff(),
            1e-12 * bearing.clearance);

  Case mirrored = input;  // about the X axis
  mirrored.bearing.weld_angle = -input.bearing.weld_angle;
  mirrored.bearing.wrap = Wrap::counterclockwise;
  const Eigen::Matrix2d mirror = Eigen::Vector2d(1.0, -1.0).asDiagonal();
  BearingState image = rest;
  image.position = mirror * rest.position;
  image.speed = -rest.speed;
  EXPECT_LT((kicked(make_film_bearing(mirrored), image, mirror * load, mirror) - mirror * places).cwiseAbs().maxCoeff(),
            1e-12 * bearing.clearance);
}

/// A rotor on a bearing with friction, pushed for half a turn so that contacts slip, stick and open: its position at
/// every fiftieth of a turn, and the friction loss until then.
struct PushedMarch {
  PushedMarch(FilmStepper& film, const BearingState& rest, const Eigen::Vector2d& load, int steps_per_turn) {
    MachineStepper stepper(make_point_mass(1.0), {&film});
    MachineState state = stepper.at_rest({rest}, load);
    const double whole = 2.0 * std::numbers::pi / std::abs(rest.speed);
    const auto forces = [&](const RotorInstant& now) -> Eigen::VectorXd {
      const double wave = std::sin(2.0 * std::numbers::pi * now.time / whole);
      return load + 60.0 * wave * wave * Eigen::Vector2d(1.0, 0.5);
    };
    EnergyMeter meter(stepper, forces, state);
    double loss = 0.0;
    for (int i = 1; i <= steps_per_turn / 2; ++i) {
      const MachineReport report = stepper.advance({.dt = whole / steps_per_turn, .speed = rest.speed}, forces, state);
      EXPECT_EQ(report.status, Status::converged);
      loss += meter.step_to(state).friction;
      if (i % (steps_per_turn / 50) != 0) continue;
      places.emplace_back(state.rotor.y);
      losses.push_back(loss);
    }
  }
  std::vector<Eigen::Vector2d> places;
  std::vector<double> losses;
};

/// The instant within a step at which a contact slips, sticks or opens is not resolved: an error of second order.
TEST(RotorMarch, IsOfSecondOrderWithFriction) {
  FilmStepper film(film_reference_bearing({4, 4}, 0.3));
  const Eigen::Vector2d load(60.0, 10.0);
  const BearingState rest = state_under(film, load, speed_of_rpm(-45000.0));
  std::vector<PushedMarch> marches;
  for (const int steps : {50, 100, 200, 400}) marches.emplace_back(film, rest, load, steps);
  EXPECT_GT(marches.back().losses.back(), 1e-6);
  std::vector<double> of_place, of_loss;  // differences, roots of sums of squares
  for (std::size_t k = 1; k < marches.size(); ++k) {
    double place = 0.0, loss = 0.0;
    for (std::size_t i = 0; i < marches[k].places.size(); ++i) {
      place += (marches[k].places[i] - marches[k - 1].places[i]).squaredNorm();
      loss += std::pow(marches[k].losses[i] - marches[k - 1].losses[i], 2);
    }
    of_place.push_back(std::sqrt(place));
    of_loss.push_back(std::sqrt(loss));
  }
  for (std::size_t k = 1; k < of_place.size(); ++k) {
    EXPECT_NEAR(std::log2(of_place[k - 1] / of_place[k]), 2.0, 0.3);
    EXPECT_NEAR(std::log2(of_loss[k - 1] / of_loss[k]), 2.0, 0.3);
  }
}

/// Two equal bearings of a rotor that does not tilt act as one that carries half of it.
TEST(RotorMarch, OnTwoEqualBearingsIsThatOfAPointMass) {
  const BearingModel bearing = film_reference_bearing({4, 4}, 0.1);
  FilmStepper left(bearing);
  FilmStepper right(bearing);
  const Eigen::Vector2d load(60.0, 10.0);
  const BearingState rest = state_under(left, load, speed_of_rpm(-45000.0));
  const Eigen::Matrix2Xd places = kicked(bearing, rest, load, Eigen::Matrix2d::Identity());
  const Rotor rotor =
      make_rigid_rotor({.mass = 2.0, .transverse_inertia = 5e-3, .polar_inertia = 1e-3, .bearings = {-0.05, 0.05}});
  MachineStepper stepper(rotor, {&left, &right});
  MachineState state = stepper.at_rest({rest, rest}, Eigen::Vector4d(120.0, 20.0, 0.0, 0.0));
  state.rotor.v.head(2) = Eigen::Vector2d(0.05, 0.02);
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const MachineReport report = stepper.advance(
        {.dt = step_of(rest.speed, 50), .speed = rest.speed},
        [&](const RotorInstant& now) -> Eigen::VectorXd {
          const Eigen::Vector2d whole = 2.0 * (load + 20.0 * Eigen::Vector2d(std::cos(now.angle), std::sin(now.angle)));
          return Eigen::Vector4d(whole.x(), whole.y(), 0.0, 0.0);
        },
        state);
    ASSERT_EQ(report.status, Status::converged);
    ASSERT_LT((state.rotor.y.head(2) - places.col(i)).norm(), 1e-12 * bearing.clearance);
    ASSERT_LT(state.rotor.y.tail(2).norm(), 1e-12);
  }
}

/// At -20,000 rpm whirl grows until the film vanishes: the march ends with a status and the last state.
TEST(RotorMarch, EndsWhereTheFilmIsGone) {
  constexpr double floor = 0.4e-6;  // m
  const BearingModel reference = film_reference_bearing({6, 8});
  const double c = reference.film->scales.thickness;
  FilmStepper bearing(reference, {.newton = {.thickness_floor = floor / c}});
  const double speed = speed_of_rpm(-20000.0);
  const Eigen::Vector2d load(earth_gravity, 0.0);
  MachineStepper stepper(make_point_mass(1.0), {&bearing});
  MachineState state = stepper.at_rest({state_under(bearing, load, speed)}, load);
  state.rotor.v = Eigen::Vector2d(0.05 * reference.clearance * std::abs(speed), 0.0);
  const TimeStep step{.dt = step_of(speed, 100), .speed = speed};
  const auto forces = [&](const RotorInstant&) { return load; };
  // Half peak-to-peak in turns 1 to 5 and 6 to 10, um.
  for (const Eigen::Vector2d& expected :
       {Eigen::Vector2d(7.443425901121721, 6.955111093876168), Eigen::Vector2d(32.12230847244503, 34.65112515550609)}) {
    Eigen::Vector2d least = state.rotor.y;
    Eigen::Vector2d most = least;
    for (int i = 0; i < 500; ++i) {
      ASSERT_EQ(stepper.advance(step, forces, state).status, Status::converged);
      least = least.cwiseMin(state.rotor.y);
      most = most.cwiseMax(state.rotor.y);
    }
    // Growth of 0.066 per radian gives e^4 in ten turns, also for errors of the equilibrium.
    EXPECT_LT((0.5e6 * (most - least) - expected).norm(), 1e-5 * expected.norm());
  }
  MachineState before;
  Status status = Status::converged;
  for (int i = 0; i < 500 && status == Status::converged; ++i) {
    before = state;
    status = stepper.advance(step, forces, state).status;
  }
  EXPECT_EQ(status, Status::touchdown);
  EXPECT_EQ(state.rotor.y, before.rotor.y);
  EXPECT_EQ(state.time, before.time);
  EXPECT_GE(state.bearings.front().film.thickness.minCoeff(), floor / c);
  EXPECT_LT(state.bearings.front().film.thickness.minCoeff(), 2.0 * floor / c);
}

}  // namespace
}  // namespace bumpfoil
