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

/// Evaluates all residuals at once, so that each can be robust by itself.
class AllResiduals final : public ceres::EvaluationCallback {
 public:
  AllResiduals(const LeastSquares& problem, const Eigen::VectorXd& x) : problem_(problem), x_(x) {}

  void PrepareForEvaluation(bool needs_jacobian, bool is_new) override {
    if (is_new) {
      residuals_ = problem_.residuals(x_);
      jacobian_.reset();
    }
    if (needs_jacobian && residuals_ && !jacobian_) jacobian_ = difference_jacobian(problem_, x_, *residuals_);
  }

  /// One of them, as Ceres takes it.
  bool write(Eigen::Index row, double* residual, double** jacobians) const {
    if (!residuals_) return false;
    *residual = (*residuals_)[row];
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    if (!jacobian_) return false;
    Eigen::Map<Eigen::RowVectorXd>(jacobians[0], jacobian_->cols()) = jacobian_->row(row);
    return true;
  }

 private:
  const LeastSquares& problem_;
  const Eigen::VectorXd& x_;  ///< Ceres writes to it
  std::optional<Eigen::VectorXd> residuals_;
  std::optional<Eigen::MatrixXd> jacobian_;
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

std::optional<Eigen::MatrixXd> difference_jacobian(const LeastSquares& problem, const Eigen::VectorXd& x,
                                                   const Eigen::VectorXd& residuals) {
  const Eigen::Index count = x.size();
  Eigen::MatrixXd jacobian(residuals.size(), count);
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
    jacobian.col(i) = ((high ? *high : residuals) - (low ? *low : residuals)) / (to - from);
  }
  return jacobian;
}

std::optional<LeastSquaresMinimum> minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                                            const std::function<bool()>& go_on) {
  const std::optional<Eigen::VectorXd> first = problem.residuals(start);
  if (!first) return std::nullopt;
  LeastSquaresMinimum minimum{.x = start, .residuals = *first, .jacobian = {}};
  AllResiduals all(problem, minimum.x);

  std::unique_ptr<ceres::HuberLoss> loss;
  if (problem.huber) loss = std::make_unique<ceres::HuberLoss>(*problem.huber);
  ceres::Problem::Options ownership;
  ownership.evaluation_callback = &all;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem box(ownership);
  for (Eigen::Index row = 0; row < first->size(); ++row) {
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

  const std::optional<Eigen::VectorXd> last = problem.residuals(minimum.x);
  if (!last) return std::nullopt;
  minimum.residuals = *last;
  minimum.cost = cost_of(problem, minimum.residuals);
  minimum.converged = summary.termination_type == ceres::CONVERGENCE;
  const std::optional<Eigen::MatrixXd> jacobian = difference_jacobian(problem, minimum.x, minimum.residuals);
  if (!jacobian) return std::nullopt;
  minimum.jacobian = *jacobian;
  return minimum;
}

}  // namespace bumpfoil
