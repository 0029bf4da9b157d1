#include "bumpfoil/results/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {
namespace {

namespace fs = std::filesystem;

/// A hidden file under a temporary name next to its final path. Its process keeps it locked, which shows others that it
/// is in use.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : target_(target), path_(folder() / (prefix() + random_digits() + suffix)), file_(open()) {}
  ~TemporaryFile() {
    std::error_code code;
    fs::remove(path_, code);  // missing if it was renamed to the final file
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void become_target(std::string_view contents) {
    write_all(file_, contents, target_);
    flush(path_, target_);
    rename_file(path_, target_);
  }

 private:
  static constexpr const char* suffix = ".tmp";
  [[nodiscard]] std::string prefix() const { return fmt::format(".{}.", target_.filename().string()); }
  [[nodiscard]] fs::path folder() const { return target_.has_parent_path() ? target_.parent_path() : "."; }

  [[nodiscard]] FileDescriptor open() const {
    remove_those_left();
    while (true) {
      FileDescriptor file(path_, target_, O_WRONLY | O_CREAT | O_EXCL);
      try_to_lock(file);
      // Before it was locked, a cleanup may have taken it for abandoned.
      if (file.is_at(path_)) return file;
    }
  }

  void remove_those_left() const {
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder(), code)) {
      const std::string name = entry.path().filename().string();
      if (name.size() != path_.filename().string().size() || !name.starts_with(prefix()) || !name.ends_with(suffix)) {
        continue;
      }
      const FileDescriptor left(::open(entry.path().c_str(), O_RDWR | O_CLOEXEC));
      if (left.get() >= 0 && try_to_lock(left) == Lock::taken) fs::remove(entry.path(), code);
    }
  }

  fs::path target_;
  fs::path path_;
  FileDescriptor file_;
};

}  // namespace

void write_file(const fs::path& path, std::string_view contents, Existing existing) {
  std::error_code code;
  const fs::file_status status = fs::symlink_status(path, code);
  if (existing == Existing::refuse && fs::exists(status)) {
    throw Error(ErrorKind::file,
                {{path.string(), 0, "", "", "exists already", "give another name, or --force to replace it"}});
  }
  if (fs::exists(path, code) && !fs::is_regular_file(path, code)) {
    throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is not a regular file", "give the name of a file"}});
  }
  TemporaryFile(path).become_target(contents);
}

}  // namespace bumpfoil
