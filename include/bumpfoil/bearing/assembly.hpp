#pragma once

#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"

namespace bumpfoil {

/// Foils assembled in the sleeve without a journal, pad after pad.
/// @return none where the contacts cannot be solved
std::vector<PadAssembly> assemble_without_journal(const BearingModel& foils);

}  // namespace bumpfoil
