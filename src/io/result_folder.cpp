#include "bumpfoil/io/result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

/// Files whose presence makes a folder one that holds results.
constexpr std::array<std::string_view, 8> result_names{"summary.json", "cycle.csv",  "strip.csv",   "result.nc",
                                                       "ensemble.nc",  "study.json", "picture.svg", "report.html"};

[[noreturn]] void throw_unwritable(const fs::path& path, int code) {
  throw Error(ErrorKind::file,
              {{path.string(), 0, "", "", "cannot be written: " + std::generic_category().message(code),
                "give another place, or mend its permissions"}});
}

class FileDescriptor {
 public:
  /// `shown` stands for the file in messages.
  FileDescriptor(const fs::path& path, const fs::path& shown, int flags)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (fd_ < 0) throw_unwritable(shown, errno);
  }
  ~FileDescriptor() { ::close(fd_); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

/// Flushes a file or a folder to the disk.
void flush(const fs::path& path) {
  const FileDescriptor file(path, path, O_RDONLY);
  // Some file systems cannot flush folders, and say so by EINVAL.
  if (::fsync(file.get()) != 0 && errno != EINVAL) throw_unwritable(path, errno);
}

void write_contents(const fs::path& path, const fs::path& shown, std::string_view contents) {
  const FileDescriptor file(path, shown, O_WRONLY | O_CREAT | O_TRUNC);
  while (!contents.empty()) {
    const ssize_t count = ::write(file.get(), contents.data(), contents.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_unwritable(shown, errno);
    contents.remove_prefix(static_cast<std::size_t>(count));
  }
}

void rename_flushed(const fs::path& from, const fs::path& to) {
  flush(from);
  std::error_code code;
  fs::rename(from, to, code);
  if (code) throw_unwritable(to, code.value());
}

/// Hidden, beside the file, and of this process alone.
fs::path temporary(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.tmp", path.filename().string(), ::getpid());
}

void remove_quietly(const fs::path& path) {
  std::error_code code;
  fs::remove(path, code);
}

}  // namespace

ResultFolder::ResultFolder(fs::path path, Existing existing) : path_(std::move(path)) {
  std::error_code code;
  made_ = fs::create_directories(path_, code);
  if (code) throw_unwritable(path_, code.value());
  if (::access(path_.c_str(), W_OK | X_OK) != 0) throw_unwritable(path_, errno);
  if (existing == Existing::replace) return;
  for (const std::string_view name : result_names) {
    if (fs::exists(path_ / name, code)) {
      throw Error(ErrorKind::file, {{path_.string(), 0, "", "", fmt::format("holds results already ({})", name),
                                     "give another folder, or --force to replace them"}});
    }
  }
}

ResultFolder::~ResultFolder() {
  for (const std::string& name : staged_) remove_quietly(temporary(path_ / name));
  if (made_) remove_quietly(path_);  // stays where it holds anything
}

fs::path ResultFolder::stage(const std::string& name) {
  staged_.push_back(name);
  return temporary(path_ / name);
}

fs::path ResultFolder::stage(const std::string& name, std::string_view contents) {
  fs::path staged = stage(name);
  write_contents(staged, path_ / name, contents);
  return staged;
}

void ResultFolder::discard(const std::string& name) {
  std::erase(staged_, name);
  remove_quietly(temporary(path_ / name));
}

void ResultFolder::publish() {
  for (const std::string& name : staged_) flush(temporary(path_ / name));
  for (const std::string_view name : result_names) {
    if (std::find(staged_.begin(), staged_.end(), name) == staged_.end()) remove_quietly(path_ / name);
  }
  for (const std::string& name : staged_) rename_flushed(temporary(path_ / name), path_ / name);
  staged_.clear();
  flush(path_);
}

void write_file(const fs::path& path, std::string_view contents, Existing existing) {
  std::error_code code;
  if (existing == Existing::refuse && fs::exists(path, code)) {
    throw Error(ErrorKind::file,
                {{path.string(), 0, "", "", "exists already", "give another name, or --force to replace it"}});
  }
  if (fs::exists(path, code) && !fs::is_regular_file(path, code)) {
    throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is no ordinary file", "give the name of a file"}});
  }
  const fs::path staged = temporary(path);
  try {
    write_contents(staged, path, contents);
    rename_flushed(staged, path);
  } catch (...) {
    remove_quietly(staged);
    throw;
  }
}

}  // namespace bumpfoil
