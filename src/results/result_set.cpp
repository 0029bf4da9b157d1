#include "bumpfoil/results/result_set.hpp"

#include <algorithm>

namespace bumpfoil {

RunStatus run_status(const std::vector<Status>& parts, std::size_t due) {
  const auto is = [](Status one) { return [one](Status status) { return status == one; }; };
  if (std::any_of(parts.begin(), parts.end(), is(Status::interrupted))) return RunStatus::interrupted;
  if (!std::all_of(parts.begin(), parts.end(), is(Status::converged))) return RunStatus::failed;
  return parts.size() < due ? RunStatus::interrupted : RunStatus::complete;
}

}  // namespace bumpfoil
