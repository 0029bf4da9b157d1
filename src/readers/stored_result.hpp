#pragma once

#include <filesystem>
#include <string>

#include "readers/summary_reader.hpp"

namespace bumpfoil {

/// A data file and its summary, from one set.
struct StoredResult {
  StoredSummary summary;
  std::string bytes;  ///< of the data file
};

struct StoredResultOptions {
  bool checked = true;   ///< whether checksums must match those in summary.json
  std::string advice{};  ///< advice in case of damage
};

/// @throws Error (file): damaged
[[noreturn]] void refuse_damaged(const std::filesystem::path& path, std::string what, std::string advice);

/// Reads a data file and summary.json beside it, which must belong together and be intact.
/// @throws Error (file) if one is missing, damaged, or not a result
StoredResult read_stored_result(const std::filesystem::path& folder, const std::string& name,
                                const StoredResultOptions& options);

}  // namespace bumpfoil
