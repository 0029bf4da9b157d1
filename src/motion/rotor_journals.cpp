#include "motion/rotor_journals.hpp"

#include <algorithm>
#include <limits>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Longest displacement of a journal in one step of Newton's method, in units of c: that of a journal under a load.
constexpr double longest_displacement_in_c = 0.15;

}  // namespace

JointLaw law_of_rotor(const Rotor& rotor, const std::vector<FilmStepper*>& bearings) {
  BUMPFOIL_ASSERT(bearings.size() == rotor.bearings.size());
  JointLaw law;
  law.longest_step = std::numeric_limits<double>::infinity();
  double force_unit = 1.0;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const FilmModel& film = bearings[i]->film();
    const Eigen::MatrixXd B = rotor.bearings[i].journal();
    BUMPFOIL_ASSERT(B.rows() == film.motions());
    JointLaw::Journal& journal = law.journals.emplace_back(
        JointLaw::Journal{.motion = B, .by_force = B.transpose(), .force = JournalVector::Zero(B.rows())});
    force_unit = std::max(force_unit, film.scales.force());
    law.longest_step = std::min(law.longest_step, longest_displacement_in_c * film.scales.thickness);
    if (!film.tilts()) continue;
    journal.origin = JournalVector::Zero(B.rows());
    journal.origin.tail<2>() = film.surroundings.tilt.value;
  }
  // The unit of each unknown is the length with which it moves the mass of the rotor.
  law.units = force_unit * (rotor.mass.diagonal() / rotor.total_mass()).cwiseSqrt();
  return law;
}

Eigen::VectorXd rotor_at_rest(const Rotor& rotor, const std::vector<FilmStepper*>& bearings,
                              const std::vector<BearingState>& states, const Eigen::VectorXd& forces) {
  BUMPFOIL_ASSERT(!states.empty() && states.size() == bearings.size());
  const Eigen::Index n = rotor.size();
  const double largest = rotor.stiffness.cwiseAbs().maxCoeff();
  const double unit = largest > 0.0 ? largest : 1.0;
  Eigen::MatrixXd rows(n + 2 * static_cast<Eigen::Index>(states.size()), n);
  Eigen::VectorXd known(rows.rows());
  rows.topRows(n) = rotor.stiffness / unit;
  known.head(n) = forces;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const RotorStation& bearing = rotor.bearings[i];
    const Eigen::Index row = n + 2 * static_cast<Eigen::Index>(i);
    rows.middleRows(row, 2) = bearing.motion;
    known.segment(row, 2) = states[i].position;
    known.head(n) -=
        bearing.journal().transpose() * journal_force(bearings[i]->film(), states[i].film, states[i].speed);
  }
  // A rigid motion does no work on the shaft: y cannot affect the residual of this balance.
  known.head(n) = largest > 0.0 ? Eigen::VectorXd(known.head(n) / unit) : Eigen::VectorXd::Zero(n);
  return least_squares(rows, known);
}

}  // namespace bumpfoil
