#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/pages/report.hpp"

namespace bumpfoil {

/// Measured loops as one more run of a report, so that they are drawn and listed like those that they are compared
/// with. It has what was measured and what follows from it: displacement, force, work, and the quantities of these; no
/// fields, an empty case, and `measured` where other runs have none.
/// @param file     see read_measured_loops()
/// @param columns  see parse_measured_columns()
/// @param name     of the run
/// @param runs     the others; of the first kind among them that has cycles are these
/// @param warn     called, where there is one, with what is to be known of a loop: of how many it is the last, and that
///                 it does not close
/// @throws Error (input) if the file cannot be understood, or has loops of no cycle that runs have
nlohmann::ordered_json measured_run(const MeasuredFile& file, const std::string& columns, const std::string& name,
                                    const nlohmann::ordered_json& runs,
                                    const std::function<void(const std::string&)>& warn);

}  // namespace bumpfoil
