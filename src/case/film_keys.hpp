#pragma once

#include "bumpfoil/model/case.hpp"
#include "case/case_keys.hpp"

namespace bumpfoil {

/// Keys of the tables [gas], [film] and [equilibrium].
void describe(CaseVisitor& keys, GasSettings& gas);
void describe(CaseVisitor& keys, FilmSettings& film);
void describe(CaseVisitor& keys, EquilibriumSettings& equilibrium);

}  // namespace bumpfoil
