#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace bumpfoil {

/// @param shown  the file in terms of the user, not always the one that failed
/// @param code   errno
/// @throws Error (file) always
[[noreturn]] void throw_unwritable(const std::filesystem::path& shown, int code);

/// An open file or folder, closed by the destructor.
class FileDescriptor {
 public:
  /// @throws Error (file) if it cannot be opened
  FileDescriptor(const std::filesystem::path& path, const std::filesystem::path& shown, int flags);
  /// Takes ownership of an open descriptor.
  explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  FileDescriptor(FileDescriptor&& other) noexcept;

  [[nodiscard]] int get() const { return descriptor_; }

  /// Whether this path still refers to it: it may have been removed or replaced since.
  [[nodiscard]] bool is_at(const std::filesystem::path& path) const;

 private:
  int descriptor_;
};

/// Result of locking a file. A lock ends with its process, in any case.
enum class Lock {
  taken,
  held_by_another,
  unsupported,  ///< on some network file systems
};

/// Locks a whole file without waiting.
Lock try_to_lock(const FileDescriptor& file);

/// Writes all bytes. @throws Error (file)
void write_all(const FileDescriptor& file, std::string_view contents, const std::filesystem::path& shown);

/// Flushes a file to disk, or the entries of a folder. @throws Error (file)
void flush(const std::filesystem::path& path, const std::filesystem::path& shown);

/// Renames within a file system; replaces an existing file. @throws Error (file)
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Eight random hexadecimal digits, for unique names.
std::string random_digits();

}  // namespace bumpfoil
