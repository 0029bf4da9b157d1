#pragma once

#include <filesystem>
#include <string>

#include "readers/summary_reader.hpp"

namespace bumpfoil {

/// A data file and its summary, of one set.
struct StoredResult {
  StoredSummary summary;
  std::string bytes;  ///< of the file of numbers
};

struct StoredResultOptions {
  bool checked = true;   ///< whether checksums must be those that summary.json lists
  std::string advice{};  ///< what to do about damage
};

/// @throws Error (file): damaged
[[noreturn]] void refuse_damaged(const std::filesystem::path& path, std::string what, std::string advice);

/// Reads a file of numbers, and summary.json beside it, that belong together and are not damaged.
/// @throws Error (file) if one is missing, damaged, or no result
StoredResult read_stored_result(const std::filesystem::path& folder, const std::string& name,
                                const StoredResultOptions& options);

}  // namespace bumpfoil
