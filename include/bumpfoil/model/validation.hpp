#pragma once

#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Everything that is physically wrong with a case (signs, sizes, overlap, lengths of lists, models that do not fit
/// together), one fault each with its key, the value in SI and what to change; empty when the case can be built.
/// File and line are left empty: only the reader of a case file knows them.
std::vector<Fault> find_faults(const Case& input);

/// @throws Error (input) listing all of find_faults(input) if there are any.
void require_valid(const Case& input);

}  // namespace bumpfoil
