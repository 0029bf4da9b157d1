#include "results/folder_claim.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}", ::getpid(), host.data());
}

std::string read_start(const FileDescriptor& file) {
  std::array<char, 300> text{};
  const ssize_t count = ::pread(file.get(), text.data(), text.size(), 0);
  return {text.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

}  // namespace

fs::path work_folder(const fs::path& folder) {
  return folder / ".bumpfoil";
}

FolderClaim::FolderClaim(const fs::path& folder)
    : folder_(folder), path_(work_folder(folder) / "claim"), owner_(this_process()), file_(open_locked()) {
  if (::ftruncate(file_.get(), 0) != 0) throw_unwritable(folder_, errno);
  write_all(file_, owner_, folder_);
}

FolderClaim::~FolderClaim() {
  if (is_held()) ::unlink(path_.c_str());
  ::rmdir(work_folder(folder_).c_str());
}

bool FolderClaim::is_held() const {
  return file_.is_at(path_) && read_start(file_) == owner_;
}

FileDescriptor FolderClaim::open_locked() const {
  while (true) {
    if (::mkdir(work_folder(folder_).c_str(), 0777) != 0 && errno != EEXIST) throw_unwritable(folder_, errno);
    FileDescriptor file(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (file.get() < 0) {
      if (errno == ENOENT) continue;  // the previous owner has just removed its work folder
      throw_unwritable(folder_, errno);
    }
    if (try_to_lock(file) == Lock::held_by_another) {
      throw Error(ErrorKind::file, {{folder_.string(), 0, "", "",
                                     fmt::format("another run writes to this folder ({})", printable(read_start(file))),
                                     "wait until it ends, or use another folder"}});
    }
    if (file.is_at(path_)) return file;  // otherwise the previous owner has removed it
  }
}

}  // namespace bumpfoil
