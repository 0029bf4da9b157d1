#include "results/publication.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
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

/// Name of the folder of a set that counts as published, and in it the list of its files, one a line.
fs::path set_folder(const fs::path& folder) {
  return work_folder(folder) / "set";
}
constexpr const char* list_name = ".files";

void write_list(const fs::path& staging, const fs::path& folder, const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += name + '\n';
  write_all(FileDescriptor(staging / list_name, folder, O_WRONLY | O_CREAT | O_TRUNC), list, folder);
}

std::vector<std::string> read_list(const fs::path& set) {
  std::ifstream file(set / list_name);
  std::vector<std::string> names;
  for (std::string name; std::getline(file, name);) names.push_back(name);
  return names;
}

}  // namespace

void publish_staged(const fs::path& staging, const fs::path& folder, const std::vector<std::string>& names,
                    const BeforeStep& before) {
  before();
  write_list(staging, folder, names);
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
  const std::vector<std::string> names = read_list(set);
  if (!names.empty()) {
    for (const std::string_view name : result_names) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      before();
      ::unlink((folder / name).c_str());
    }
    for (const std::string& name : names) {
      before();
      // What is not there any more was moved before.
      if (::rename((set / name).c_str(), (folder / name).c_str()) != 0 && errno != ENOENT) {
        throw_unwritable(folder / name, errno);
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
