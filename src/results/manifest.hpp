#pragma once

#include <string>
#include <vector>

#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// 128 random bits from the system, as 32 hexadecimal digits.
std::string make_run_id();

/// The summary entry that lists the files beside it.
Manifest make_manifest(std::string run_id, const std::vector<ResultFile>& files);

}  // namespace bumpfoil
