#include "results/publication.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "results/folder_claim.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

/// Name of the folder of a published set, and in it the list of its files, one per line; a leading minus marks files
/// that it makes stale.
fs::path set_folder(const fs::path& folder) {
  return work_folder(folder) / "set";
}
constexpr const char* list_name = ".files";
constexpr char stale_mark = '-';

void write_list(const fs::path& staging, const fs::path& folder, const std::vector<std::string>& names,
                const std::vector<std::string>& stale) {
  std::string list;
  for (const std::string& name : stale) list += stale_mark + name + '\n';
  for (const std::string& name : names) list += name + '\n';
  write_all(FileDescriptor(staging / list_name, folder, O_WRONLY | O_CREAT | O_TRUNC), list, folder);
}

std::vector<std::string> read_list(const fs::path& set) {
  std::ifstream file(set / list_name);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace

void publish_staged(const fs::path& staging, const fs::path& folder, const std::vector<std::string>& names,
                    const std::vector<std::string>& stale, const BeforeStep& before) {
  before();
  write_list(staging, folder, names, stale);
  flush(staging / list_name, folder);
  for (const std::string& name : names) flush(staging / name, folder / name);
  flush(staging, folder);
  before();
  if (::rename(staging.c_str(), set_folder(folder).c_str()) != 0) throw_unwritable(folder, errno);
  flush(work_folder(folder), folder);
  flush(folder, folder);
  complete_publication(folder, before);
}

void complete_publication(const fs::path& folder, const BeforeStep& before) {
  const fs::path set = set_folder(folder);
  const std::vector<std::string> lines = read_list(set);
  if (!lines.empty()) {
    for (const std::string& line : lines) {
      before();
      if (line.starts_with(stale_mark)) {
        ::unlink((folder / line.substr(1)).c_str());
        continue;
      }
      // A missing file was moved earlier.
      if (::rename((set / line).c_str(), (folder / line).c_str()) != 0 && errno != ENOENT) {
        throw_unwritable(folder / line, errno);
      }
    }
    flush(folder, folder);
    before();
    ::unlink((set / list_name).c_str());
  }
  before();
  ::rmdir(set.c_str());
}

fs::path published_file(const fs::path& folder, const std::string& name) {
  const fs::path on_its_way = set_folder(folder) / name;
  std::error_code code;
  return fs::exists(on_its_way, code) ? on_its_way : folder / name;
}

}  // namespace bumpfoil
