#include "bumpfoil/ensemble/ensemble_checkpoint.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/run_identity.hpp"
#include "support/ensemble_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class EnsembleCheckpoints : public ::testing::Test {
 protected:
  void begin(const Case& input) { open_ensemble_log(path_, false, input, 2).append(std::vector{1.0, 2.0, 3.0, 4.0}); }

  test_support::TemporaryFolder folder_;
  std::filesystem::path path_{folder_.path() / checkpoint_name};
};

TEST_F(EnsembleCheckpoints, AreNeitherReplacedNorGoneOnWithUnasked) {
  EXPECT_NO_THROW(require_no_checkpoint(path_, "ask"));
  begin(test_support::ensemble_case(10));
  try {
    require_no_checkpoint(path_, "ask for it");
    FAIL() << "a checkpoint was there";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_NE(std::string(error.what()).find("is of an unfinished run"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("ask for it"), std::string::npos) << error.what();
  }
}

TEST_F(EnsembleCheckpoints, AreGoneOnWithOrBegunAnew) {
  const Case input = test_support::ensemble_case(10);
  begin(input);
  EXPECT_EQ(RowLog::identity_of(path_), run_identity(input));
  EXPECT_EQ(open_ensemble_log(path_, true, input, 2).rows(), 2U);
  EXPECT_EQ(open_ensemble_log(path_, false, input, 2).rows(), 0U);
}

TEST_F(EnsembleCheckpoints, OfAnotherEnsembleAreRefused) {
  Case input = test_support::ensemble_case(10);
  begin(input);
  input.montecarlo->seed += 1;
  EXPECT_THROW(open_ensemble_log(path_, true, input, 2), Error);
  EXPECT_EQ(RowLog::open(path_, 2).rows(), 2U);
}

}  // namespace
}  // namespace bumpfoil
