#include "experiments/fit/least_squares.hpp"

#include <ceres/ceres.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace bumpfoil {
namespace {

constexpr int most_iterations = 60;
constexpr double least_decrease = 1e-6;
constexpr double least_move = 1e-7;
constexpr double least_gradient = 1e-12;

/// Known results at a point.
struct Evaluated {
  Eigen::VectorXd x;
  std::optional<Eigen::VectorXd> residuals{};
  std::optional<Differences> differences{};
};

/// Evaluates all residuals at once, although each is a residual block of its own so that it can be robust. Caches the
/// last point, and the last one with derivatives, to which rejected steps return.
class AllResiduals final : public ceres::EvaluationCallback {
 public:
  AllResiduals(const LeastSquares& problem, const Eigen::VectorXd& x) : problem_(problem), x_(x) {}

  void PrepareForEvaluation(bool needs_jacobian, bool /*is_new*/) override {
    needs_jacobian ? differentiate() : evaluate();
  }

  const Evaluated& evaluate() {
    if (here_.x.size() == 0 || here_.x != x_) {
      here_ = differentiated_.x.size() > 0 && differentiated_.x == x_ ? differentiated_
                                                                      : Evaluated{x_, problem_.residuals(x_)};
    }
    return here_;
  }

  const Evaluated& differentiate() {
    if (evaluate().residuals && !here_.differences) {
      here_.differences = differences_at(problem_, x_, *here_.residuals);
      differentiated_ = here_;
    }
    return here_;
  }

  /// Writes one residual for Ceres.
  bool write(Eigen::Index row, double* residual, double** jacobians) const {
    if (!here_.residuals) return false;
    *residual = (*here_.residuals)[row];
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    if (!here_.differences) return false;
    const Eigen::MatrixXd& jacobian = here_.differences->jacobian;
    Eigen::Map<Eigen::RowVectorXd>(jacobians[0], jacobian.cols()) = jacobian.row(row);
    return true;
  }

 private:
  const LeastSquares& problem_;
  const Eigen::VectorXd& x_;  ///< overwritten by Ceres
  Evaluated here_, differentiated_;
};

class OneResidual final : public ceres::CostFunction {
 public:
  OneResidual(const AllResiduals& all, Eigen::Index row, Eigen::Index parameters) : all_(all), row_(row) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
  }

  bool Evaluate(double const* const* /*parameters*/, double* residuals, double** jacobians) const override {
    return all_.write(row_, residuals, jacobians);
  }

 private:
  const AllResiduals& all_;
  Eigen::Index row_;
};

class Watcher final : public ceres::IterationCallback {
 public:
  explicit Watcher(const std::function<bool()>& go_on) : go_on_(go_on) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override {
    return go_on_() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
  }

 private:
  const std::function<bool()>& go_on_;
};

}  // namespace

double cost_of(const LeastSquares& problem, const Eigen::VectorXd& residuals) {
  double cost = residuals.squaredNorm();
  if (!problem.huber) return cost;
  const double bound = *problem.huber;
  for (Eigen::Index i = 0; i < problem.robust; ++i) {
    const double size = std::abs(residuals[i]);
    if (size > bound) cost += 2.0 * bound * size - bound * bound - size * size;
  }
  return cost;
}

std::optional<Differences> differences_at(const LeastSquares& problem, const Eigen::VectorXd& x,
                                          const Eigen::VectorXd& residuals) {
  const Eigen::Index count = x.size();
  Differences found{Eigen::MatrixXd(residuals.size(), count), Eigen::VectorXd::Zero(count)};
  std::vector<std::optional<Eigen::VectorXd>> ends(2 * static_cast<std::size_t>(count));
  const auto end_of = [&x](Eigen::Index i, bool up) {
    return std::clamp(x[i] + (up ? difference_step : -difference_step), 0.0, 1.0);
  };
  tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t k) {
    const auto i = static_cast<Eigen::Index>(k / 2);
    Eigen::VectorXd moved = x;
    moved[i] = end_of(i, k % 2 == 1);
    if (moved[i] != x[i]) ends[k] = problem.residuals(moved);
  });
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& low = ends[2 * static_cast<std::size_t>(i)];
    const auto& high = ends[2 * static_cast<std::size_t>(i) + 1];
    if (!low && !high) return std::nullopt;
    const double from = low ? end_of(i, false) : x[i];
    const double to = high ? end_of(i, true) : x[i];
    const Eigen::VectorXd change = (high ? *high : residuals) - (low ? *low : residuals);
    found.jacobian.col(i) = change / (to - from);
    const double size = change.norm();
    if (low && high && size > 0.0) found.bends[i] = (*high - 2.0 * residuals + *low).norm() / size;
  }
  return found;
}

std::optional<LeastSquaresMinimum> minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                                            const std::function<bool()>& go_on) {
  LeastSquaresMinimum minimum{.x = start, .residuals = {}, .differences = {}};
  AllResiduals all(problem, minimum.x);
  const Evaluated& first = all.differentiate();
  if (!first.differences) return std::nullopt;
  const Eigen::Index count = first.residuals->size();

  std::unique_ptr<ceres::HuberLoss> loss;
  if (problem.huber) loss = std::make_unique<ceres::HuberLoss>(*problem.huber);
  ceres::Problem::Options ownership;
  ownership.evaluation_callback = &all;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem box(ownership);
  for (Eigen::Index row = 0; row < count; ++row) {
    box.AddResidualBlock(new OneResidual(all, row, start.size()), row < problem.robust ? loss.get() : nullptr,
                         minimum.x.data());
  }
  for (int i = 0; i < start.size(); ++i) {
    box.SetParameterLowerBound(minimum.x.data(), i, 0.0);
    box.SetParameterUpperBound(minimum.x.data(), i, 1.0);
  }
  Watcher watcher(go_on);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = least_decrease;
  options.parameter_tolerance = least_move;
  options.gradient_tolerance = least_gradient;
  options.callbacks.push_back(&watcher);
  options.update_state_every_iteration = true;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &box, &summary);

  const Evaluated& end = all.differentiate();
  if (!end.differences) return std::nullopt;
  minimum.residuals = *end.residuals;
  minimum.differences = *end.differences;
  minimum.cost = cost_of(problem, minimum.residuals);
  minimum.converged = summary.termination_type == ceres::CONVERGENCE;
  return minimum;
}

}  // namespace bumpfoil
