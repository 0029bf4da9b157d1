#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace bumpfoil {

/// Measured loops as one more run of a report, so that they are drawn and listed like those that they are compared
/// with. It has what was measured and what follows from it: displacement, force, work, and the quantities of these; no
/// fields, an empty case, and `measured` where other runs have none.
/// @param path  of the file, see read_measured_loops()
/// @param name  of the run
/// @param runs  the others; of the first kind among them that has cycles are these
/// @throws Error (input) if the file cannot be understood, or has loops of no cycle that runs have
nlohmann::ordered_json measured_run(const std::string& path, const std::string& name,
                                    const nlohmann::ordered_json& runs);

}  // namespace bumpfoil
