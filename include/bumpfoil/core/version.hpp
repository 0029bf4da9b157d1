#pragma once

#include <string_view>

namespace bumpfoil {

/// Version of the library, "major.minor.patch".
std::string_view version();

/// Short hash of the commit that was built, or "unknown" outside a git checkout.
std::string_view commit();

}  // namespace bumpfoil
