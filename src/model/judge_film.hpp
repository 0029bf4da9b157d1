#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

/// Judges gas, film and the states of a bearing that runs.
/// @param bumps  whether the number of bumps is usable
void judge_film_settings(Judge& judge, const Case& input, bool bumps);

}  // namespace bumpfoil
