#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// What happens to results that are there already.
enum class Existing { refuse, replace };

/// The folder that a run writes to. Files are staged under temporary names in it and all published together, so that
/// no file is ever seen half written. What was not published is removed again.
class ResultFolder {
 public:
  /// Makes the folder where it does not exist, and finds out at once whether it can be written to.
  /// @throws Error (file) if it cannot, or if it holds results that must not be replaced.
  ResultFolder(std::filesystem::path path, Existing existing);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Temporary path for a result called `name`; the caller writes the file.
  std::filesystem::path stage(const std::string& name);

  /// Stages a file with these contents; returns its temporary path. @throws Error (file)
  std::filesystem::path stage(const std::string& name, std::string_view contents);

  /// Forgets a staged file, and removes what was written of it.
  void discard(const std::string& name);

  /// Puts everything staged in place, flushed to the disk; results of an earlier run are removed. @throws Error (file)
  void publish();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool made_{};  ///< the folder did not exist
  std::vector<std::string> staged_;
};

/// Writes one file whole or not at all: under a temporary name first, flushed, then renamed.
/// @throws Error (file) if it cannot be written, or exists and must not be replaced.
void write_file(const std::filesystem::path& path, std::string_view contents, Existing existing);

}  // namespace bumpfoil
