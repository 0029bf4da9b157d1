#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

class CaseVisitor;

/// Visits the keys of the table [rotor], which experiments with a rotor share.
void describe_rotor(CaseVisitor& keys, Case& input);

/// Checks the table [rotor].
void judge_rotor(Judge& judge, const Case& input);

/// Checks the rotor speeds of an experiment.
void judge_rotor_speeds(Judge& judge, const std::string& key, const std::vector<double>& speeds);

}  // namespace bumpfoil
