#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

/// @param limit  displacement that presses the bumps flat, m; 0 if it is not known
void judge_vibration(Judge& judge, const VibrationSettings& vibration, double limit);

}  // namespace bumpfoil
