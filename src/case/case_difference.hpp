#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A key that two cases give different values.
struct CaseDifference {
  std::string key;
  std::string theirs, ours;  ///< SI; "none" where there is none
};

/// All of them, in the order of the case file. Files that lists came from make no difference.
std::vector<CaseDifference> case_differences(const Case& theirs, const Case& ours);

}  // namespace bumpfoil
