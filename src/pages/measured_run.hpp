#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/pages/report.hpp"

namespace bumpfoil {

/// Measured loops as an additional run of a report, drawn and listed like those they are compared with. It contains the
/// measurement and derived quantities: displacement, force, work, and their quantities; no fields, an empty case, and
/// `measured`, which other runs lack.
/// @param file     see read_measured_loops()
/// @param columns  see parse_measured_columns()
/// @param name     of the run
/// @param runs     the others; the loops belong to the first kind among them that has cycles
/// @param warn     unless empty, called with remarks on a loop: that it is the last of several, and that it is not
///   closed
/// @throws Error (input) if the file is invalid, or has loops of cycles that no run has
nlohmann::ordered_json measured_run(const MeasuredFile& file, const std::string& columns, const std::string& name,
                                    const nlohmann::ordered_json& runs,
                                    const std::function<void(const std::string&)>& warn);

}  // namespace bumpfoil
