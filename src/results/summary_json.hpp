#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// A number; null if not finite.
nlohmann::ordered_json value_json(double value, const Form& form = {});

/// Values of quantities of something, by their keys.
template <typename Quantities, typename... Of>
nlohmann::ordered_json values_json(const Quantities& quantities, const Of&... of) {
  nlohmann::ordered_json json;
  for (const auto& quantity : quantities) json[quantity.key()] = value_json(quantity.value(of...), quantity.form);
  return json;
}

/// Rows of a table, by the keys of its columns.
std::vector<nlohmann::ordered_json> rows_json(const Table& table);

/// The common header of all summaries. @param input  the case that was run, or one of several
nlohmann::ordered_json summary_head(std::string_view command, const Case& input, RunStatus status,
                                    const Manifest& manifest);

/// Text of a summary, including its checksum.
std::string sealed_summary(const nlohmann::ordered_json& json);

}  // namespace bumpfoil
