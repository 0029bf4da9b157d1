#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

class CaseVisitor;

/// Visits the keys of the table [rotor], which experiments with a rotor share.
void describe_rotor(CaseVisitor& keys, Case& input);

/// Checks it.
void judge_rotor(Judge& judge, const Case& input);

}  // namespace bumpfoil
