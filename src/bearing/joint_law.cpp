#include "bumpfoil/bearing/joint_law.hpp"

#include <algorithm>

#include "core/linear_algebra.hpp"

namespace bumpfoil {

JournalVector JointLaw::Journal::place(const Eigen::VectorXd& y) const {
  JournalVector q = motion * y;
  if (origin.size() > 0) q += origin;
  return q;
}

Eigen::VectorXd JointLaw::residual(const Eigen::VectorXd& y, const std::vector<JournalVector>& forces) const {
  Eigen::VectorXd lacking = by_place * (place - y);
  for (std::size_t i = 0; i < journals.size(); ++i) {
    lacking += journals[i].by_force * (journals[i].force - forces[i]);
  }
  return lacking;
}

Eigen::MatrixXd JointLaw::matrix(const std::vector<JournalMatrix>& K) const {
  Eigen::MatrixXd sum = by_place;
  for (std::size_t i = 0; i < journals.size(); ++i)
    sum += product(product(journals[i].by_force, K[i]), journals[i].motion);
  return sum;
}

bool JointLaw::holds_place() const {
  return !journals.empty() && std::all_of(journals.begin(), journals.end(),
                                          [](const Journal& journal) { return journal.by_force.isZero(0.0); });
}

double JointLaw::displacement(const Eigen::VectorXd& step) const {
  double largest = 0.0;
  for (const Journal& journal : journals) {
    const Eigen::VectorXd moved = journal.motion * step;  // avoids a GCC warning about the norm of a product
    largest = std::max(largest, moved.norm());
  }
  return largest;
}

JointLaw law_of_one(const JournalLaw& law) {
  return {.by_place = law.by_position,
          .place = law.position,
          .journals = {{.motion = JournalMatrix::Identity(law.position.size(), law.position.size()),
                        .by_force = law.by_force,
                        .force = law.force}},
          .units = law.units,
          .round_off = law.round_off,
          .longest_step = law.longest_step};
}

}  // namespace bumpfoil
