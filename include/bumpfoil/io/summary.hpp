#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// How a run ended.
enum class RunStatus {
  complete,
  failed,       ///< a numerical failure: the results are partial
  interrupted,  ///< stopped by the user: the results are partial
};

/// "complete", "failed" or "interrupted".
std::string_view name_of(RunStatus status);

/// Contents of summary.json: the command, the case as understood, version, solver, and the derived quantities of every
/// cycle.
/// Quantities that are not known, and none but these, are null.
std::string summary_json(const Case& input, const CycleResult& result, RunStatus status);

/// An angle (rad) in degrees; where roundings hide a whole number of them, that.
double to_degrees(double angle);

}  // namespace bumpfoil
