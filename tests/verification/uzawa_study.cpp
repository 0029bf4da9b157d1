/// Prints the table of docs/verification/uzawa.md: the four parameters of the augmented Lagrangian solver, varied one
/// at a time around their defaults, against the exact solver.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/uzawa_comparison.hpp"

namespace bumpfoil {
namespace {

class Study {
 public:
  Study() : cases_{uzawa_study_case(), scattered_uzawa_study_case()} {
    for (const Case& input : cases_) exact_.push_back(run_cycles(input));
  }

  void print_row(const char* label, const UzawaParameters& parameters) const {
    UzawaDeviation all;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      all = worst(all, compare_uzawa(cases_[i], exact_[i], parameters));
    }
    const auto given = [](std::optional<double> value) { return value ? fmt::format("{:.0e}", *value) : ""; };
    fmt::print("| {} | {} | {} | {} | {} | {:.3f} | {:.3f} | {:.0f} | {:.1f} | {} | {} |\n", label,
               given(parameters.eps_alm), given(parameters.eps_f), given(parameters.eps_r), given(parameters.tau_f),
               100.0 * all.max_force, 100.0 * all.loop_energy, all.solves_per_increment, all.updates_per_increment,
               all.halvings, all.failures);
    std::fflush(stdout);
  }

  void vary(const char* label, std::optional<double> UzawaParameters::*parameter,
            const std::vector<double>& values) const {
    for (const double value : values) {
      UzawaParameters parameters;
      parameters.*parameter = value;
      print_row(label, parameters);
    }
  }

 private:
  std::vector<Case> cases_;
  std::vector<CycleResult> exact_;
};

}  // namespace
}  // namespace bumpfoil

int main() {
  using bumpfoil::UzawaParameters;
  const bumpfoil::Study study;
  fmt::print(
      "| varied | eps_alm N/m | eps_f N/m | eps_r N/m | tau_f m | force % | loop % | solves | updates | halved | "
      "failed |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|---|---|\n");
  study.print_row("none", UzawaParameters());
  study.vary("eps_alm", &UzawaParameters::eps_alm, {1e6, 1e7, 1e9, 1e10, 1e11});
  study.vary("eps_f", &UzawaParameters::eps_f, {1e7, 1e8, 1e9, 1e11, 1e12});
  study.vary("eps_r", &UzawaParameters::eps_r, {1e8, 1e9, 1e10, 1e11, 1e13, 1e14});
  study.vary("tau_f", &UzawaParameters::tau_f, {1e-7, 1e-8, 1e-9, 1e-11, 1e-12});
  return 0;
}
