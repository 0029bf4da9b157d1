#pragma once

#include <string>

#include "fuzz/draws_of_bytes.hpp"

namespace bumpfoil {

/// A result file of a small run, with declarations and numbers that its bytes change: variables that are missing, have
/// other dimensions, names, units or numbers, attributes that lie. libhdf5 reads it rightly; what damaged files do to
/// that library is not ours to find.
std::string changed_result(DrawsOfBytes draws);

}  // namespace bumpfoil
