#include "bumpfoil/results/run_identity.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

std::string refusal(const std::string& identity, const Case& input) {
  try {
    require_same_run(identity, input, "ensemble.checkpoint");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(EnsembleIdentity, IsNotOfTheNumberOfSamples) {
  const Case input = test_support::ensemble_case(10);
  Case more = input;
  more.montecarlo->samples = 1000;
  more.title = "another";
  EXPECT_EQ(refusal(run_identity(input), more), "");
}

TEST(EnsembleIdentity, EveryDifferenceIsNamed) {
  const Case input = test_support::ensemble_case(10);
  Case other = input;
  other.montecarlo->seed = 2;
  other.bump_foil.height = 0.6e-3;
  other.montecarlo->friction_top_bump.reset();
  const std::string errors = refusal(run_identity(input), other);
  for (const char* one : {"ensemble.checkpoint: bump_foil.height = 0.000508: is 0.0006 now",
                          "montecarlo.seed = 1: is 2 now", "montecarlo.friction_top_bump.std = 0.01: is none now"}) {
    EXPECT_NE(errors.find(one), std::string::npos) << errors;
  }
  std::string elsewhere = run_identity(input);
  const std::size_t end = elsewhere.find('\n');
  elsewhere.replace(0, end, "bumpfoil 9.9.9 (abc)");
  EXPECT_NE(refusal(elsewhere, input).find("program = bumpfoil 9.9.9 (abc): is bumpfoil "), std::string::npos);
  elsewhere = run_identity(input);
  elsewhere.insert(end + 1, "another machine, ");
  EXPECT_NE(refusal(elsewhere, input).find("instruction set = another machine, "), std::string::npos);
}

TEST(EnsembleIdentity, TablesThatOneCaseHasMoreOfAreDifferences) {
  Case input = test_support::ensemble_case(10);
  input.bump_foil.shims = {{1, 2, 5e-6}};
  Case other = input;
  other.bump_foil.shims.push_back({4, 5, 6e-6});
  EXPECT_EQ(refusal(run_identity(input), input), "");
  const std::string more = refusal(run_identity(input), other);
  EXPECT_NE(more.find("bump_foil.shim[2].from = none: is 4 now"), std::string::npos) << more;
  EXPECT_EQ(more.find("shim[1]"), std::string::npos) << more;
  const std::string fewer = refusal(run_identity(other), input);
  EXPECT_NE(fewer.find("bump_foil.shim[2].thickness = 6e-06: is none now"), std::string::npos) << fewer;
  other.bump_foil.pitch = PerBump(4.2e-3, 4.3e-3, Grading::linear);
  const std::string graded = refusal(run_identity(input), other);
  EXPECT_NE(graded.find("bump_foil.pitch = 0.004572: is {"), std::string::npos) << graded;
}

TEST(EnsembleIdentity, HoldsTheCase) {
  const Case input = test_support::ensemble_case(30);
  EXPECT_EQ(run_identity(case_of_identity(run_identity(input))), run_identity(input));
  EXPECT_THROW(case_of_identity("bumpfoil 9\nx86-64\n[unheard_of]\n"), Error);
}

}  // namespace
}  // namespace bumpfoil
