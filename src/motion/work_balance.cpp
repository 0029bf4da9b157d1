#include "bumpfoil/motion/work_balance.hpp"

#include <utility>
#include <vector>

#include "bumpfoil/bearing/energy.hpp"
#include "bumpfoil/bearing/film_bearing_energy.hpp"

namespace bumpfoil {
namespace {

/// v^T A v
double quadratic(const Eigen::MatrixXd& A, const Eigen::VectorXd& v) {
  const Eigen::VectorXd product = A * v;
  return v.dot(product);
}

}  // namespace

WorkBalance& WorkBalance::operator+=(const WorkBalance& other) {
  entrained += other.entrained;
  supplied += other.supplied;
  forces += other.forces;
  rubbing += other.rubbing;
  dissipated += other.dissipated;
  friction += other.friction;
  damping += other.damping;
  stored += other.stored;
  return *this;
}

/// Quantities at the ends of a step that determine its powers and forces.
struct EnergyMeter::Instant {
  struct Bearing {
    FilmPowers powers;
    JournalVector place;
    JournalVector rubbing;  ///< asperity friction on the journal, N
    ContactState contacts;
    double energy{};
  };

  Instant(const MachineStepper& stepper, const MachineState& state)
      : at{.time = state.time, .angle = state.angle, .speed = state.speed}, rotor(state.rotor) {
    for (std::size_t i = 0; i < state.bearings.size(); ++i) {
      const BearingModel& bearing = stepper.bearings()[i]->bearing();
      const FilmModel& film = *bearing.film;
      const BearingState& now = state.bearings[i];
      Bearing& one = bearings.emplace_back(Bearing{.powers = film_powers(film, now),
                                                   .place = film.journal_of(now),
                                                   .rubbing = JournalVector::Zero(film.motions()),
                                                   .contacts = now.contacts,
                                                   .energy = bearing_energy(bearing, now).total()});
      if (!film.surroundings.asperities) continue;
      const Matrix pressures = asperity_pressures(film, now.film.thickness);
      one.rubbing =
          asperity_force(film, pressures, 0.0) - asperity_force(film, pressures, sliding_friction(film, now.speed));
    }
  }

  RotorInstant at;
  RotorMotion rotor;
  std::vector<Bearing> bearings;
};

EnergyMeter::EnergyMeter(const MachineStepper& stepper, RotorForces forces, const MachineState& start)
    : stepper_(stepper), forces_(std::move(forces)), last_(std::make_unique<Instant>(stepper, start)) {}

EnergyMeter::~EnergyMeter() = default;

WorkBalance EnergyMeter::step_to(const MachineState& end) {
  Instant& last = *last_;
  Instant now(stepper_, end);
  const double dt = now.at.time - last.at.time;
  // The acceleration of the step is used at both ends.
  last.at.acceleration = now.at.acceleration = (now.at.speed - last.at.speed) / dt;
  const Eigen::VectorXd displacement = now.rotor.y - last.rotor.y;
  WorkBalance step{.forces = 0.5 * (forces_(last.at) + forces_(now.at)).dot(displacement)};
  const Rotor& rotor = stepper_.rotor();
  const auto twice_energy = [&](const RotorMotion& motion) {
    return quadratic(rotor.mass, motion.v) + quadratic(rotor.stiffness, motion.y);
  };
  step.stored = 0.5 * (twice_energy(now.rotor) - twice_energy(last.rotor));
  step.damping = 0.5 * dt * (quadratic(rotor.damping, last.rotor.v) + quadratic(rotor.damping, now.rotor.v));
  for (std::size_t i = 0; i < now.bearings.size(); ++i) {
    const Instant::Bearing& a = last.bearings[i];
    const Instant::Bearing& b = now.bearings[i];
    step.entrained += 0.5 * dt * (a.powers.entrained + b.powers.entrained);
    step.supplied += 0.5 * dt * (a.powers.supplied + b.powers.supplied);
    step.dissipated += 0.5 * dt * (a.powers.dissipated + b.powers.dissipated);
    step.rubbing += 0.5 * (a.rubbing + b.rubbing).dot(b.place - a.place);
    step.friction += friction_work(stepper_.bearings()[i]->bearing().problem, a.contacts, b.contacts);
    step.stored += b.energy - a.energy;
  }
  last = std::move(now);
  return step;
}

}  // namespace bumpfoil
