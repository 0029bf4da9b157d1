#include "readers/binary_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {

std::string read_binary_file(const std::filesystem::path& path) try {
  const auto error = [&](std::string what, std::string advice = "") {
    return Error(ErrorKind::file, {{path.string(), 0, "", "", std::move(what), std::move(advice)}});
  };
  const auto unreadable = [&] { return error("cannot be read: " + std::generic_category().message(errno)); };
  // Opening a pipe without a writer must not block before it is rejected.
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) throw unreadable();
  if (!S_ISREG(status.st_mode)) throw error("is not a regular file");
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t count = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw unreadable();
    if (count == 0) break;  // truncated in the meantime
    size += static_cast<std::size_t>(count);
  }
  bytes.resize(size);
  return bytes;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is larger than the available memory", ""}});
}

}  // namespace bumpfoil
