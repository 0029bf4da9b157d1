#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A key that two cases give different values.
struct CaseDifference {
  std::string key;
  std::string theirs, ours;  ///< SI; "none" if absent
};

/// All differences, in the order of the case file. The source file of a list is not compared.
std::vector<CaseDifference> case_differences(const Case& theirs, const Case& ours);

}  // namespace bumpfoil
