#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bumpfoil {

/// Called before every step of a publication that changes the disk; tests interrupt there.
using BeforeStep = std::function<void()>;

/// Publishes the complete files of a staging folder as the results in `folder`. The set counts as published once the
/// staging folder has its final name: from then on published_file() finds the new files, before that the old ones. Then
/// complete_publication() is called.
/// @param staging  inside the work folder of `folder`
/// @param names    of the files in it
/// @param stale    names of files to remove from `folder`: results of earlier runs
/// @throws Error (file); unless the set was published, nothing has changed
void publish_staged(const std::filesystem::path& staging, const std::filesystem::path& folder,
                    const std::vector<std::string>& names, const std::vector<std::string>& stale,
                    const BeforeStep& before);

/// Moves the files of a published set to their final places, as far as not yet done, and removes those that it makes
/// stale. May be interrupted and repeated.
/// @throws Error (file)
void complete_publication(const std::filesystem::path& folder, const BeforeStep& before);

}  // namespace bumpfoil
