#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Files whose presence makes a folder one that holds results.
inline constexpr std::array<std::string_view, 16> result_names{
    "summary.json",     "cycle.csv",         "strip.csv",       "path.csv",   "sweep.csv", "vibration.csv",
    "coefficients.csv", "coefficients.toml", "equilibrium.csv", "film.csv",   "result.nc", "sweep.nc",
    "ensemble.nc",      "study.json",        "picture.svg",     "report.html"};

/// Called before every step of a publication that changes the disk; tests stop there.
using BeforeStep = std::function<void()>;

/// Makes the files of a staging folder, all complete, the results in `folder`. The set counts as published from the
/// moment on at which the staging folder gets its final name: from then on published_file() finds the new files, before
/// it the old ones. Then complete_publication() is called.
/// @param staging  inside the work folder of `folder`
/// @throws Error (file); where the set does not count as published, nothing has changed
void publish_staged(const std::filesystem::path& staging, const std::filesystem::path& folder,
                    const std::vector<std::string>& names, const BeforeStep& before);

/// Moves the files of a set that counts as published to their places, where that was not yet done, and removes results
/// of earlier runs. May be cut short and repeated.
/// @throws Error (file)
void complete_publication(const std::filesystem::path& folder, const BeforeStep& before);

}  // namespace bumpfoil
