#include "bumpfoil/ensemble/ensemble_checkpoint.hpp"

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/run_identity.hpp"

namespace bumpfoil {

void require_no_checkpoint(const std::filesystem::path& checkpoint, const std::string& advice) {
  if (!std::filesystem::exists(checkpoint)) return;
  throw Error(ErrorKind::file, {{checkpoint.string(), 0, "", "", "is of an unfinished run", advice}});
}

RowLog open_ensemble_log(const std::filesystem::path& checkpoint, bool resumes, const Case& input, std::size_t width) {
  if (!resumes) return {checkpoint, run_identity(input), width};
  require_same_run(*RowLog::identity_of(checkpoint), input, checkpoint.string());
  return RowLog::open(checkpoint, width);
}

}  // namespace bumpfoil
