#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/core/status.hpp"

/// The files that a run writes, and what is said of all of them.
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

/// Provenance of a result, for readers years later. Empty entries are left out.
struct Provenance {
  std::string command_line;
  std::string case_text;  ///< of the case file, as its author wrote it
  bool times{true};  ///< whether files contain when the run was and how long its parts took; if not, the run id follows
                     ///< from case and program, and the same run writes the same bytes
};

/// A file of a result set, before it is written.
struct ResultFile {
  std::string name;
  std::string contents;
};

/// A file beside summary.json.
struct FileChecksum {
  std::string name;
  std::size_t bytes{};
  std::string xxh3_128;
};

/// Lets readers distinguish the files of one run from those of another, and intact files from damaged ones.
struct Manifest {
  std::string run_id;  ///< 32 hexadecimal digits, at random; see Provenance::times
  std::vector<FileChecksum> files;
};

}  // namespace bumpfoil
