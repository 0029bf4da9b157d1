#include "bearing/joint_newton.hpp"

#include <algorithm>
#include <cmath>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Maximum halvings of a Newton step: the line search ends at 1/256 of it.
constexpr int newton_max_halvings = 8;
/// A step halved at least this often makes almost no progress.
constexpr int halvings_in_vain = 6;
/// Fraction of a step taken if no halving reduces the residual.
constexpr double newton_forced_fraction = 0.25;
/// A full step that increases the residuals is accepted if the next step is shorter than this fraction of it. Pressures
/// of gas and asperities grow steeply in thin films, and so do the residuals on the way to such a state: steps that
/// never let them grow are many and short.
constexpr double leap_shortening = 0.5;
/// Smaller full steps that do not reduce the residuals at any length are round-off, mainly of contact forces.
constexpr double round_off_step = 1e-7;

/// Estimated error, relative to the tolerance, at which no further step is computed. After two full steps, the error of
/// Newton's method is the square of their ratio times the second; that of a step with reused factors is their ratio
/// times the second. Factors are also reused if two such steps, each of which leaves the square of the last ratio, come
/// as close.
constexpr double part_of_tolerance = 1e-3;

/// The films, and the unknowns of the law at the iterate and at the trial.
class JointNewton {
 public:
  JointNewton(const std::vector<FilmNewton*>& films, const JointLaw& law, Eigen::VectorXd y)
      : films_(films),
        law_(law),
        y_(std::move(y)),
        y_trial_(y_),
        y_instead_(y_),
        dy_(Eigen::VectorXd::Zero(y_.size())) {}

  /// Norm of all residuals at the trial: films and law each in their own units.
  double residual_of_trial() {
    double square = 0.0;
    forces_.clear();
    for (FilmNewton* film : films_) {
      square += film->find_residual();
      forces_.push_back(film->force());
    }
    square += law_.residual(y_trial_, forces_).cwiseQuotient(law_.units).squaredNorm();
    return std::sqrt(square);
  }
  bool find_step(bool keeps_factors, FilmReport& report) {
    for (FilmNewton* film : films_) {
      if (!film->find_step(keeps_factors, report)) return false;
    }
    move_journals();
    return true;
  }
  void note_prediction() {
    for (FilmNewton* film : films_) film->note_prediction();
  }
  [[nodiscard]] double longest_part() const {
    double part = 1.0;
    for (const FilmNewton* film : films_) part = std::min(part, film->longest_part());
    return part;
  }
  [[nodiscard]] double largest_change() const {
    double largest = 0.0;
    for (const FilmNewton* film : films_) largest = std::max(largest, film->largest_change());
    return largest;
  }
  void try_step(double part) {
    y_trial_ = y_ + part * dy_;
    for (FilmNewton* film : films_) film->try_step(part);
  }
  void keep_trial() {
    y_.swap(y_trial_);
    for (FilmNewton* film : films_) film->keep_trial();
  }
  /// Stores the trial, or restores the stored one.
  void swap_instead() {
    y_trial_.swap(y_instead_);
    for (FilmNewton* film : films_) film->swap_instead();
  }
  [[nodiscard]] bool touches() const {
    return std::any_of(films_.begin(), films_.end(), [](const FilmNewton* film) { return film->touches(); });
  }
  [[nodiscard]] const Eigen::VectorXd& trial() const { return y_trial_; }

 private:
  /// Adds the displacements of the journals to the step, from the residual of their law.
  void move_journals() {
    dy_.setZero();
    forces_.clear();
    for (const FilmNewton* film : films_) forces_.push_back(film->stepped_force());
    const Eigen::VectorXd lacking = law_.residual(y_, forces_);
    if (lacking.norm() <= law_.round_off) return;
    rates_.clear();
    for (FilmNewton* film : films_) rates_.push_back(film->find_rates());
    dy_ = solve(law_.matrix(rates_), lacking);
    const double displacement = law_.displacement(dy_);
    if (displacement > law_.longest_step) dy_ *= law_.longest_step / displacement;
    for (std::size_t i = 0; i < films_.size(); ++i) films_[i]->move_journal(law_.journals[i].motion * dy_);
  }

  const std::vector<FilmNewton*>& films_;
  const JointLaw& law_;
  Eigen::VectorXd y_, y_trial_, y_instead_, dy_;
  std::vector<JournalVector> forces_;
  std::vector<JournalMatrix> rates_;
};

}  // namespace

FilmReport solve_jointly(const std::vector<FilmNewton*>& films, const JointLaw& law, const NewtonAim& aim,
                         int max_iterations, Eigen::VectorXd& y) {
  JointNewton newton(films, law, y);
  FilmReport report;
  report.residual = newton.residual_of_trial();
  double leap = 0.0;  // largest change in a full step that increased the residuals; 0 if the last step did not
  bool may_leap = true;
  int vain_steps = 0;
  double last_full = 0.0;  // largest change in the last step, if it was a full one
  bool keeps_factors = false;
  while (report.iterations < max_iterations) {
    ++report.iterations;
    const bool is_regular = newton.find_step(keeps_factors, report);
    if (leap > 0.0 && !(is_regular && newton.largest_change() < leap_shortening * leap)) {
      newton.swap_instead();
      report.residual = newton.residual_of_trial();
      newton.keep_trial();
      leap = last_full = 0.0;
      may_leap = false;
      continue;
    }
    if (!is_regular) return report;
    // Residuals of the first step come only from what changes: it leads along the tangent.
    if (report.iterations == 1) newton.note_prediction();
    const double fraction = newton.longest_part();
    const double largest = newton.largest_change();
    bool is_last = fraction == 1.0 && largest < aim.tolerance;
    double part = fraction;
    int halvings = 0;
    for (; !is_last; ++halvings) {
      const bool none_helps = halvings == newton_max_halvings;
      if (none_helps) {
        is_last = fraction == 1.0 && largest < round_off_step;
        if (is_last) break;
        part = newton_forced_fraction * fraction;
      }
      newton.try_step(part);
      const double norm = newton.residual_of_trial();
      if (norm < report.residual || none_helps) {
        report.residual = norm;
        break;
      }
      part *= 0.5;
    }
    const bool is_full = fraction == 1.0 && part == 1.0;
    const double ratio = is_full && last_full > 0.0 ? largest / last_full : 1.0;
    const double contraction = keeps_factors ? ratio : ratio * ratio;
    const double error = contraction * largest;
    if (is_last || error < part_of_tolerance * aim.tolerance) {
      newton.try_step(1.0);
      report.status = newton.touches() ? Status::touchdown : Status::converged;
      if (report.status == Status::converged) y = law.holds_place() ? law.place : newton.trial();
      return report;
    }
    last_full = is_full ? largest : 0.0;
    keeps_factors = contraction * contraction * error < part_of_tolerance * aim.tolerance;
    if (halvings >= halvings_in_vain && vain_steps++ == aim.most_vain_steps) return report;
    leap = 0.0;
    if (may_leap && fraction == 1.0 && part < 1.0) {
      leap = largest;
      newton.swap_instead();
      newton.try_step(1.0);
      report.residual = newton.residual_of_trial();
    }
    newton.keep_trial();
  }
  return report;
}

}  // namespace bumpfoil
