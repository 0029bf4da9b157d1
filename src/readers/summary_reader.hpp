#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace bumpfoil {

/// Entry of summary.json for a file in the same folder.
struct ListedFile {
  std::size_t bytes{};
  std::string xxh3_128;
};

/// A summary.json of verified structure.
struct StoredSummary {
  nlohmann::ordered_json json;
  std::string xxh3_128;  ///< of the summary itself
  std::string run_id;
  std::map<std::string, ListedFile> files;  ///< by name
};

/// Reads and verifies summary.json: schema, names and types of the contents of a report.
/// @param text  of the file   @param name  of the file in messages
/// @throws Error (file) naming file and key
StoredSummary read_summary(std::string_view text, const std::string& name);

/// Verifies that a summary belongs to the same run as a result from read_result: command, run id, cycles with their
/// steps. Reorders the cycles as in the summary.
/// @param name  of the summary in messages   @param result_name  of the file beside it @throws Error (file)
void match_runs(const StoredSummary& summary, nlohmann::ordered_json& result, const std::string& name,
                std::string_view result_name);

}  // namespace bumpfoil
