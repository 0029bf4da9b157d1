#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

/// Checks gas, film and the states of a running bearing.
/// @param bumps  whether the number of bumps is usable
void judge_film_settings(Judge& judge, const Case& input, bool bumps);

}  // namespace bumpfoil
