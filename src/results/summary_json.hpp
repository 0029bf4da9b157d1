#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// A number; null if not finite.
nlohmann::ordered_json value_json(double value, const Form& form = {});

/// The common header of all summaries. @param input  the case that was run, or one of several
nlohmann::ordered_json summary_head(std::string_view command, const Case& input, RunStatus status,
                                    const Manifest& manifest);

/// Text of a summary, including its checksum.
std::string sealed_summary(const nlohmann::ordered_json& json);

}  // namespace bumpfoil
