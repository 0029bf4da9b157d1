#pragma once

#include <string>

#include "fuzz/draws_of_bytes.hpp"

namespace bumpfoil {

/// A result file of a small run, with declarations and numbers changed by the bytes: missing variables, other
/// dimensions, names, units or numbers, wrong attributes. The file is valid HDF5; damaged files in libhdf5 are out of
/// scope.
std::string changed_result(DrawsOfBytes draws);

}  // namespace bumpfoil
