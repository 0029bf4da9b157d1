#include "results/posix_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

std::string advice_for(int code) {
  switch (code) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space, or use another folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "use another folder, or fix its permissions";
    default:
      return "use another folder";
  }
}

}  // namespace

void throw_unwritable(const fs::path& shown, int code) {
  throw Error(ErrorKind::file, {{shown.string(), 0, "", "",
                                 "cannot be written: " + std::generic_category().message(code), advice_for(code)}});
}

FileDescriptor::FileDescriptor(const fs::path& path, const fs::path& shown, int flags)
    : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw_unwritable(shown, errno);
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

bool FileDescriptor::is_at(const fs::path& path) const {
  struct stat opened {};
  struct stat named {};
  if (::fstat(descriptor_, &opened) != 0 || ::stat(path.c_str(), &named) != 0) return false;
  return opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

Lock try_to_lock(const FileDescriptor& file) {
  while (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EINTR) return errno == EWOULDBLOCK ? Lock::held_by_another : Lock::unsupported;
  }
  return Lock::taken;
}

void write_all(const FileDescriptor& file, std::string_view contents, const fs::path& shown) {
  while (!contents.empty()) {
    const ssize_t count = ::write(file.get(), contents.data(), contents.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_unwritable(shown, errno);
    contents.remove_prefix(static_cast<std::size_t>(count));
  }
}

void flush(const fs::path& path, const fs::path& shown) {
  const FileDescriptor file(path, shown, O_RDONLY);
  // Some file systems cannot flush folders, and return EINVAL.
  if (::fsync(file.get()) != 0 && errno != EINVAL) throw_unwritable(shown, errno);
}

void rename_file(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) throw_unwritable(to, errno);
}

std::string random_digits() {
  return fmt::format("{:08x}", std::random_device()());
}

}  // namespace bumpfoil
