#include "motion/rotor_journals.hpp"

#include <Eigen/QR>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

std::vector<JointLaw::Journal> journals_of(const Rotor& rotor, const std::vector<FilmStepper*>& bearings) {
  BUMPFOIL_ASSERT(bearings.size() == rotor.bearings.size());
  std::vector<JointLaw::Journal> journals;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const FilmBearing& bearing = bearings[i]->bearing();
    const Eigen::MatrixXd B = rotor.bearings[i].journal();
    BUMPFOIL_ASSERT(B.rows() == bearing.motions());
    JointLaw::Journal& journal = journals.emplace_back(
        JointLaw::Journal{.motion = B, .by_force = B.transpose(), .force = JournalVector::Zero(B.rows())});
    if (!bearing.tilts()) continue;
    journal.origin = JournalVector::Zero(B.rows());
    journal.origin.tail<2>() = bearing.surroundings.tilt.value;
  }
  return journals;
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
        bearing.journal().transpose() * journal_force(bearings[i]->bearing(), states[i].film, states[i].speed);
  }
  // A rigid motion does no work on the shaft: what is left of the balance there is not for y to meet.
  known.head(n) = largest > 0.0 ? Eigen::VectorXd(known.head(n) / unit) : Eigen::VectorXd::Zero(n);
  return rows.completeOrthogonalDecomposition().solve(known);
}

}  // namespace bumpfoil
