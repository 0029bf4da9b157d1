#pragma once

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

class CaseVisitor;

/// Visits the tables of gas, film and mixed contact in which a bearing of a rotor differs from the case.
void describe_own_film(CaseVisitor& keys, const Case& common, RotorBearing& own);

}  // namespace bumpfoil
