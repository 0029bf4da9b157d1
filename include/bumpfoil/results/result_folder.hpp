#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/results/write_file.hpp"

namespace bumpfoil {

/// Files that identify a results folder, of all commands; excludes case.toml, which many folders contain as an input.
/// Defined in experiments/, which describes the commands.
const std::vector<std::string>& result_names();

/// The folder that a run writes to, claimed from the start to the end: nobody else can write results to it. Files are
/// staged out of sight and published as one set. Whenever a process is killed, published_file() gives either all old
/// files or all new ones, files are never seen half written, and the next process that opens the folder completes an
/// interrupted publication and removes unpublished files.
///
/// Inside the folder, as long as it takes: `.bumpfoil/claim`, a locked file; `.bumpfoil/staged-*`, files that are not
/// published; `.bumpfoil/set`, a set that counts as published, with files that are not yet in their places.
class ResultFolder {
 public:
  /// Makes the folder where it does not exist, claims it, and finds out at once whether it can be written to.
  /// @param names  of the files that may be staged
  /// @throws Error (file) if it cannot be, if another process has claimed it, or if it holds results or any of the
  /// files that must not be replaced, or a folder in the place of one.
  ResultFolder(std::filesystem::path path, Existing existing, std::vector<std::string> names);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Temporary path for a result called `name`, for others to write the file.
  std::filesystem::path stage(const std::string& name);

  /// Stages a file with these contents; returns its temporary path. @throws Error (file)
  std::filesystem::path stage(const std::string& name, std::string_view contents);

  /// Forgets a staged file, and removes what was written of it.
  void discard(const std::string& name);

  /// Makes everything staged the results in the folder, flushed to the disk; results of an earlier run are removed, and
  /// files of the given names that were not staged.
  /// @param before  called ahead of every step, for tests that stop there
  /// @throws Error (file); the claim is checked again, and what must not be replaced
  void publish(const std::function<void()>& before = [] {});

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  struct Claimed;

  void check_places() const;

  std::filesystem::path path_;
  Existing existing_;
  std::vector<std::string> names_;
  std::unique_ptr<Claimed> claimed_;
  std::vector<std::string> staged_;
};

/// Completes a publication into a folder that was cut short, if there is one and this process may; otherwise there is
/// published_file().
void complete_publication_quietly(const std::filesystem::path& folder);

/// The file `name` of the results in a folder: in its place or, where a publication is under way or was cut short, on
/// its way there.
std::filesystem::path published_file(const std::filesystem::path& folder, const std::string& name);

}  // namespace bumpfoil
