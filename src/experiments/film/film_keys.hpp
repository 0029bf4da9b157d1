#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

class CaseVisitor;

/// Visits the tables of gas, film and mixed contact that a bearing of a rotor has otherwise than the case.
void describe_own_film(CaseVisitor& keys, const Case& common, RotorBearing& own);

}  // namespace bumpfoil
