#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bumpfoil/io/result_quantities.hpp"
#include "bumpfoil/io/summary.hpp"

namespace bumpfoil {

/// A number; null where it is not finite.
nlohmann::ordered_json value_json(double value, const Form& form = {});

/// The quantities of a cycle, its warnings, and why it ended before its time.
nlohmann::ordered_json cycle_json(const Case& input, const CycleResult& result, std::size_t cycle);

/// What every summary begins with. @param input  the case, or one of those, that were run
nlohmann::ordered_json summary_head(std::string_view command, const Case& input, RunStatus status,
                                    const Manifest& manifest);

/// Text of a summary, with its checksum in it.
std::string sealed_summary(const nlohmann::ordered_json& json);

}  // namespace bumpfoil
