#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bumpfoil {

/// @param shown  the file as its user knows it, which is not always the one that failed
/// @param code   of errno
/// @throws Error (file) always
[[noreturn]] void throw_unwritable(const std::filesystem::path& shown, int code);

/// An open file or folder, closed in the end.
class FileDescriptor {
 public:
  /// @throws Error (file) if it cannot be opened
  FileDescriptor(const std::filesystem::path& path, const std::filesystem::path& shown, int flags);
  /// Takes over one that is open.
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor(FileDescriptor&& other) noexcept;

  [[nodiscard]] int get() const { return descriptor_; }

  /// Whether it is still what has this name: it may have been removed or replaced since it was opened.
  [[nodiscard]] bool is_at(const std::filesystem::path& path) const;

 private:
  int descriptor_;
};

/// Result of locking a file. A lock ends with its process, however that ends.
enum class Lock {
  taken,
  held_by_another,
  unsupported,  ///< some network file systems know none
};

/// Locks a whole file, if nobody else has; does not wait.
Lock try_to_lock(const FileDescriptor& file);

/// Writes all of it. @throws Error (file)
void write_all(const FileDescriptor& file, std::string_view contents, const std::filesystem::path& shown);

/// Flushes a file to the disk, or a folder: what names it holds. @throws Error (file)
void flush(const std::filesystem::path& path, const std::filesystem::path& shown);

/// Renames within a file system; replaces a file that has the name. @throws Error (file)
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Eight hexadecimal digits at random, for names that nobody else takes.
std::string random_digits();

}  // namespace bumpfoil
