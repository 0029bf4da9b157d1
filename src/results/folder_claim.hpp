#pragma once

#include <filesystem>
#include <string>

#include "results/posix_file.hpp"

namespace bumpfoil {

/// Hidden inside a folder of results, as long as something is being written to it.
std::filesystem::path work_folder(const std::filesystem::path& folder);

/// The right to write to a folder: a locked file in its work folder. It lasts as long as its owner, and no longer than
/// the process. Where the file system has no locks, the last one who claims a folder has it, and is_held() tells the
/// others.
class FolderClaim {
 public:
  /// @throws Error (file) if somebody else has it, or nothing can be written
  explicit FolderClaim(const std::filesystem::path& folder);
  /// Removes the work folder, unless it still holds something.
  ~FolderClaim();
  FolderClaim(const FolderClaim&) = delete;
  FolderClaim& operator=(const FolderClaim&) = delete;

  [[nodiscard]] bool is_held() const;

 private:
  [[nodiscard]] FileDescriptor open_locked() const;

  std::filesystem::path folder_;
  std::filesystem::path path_;
  std::string owner_;  ///< contents of the file: who this is
  FileDescriptor file_;
};

}  // namespace bumpfoil
