#pragma once

#include <filesystem>
#include <string>

#include "results/posix_file.hpp"

namespace bumpfoil {

/// Hidden subfolder of a results folder that exists while results are written.
std::filesystem::path work_folder(const std::filesystem::path& folder);

/// The exclusive right to write to a folder: a locked file in its work folder, released with its owner or the process.
/// On file systems without locks, the last claim wins, and is_held() is false for the others.
class FolderClaim {
 public:
  /// @throws Error (file) if another process holds it, or the folder is not writable
  explicit FolderClaim(const std::filesystem::path& folder);
  /// Removes the work folder if it is empty.
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

  [[nodiscard]] bool is_held() const;

 private:
  [[nodiscard]] FileDescriptor open_locked() const;

  std::filesystem::path folder_;
  std::filesystem::path path_;
  std::string owner_;  ///< contents of the file: identifies this owner
  FileDescriptor file_;
};

}  // namespace bumpfoil
