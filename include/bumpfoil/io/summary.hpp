#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// How a run ended.
enum class RunStatus {
  complete,
  failed,       ///< a numerical failure: the results are partial
  interrupted,  ///< stopped by the user or the system: the results are partial
};

template <>
inline constexpr auto enum_names<RunStatus> = std::to_array<std::string_view>({"complete", "failed", "interrupted"});

/// How a run ended whose parts ended so, of `due` ones: stopped between two parts, it lacks some without any that says
/// so.
RunStatus run_status(const std::vector<Status>& parts, std::size_t due);

/// How a run of cycles ended.
RunStatus status_of(const CycleResult& result);

/// A file beside summary.json.
struct FileChecksum {
  std::string name;
  std::size_t bytes{};
  std::string xxh3_128;
};

/// By what readers tell the files of one run from those of another, and whole files from damaged ones.
struct Manifest {
  std::string run_id;  ///< 32 hexadecimal digits, at random
  std::vector<FileChecksum> files;
};

/// Contents of summary.json: the command, the case as understood, version, solver, run id and checksums, and the
/// derived quantities of every cycle. Quantities that are not known, and none but these, are null.
std::string summary_json(const Case& input, const CycleResult& result, RunStatus status, const Manifest& manifest);

/// An angle (rad) in degrees; where roundings hide a whole number of them, that.
double to_degrees(double angle);

}  // namespace bumpfoil
