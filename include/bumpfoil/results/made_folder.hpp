#pragma once

#include <filesystem>
#include <vector>

namespace bumpfoil {

/// A folder for results, and those that hold it. What was made here is removed in the end where it stayed empty.
class MadeFolder {
 public:
  /// @throws Error (file) if it cannot be made
  explicit MadeFolder(const std::filesystem::path& path);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< the innermost first
};

}  // namespace bumpfoil
