#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// A number; null where it is not finite.
nlohmann::ordered_json value_json(double value, const Form& form = {});

/// The head of every summary. @param input  the case, or one of those, that were run
nlohmann::ordered_json summary_head(std::string_view command, const Case& input, RunStatus status,
                                    const Manifest& manifest);

/// Text of a summary, with its checksum in it.
std::string sealed_summary(const nlohmann::ordered_json& json);

}  // namespace bumpfoil
