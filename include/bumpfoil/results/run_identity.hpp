#pragma once

#include <string>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// What the numbers of a run that can be gone on with depend on to the last bit: program, instruction set of the
/// machine, and the case with its seed. The number of samples, and the title, are not of it.
std::string run_identity(const Case& input);

/// The case in an identity, with one sample.
/// @throws Error (input) if this program cannot read it
Case case_of_identity(const std::string& identity);

/// @param identity  of the run that is to be gone on with   @param file  that it is from
/// @throws Error (input) that names every difference to that of the case
void require_same_run(const std::string& identity, const Case& input, const std::string& file);

}  // namespace bumpfoil
