#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "model/checks.hpp"

namespace bumpfoil {

class CaseVisitor;

/// Visits the keys of the table [rotor], which experiments with a rotor share.
void describe_rotor(CaseVisitor& keys, Case& input);

/// Checks the table [rotor].
void check_rotor(Checks& checks, const Case& input);

/// Checks the rotor speeds of an experiment.
void check_rotor_speeds(Checks& checks, const std::string& key, const std::vector<double>& speeds);

}  // namespace bumpfoil
