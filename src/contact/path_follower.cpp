#include "bumpfoil/contact/path_follower.hpp"

#include <utility>

namespace bumpfoil {
namespace {

class IncrementFollower final : public PathFollower {
 public:
  IncrementFollower(std::unique_ptr<ContactSolver> solver, int max_halvings)
      : solver_(std::move(solver)), max_halvings_(max_halvings) {}

  [[nodiscard]] SolverBounds bounds() const override { return solver_->bounds(); }

  [[nodiscard]] SolveReport assemble(const ContactLoading& loading, const ContactState& unstressed,
                                     ContactState& state) override {
    return solver_->solve(loading, unstressed, state);
  }

  void set_out(const LoadingPath& path, const ContactState&) override {
    path_ = path;
    reached_ = 0.0;
  }

  [[nodiscard]] const LoadingPath& path() const override { return path_; }

  [[nodiscard]] FollowReport follow_to(double fraction, ContactState& state, const PartVisitor& visit,
                                       std::vector<ContactEvent>&) override {
    FollowReport report;
    take(fraction, max_halvings_, state, visit, report);
    return report;
  }

 private:
  /// From `reached_` to `fraction`, halved if necessary.
  void take(double fraction, int halvings, ContactState& state, const PartVisitor& visit, FollowReport& report) {
    path_.at(fraction, loading_);
    const SolveReport solve = solver_->solve(loading_, state, next_);
    report.cost += solve.cost;
    report.status = solve.status;
    if (solve.converged()) {
      if (visit) visit({.begin = state, .end = next_, .fraction = fraction, .linear = false});
      std::swap(state, next_);
      reached_ = fraction;
      return;
    }
    if (halvings == 0) return;
    const double middle = 0.5 * (reached_ + fraction);
    for (const double end : {middle, fraction}) {
      ++report.substeps;
      take(end, halvings - 1, state, visit, report);
      if (!report.converged()) return;
    }
  }

  std::unique_ptr<ContactSolver> solver_;
  int max_halvings_;
  LoadingPath path_;
  double reached_{};
  ContactLoading loading_;
  ContactState next_;
};

}  // namespace

ContactLoading LoadingPath::at(double fraction) const {
  ContactLoading loading;
  at(fraction, loading);
  return loading;
}

void LoadingPath::at(double fraction, ContactLoading& loading) const {
  loading.initial_gap = (1.0 - fraction) * begin.initial_gap + fraction * end.initial_gap;
  loading.load = (1.0 - fraction) * begin.load + fraction * end.load;
}

std::unique_ptr<PathFollower> make_increment_follower(std::unique_ptr<ContactSolver> solver, int max_halvings) {
  return std::make_unique<IncrementFollower>(std::move(solver), max_halvings);
}

}  // namespace bumpfoil
