#include "bumpfoil/results/result_set.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(ResultSet, ARunIsCompleteWhenAllOfItsPartsAreThereAndConverged) {
  EXPECT_EQ(run_status({Status::converged, Status::converged}, 2), RunStatus::complete);
  EXPECT_EQ(run_status({Status::converged}, 2), RunStatus::interrupted);
  EXPECT_EQ(run_status({Status::converged, Status::no_modes}, 2), RunStatus::failed);
  EXPECT_EQ(run_status({Status::no_modes, Status::interrupted}, 3), RunStatus::interrupted);
}

}  // namespace
}  // namespace bumpfoil
