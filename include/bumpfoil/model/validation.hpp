#pragma once

#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Most bumps that a foil may have.
inline constexpr int most_bumps = 100'000;

/// Most points that a path may be given by.
inline constexpr int most_points = 1'000'000;

/// Everything that is physically wrong with a case (signs, sizes, overlap, lengths of lists, models that do not fit
/// together), one fault each with its key, the value in SI and what to change; empty when the case can be built.
/// Entries of lists are counted from 1, as bumps are: "bump_foil.height_errors[3]". A value that is wrong by itself is
/// not judged together with others. File and line are left empty: only the reader of a case file knows them.
///
/// A case without directions and amplitude has no cycle to run, and one with a strip may have no bearing, neither of
/// which is a fault.
std::vector<Fault> find_faults(const Case& input);

/// @throws Error (input) listing all of find_faults(input) if there are any.
void require_valid(const Case& input);

/// @throws Error (input) as require_valid() does, and if there is no bearing in the case, but a strip alone.
void require_bearing(const Case& input);

}  // namespace bumpfoil
