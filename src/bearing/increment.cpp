#include "bumpfoil/bearing/increment.hpp"

#include <limits>

namespace bumpfoil {
namespace {

constexpr double absent_number = std::numeric_limits<double>::quiet_NaN();

/// Quantities that every increment has.
Increment place(const Step& step, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d& position = step.state.position;
  Increment increment;
  increment.displacement = position.dot(direction);
  increment.x = position.x();
  increment.y = position.y();
  increment.elastic_energy = absent_number;
  increment.residuals = {.equilibrium = absent_number,
                         .penetration = absent_number,
                         .slip_in_stick = absent_number,
                         .complementarity = absent_number,
                         .cone = absent_number};
  increment.status = step.status;
  increment.cost = step.cost;
  increment.substeps = step.substeps;
  return increment;
}

}  // namespace

Increment place_increment(const BearingModel& foils, const Step& step, const Eigen::Vector2d& direction) {
  Increment increment = place(step, direction);
  const Eigen::Vector2d force = holding_force(foils, step.state.contacts.normal_force);
  const auto force_along = [&](const Eigen::Vector2d& axis) { return cleared(force.dot(axis), foils.round_off.force); };
  increment.force_x = force_along(Eigen::Vector2d::UnitX());
  increment.force_y = force_along(Eigen::Vector2d::UnitY());
  increment.force_direct = force_along(direction);
  increment.force_cross = force_along({-direction.y(), direction.x()});
  const Eigen::Vector2d moment = holding_moment(foils, step.state.contacts.normal_force);
  increment.moment_x = moment.x();
  increment.moment_y = moment.y();
  const Eigen::Vector2d slope = journal_slope(foils, step.state.contacts.x);
  increment.tilt_x = slope.x();
  increment.tilt_y = slope.y();
  increment.dissipated_energy = cleared(step.state.dissipated_energy, foils.round_off.energy);
  increment.work = cleared(step.state.work, foils.round_off.energy);
  return increment;
}

void check_increment(const BearingModel& foils, const BearingState& state, Increment& increment) {
  const ElasticResponse elastic = elastic_response(foils, state.contacts.x);
  increment.elastic_energy = cleared(elastic.energy, foils.round_off.energy);
  // The loads include forming.
  increment.residuals = contact_residuals(foils.problem, elastic.forces + foils.forming, state.loading,
                                          state.slip_origin, state.contacts);
}

Increment failed_increment(const Step& step, const Eigen::Vector2d& direction) {
  Increment increment = place(step, direction);
  for (double* value :
       {&increment.force_x, &increment.force_y, &increment.force_direct, &increment.force_cross, &increment.moment_x,
        &increment.moment_y, &increment.tilt_x, &increment.tilt_y, &increment.dissipated_energy, &increment.work}) {
    *value = absent_number;
  }
  return increment;
}

}  // namespace bumpfoil
