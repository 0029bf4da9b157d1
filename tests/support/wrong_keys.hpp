#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::test_support {

using Keys = std::vector<std::string>;

/// Keys of errors after a change of the reference case.
Keys wrong_keys(const std::function<void(Case&)>& change);

}  // namespace bumpfoil::test_support
