#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::test_support {

using Keys = std::vector<std::string>;

/// A value that is wrong everywhere.
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Keys of errors after a change of the reference case.
Keys wrong_keys(const std::function<void(Case&)>& change);

}  // namespace bumpfoil::test_support
