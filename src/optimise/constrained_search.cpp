#include "optimise/constrained_search.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace bumpfoil {
namespace {

/// NLopt requests the function and its limits separately at the same point: both are evaluated once.
class SearchedFunction {
 public:
  SearchedFunction(const SearchProblem& problem, nlopt_opt optimiser) : problem_(problem), optimiser_(optimiser) {}

  double aim_at(unsigned n, const double* x) {
    at(n, x);
    return aim_;
  }

  void limits_at(unsigned n, const double* x, double* out) {
    at(n, x);
    std::copy(limits_.begin(), limits_.end(), out);
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  /// Exceptions must not propagate through C.
  void at(unsigned n, const double* x) noexcept try {
    const Eigen::VectorXd here = Eigen::Map<const Eigen::VectorXd>(x, n);
    if (stopped_ || (x_ && *x_ == here)) return;
    limits_ = Eigen::VectorXd::Zero(problem_.limits);
    x_ = here;
    stopped_ = !problem_.evaluate(here, aim_, limits_);
    if (stopped_) nlopt_force_stop(optimiser_);
  } catch (...) {
    error_ = std::current_exception();
    stopped_ = true;
    nlopt_force_stop(optimiser_);
  }

  const SearchProblem& problem_;
  nlopt_opt optimiser_;
  std::optional<Eigen::VectorXd> x_;
  double aim_{};
  Eigen::VectorXd limits_;
  bool stopped_{};
  std::exception_ptr error_;
};

}  // namespace

SearchEnd search_constrained(const SearchProblem& problem, const Eigen::VectorXd& start, double step,
                             double tolerance) {
  const std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)> optimiser(
      nlopt_create(NLOPT_LN_COBYLA, static_cast<unsigned>(start.size())), &nlopt_destroy);
  SearchedFunction searched(problem, optimiser.get());
  nlopt_set_lower_bounds1(optimiser.get(), 0.0);
  nlopt_set_upper_bounds1(optimiser.get(), 1.0);
  nlopt_set_min_objective(
      optimiser.get(),
      [](unsigned n, const double* x, double* /*gradient*/, void* data) {
        return static_cast<SearchedFunction*>(data)->aim_at(n, x);
      },
      &searched);
  if (problem.limits > 0) {
    nlopt_add_inequality_mconstraint(
        optimiser.get(), static_cast<unsigned>(problem.limits),
        [](unsigned /*m*/, double* out, unsigned n, const double* x, double* /*gradient*/, void* data) {
          static_cast<SearchedFunction*>(data)->limits_at(n, x, out);
        },
        &searched, nullptr);
  }
  nlopt_set_initial_step1(optimiser.get(), step);
  nlopt_set_xtol_abs1(optimiser.get(), tolerance);
  std::vector<double> x(start.begin(), start.end());
  double aim = 0.0;
  const nlopt_result end = nlopt_optimize(optimiser.get(), x.data(), &aim);
  searched.rethrow();
  if (end == NLOPT_FORCED_STOP) return SearchEnd::stopped;
  if (end == NLOPT_ROUNDOFF_LIMITED) return SearchEnd::round_off;
  if (end == NLOPT_OUT_OF_MEMORY) throw std::bad_alloc();
  if (end < 0) {
    const char* const said = nlopt_get_errmsg(optimiser.get());
    throw std::runtime_error(fmt::format("NLopt: {}", said == nullptr ? nlopt_result_to_string(end) : said));
  }
  return SearchEnd::tolerance;
}

}  // namespace bumpfoil
