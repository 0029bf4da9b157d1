#pragma once

#include <filesystem>
#include <string>

namespace bumpfoil::test_support {

/// A new folder, removed with its contents at destruction.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file; returns its path.
  std::string write(const std::string& name, const std::string& contents) const;

  /// Contents of a file.
  [[nodiscard]] std::string read(const std::string& name) const;

  /// Names of all entries, sorted.
  [[nodiscard]] std::string listing() const;

 private:
  std::filesystem::path path_;
};

}  // namespace bumpfoil::test_support
