#include "bumpfoil/results/result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/made_folder.hpp"
#include "results/folder_claim.hpp"
#include "results/posix_file.hpp"
#include "results/publication.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view staging_prefix = "staged-";

/// Completes the publication of a killed process, and removes its unpublished files. Takes the claim.
void clean_up(const fs::path& folder) {
  complete_publication(folder, [] {});
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(work_folder(folder), code)) {
    if (entry.path().filename().string().starts_with(staging_prefix)) fs::remove_all(entry.path(), code);
  }
}

}  // namespace

struct ResultFolder::Claimed {
  explicit Claimed(const fs::path& path)
      : folder(path), claim(path), staging(work_folder(path) / (std::string(staging_prefix) + random_digits())) {
    clean_up(path);
  }
  ~Claimed() {
    std::error_code code;
    fs::remove_all(staging, code);
  }
  Claimed(const Claimed&) = delete;
  Claimed& operator=(const Claimed&) = delete;

  MadeFolder folder;
  FolderClaim claim;
  fs::path staging;
};

ResultFolder::ResultFolder(fs::path path, Existing existing, std::vector<std::string> names)
    : path_(std::move(path)),
      existing_(existing),
      names_(std::move(names)),
      claimed_(std::make_unique<Claimed>(path_)) {
  check_places();
  std::error_code code;
  if (!fs::create_directory(claimed_->staging, code)) throw_unwritable(path_, code.value());
}

ResultFolder::~ResultFolder() = default;

fs::path ResultFolder::stage(const std::string& name) {
  BUMPFOIL_ASSERT(std::find(names_.begin(), names_.end(), name) != names_.end());
  staged_.push_back(name);
  return claimed_->staging / name;
}

fs::path ResultFolder::stage(const std::string& name, std::string_view contents) {
  fs::path staged = stage(name);
  write_all(FileDescriptor(staged, path_ / name, O_WRONLY | O_CREAT | O_TRUNC), contents, path_ / name);
  return staged;
}

void ResultFolder::discard(const std::string& name) {
  std::erase(staged_, name);
  std::error_code code;
  fs::remove(claimed_->staging / name, code);
}

void ResultFolder::publish(const std::function<void()>& before) {
  if (!claimed_->claim.is_held()) {
    throw Error(ErrorKind::file, {{path_.string(), 0, "", "",
                                   "another run has meanwhile taken over this folder, or its .bumpfoil was removed",
                                   "use a separate folder for each run, and leave it alone until the run ends"}});
  }
  check_places();
  std::vector<std::string> stale = result_names();
  stale.insert(stale.end(), names_.begin(), names_.end());
  std::erase_if(stale, [this](const std::string& name) {
    return std::find(staged_.begin(), staged_.end(), name) != staged_.end();
  });
  publish_staged(claimed_->staging, path_, staged_, stale, before);
}

void ResultFolder::check_places() const {
  const auto check = [this](const std::string& name) {
    std::error_code code;
    const fs::file_status status = fs::symlink_status(path_ / name, code);
    if (!fs::exists(status)) return;
    if (fs::is_directory(status)) {
      throw Error(ErrorKind::file,
                  {{(path_ / name).string(), 0, "", "", "is a folder", "move it away, or give another folder"}});
    }
    if (existing_ == Existing::refuse) {
      throw Error(ErrorKind::file, {{path_.string(), 0, "", "", fmt::format("already contains results ({})", name),
                                     "give another folder, or --force to replace them"}});
    }
  };
  for (const std::string& name : result_names()) check(name);
  for (const std::string& name : names_) check(name);
}

void complete_publication_quietly(const fs::path& folder) {
  std::error_code code;
  if (!fs::exists(work_folder(folder), code)) return;
  try {
    const FolderClaim claim(folder);
    clean_up(folder);
  } catch (const Error&) {
    // Another process is about to do it, or the folder is read-only.
  }
}

}  // namespace bumpfoil
