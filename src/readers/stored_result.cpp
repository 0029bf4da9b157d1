#include "readers/stored_result.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "readers/binary_file.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

/// Verifies a file listed in summary.json.
void require_intact(const fs::path& path, const StoredResult& result, const std::string& advice) {
  const auto refuse = [&](std::string what) { refuse_damaged(path, std::move(what), advice); };
  const auto listed = result.summary.files.find(path.filename().string());
  if (listed == result.summary.files.end()) return refuse("summary.json does not list it");
  const auto& [size, checksum] = listed->second;
  if (result.bytes.size() != size) {
    refuse(fmt::format("it has {} bytes, summary.json lists {}", result.bytes.size(), size));
  }
  if (xxh3_128(result.bytes) != checksum) refuse("its checksum is not the one that summary.json lists");
}

}  // namespace

void refuse_damaged(const fs::path& path, std::string what, std::string advice) {
  throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is damaged: " + std::move(what), std::move(advice)}});
}

StoredResult read_stored_result(const fs::path& folder, const std::string& name, const StoredResultOptions& options) {
  std::error_code code;
  complete_publication_quietly(folder);
  for (const std::string& file : {name, std::string("summary.json")}) {
    if (fs::exists(published_file(folder, file), code)) continue;
    throw Error(ErrorKind::file, {{folder.string(), 0, "", "", fmt::format("contains no results: {} is missing", file),
                                   "give the folder of a run, such as `bumpfoil cycle CASE -o DIR` writes"}});
  }
  const auto read = [&folder](const std::string& file) { return read_binary_file(published_file(folder, file)); };
  const fs::path summary_path = folder / "summary.json";
  std::string text = read("summary.json");
  StoredResult result{.summary = {}, .bytes = read(name)};
  // Another set may have been published between both reads.
  for (std::string now = read("summary.json"); now != text; now = read("summary.json")) {
    text = std::move(now);
    result.bytes = read(name);
  }
  result.summary = read_summary(text, summary_path.string());
  if (options.checked) {
    if (!is_sealed(text, result.summary.xxh3_128)) {
      refuse_damaged(summary_path, "it does not have the checksum in it", options.advice);
    }
    require_intact(folder / name, result, options.advice);
  }
  return result;
}

}  // namespace bumpfoil
