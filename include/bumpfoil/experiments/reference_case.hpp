#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The first-generation bearing of [Arghir2019, Table 1] with friction coefficient 0.1, pushed to 2.5 clearances along
/// +X, -X, +Y and -Y.
Case reference_case();

}  // namespace bumpfoil
