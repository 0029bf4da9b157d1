#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Files whose presence makes a folder one that holds results: of all commands, but for case.toml, which many folders
/// have for the case itself.
inline constexpr auto result_names = std::to_array<std::string_view>(
    {"summary.json", "cycle.csv",        "strip.csv",         "path.csv",      "vibration.csv", "equilibrium.csv",
     "film.csv",     "coefficients.csv", "coefficients.toml", "stability.csv", "unbalance.csv", "transient.csv",
     "fit.csv",      "fit.nc",           "points.csv",        "sweep.csv",     "sweep.nc",      "ensemble.nc",
     "result.nc",    "study.json",       "picture.svg",       "report.html"});

/// Called before every step of a publication that changes the disk; tests stop there.
using BeforeStep = std::function<void()>;

/// Makes the files of a staging folder, all complete, the results in `folder`. The set counts as published from the
/// moment on at which the staging folder gets its final name: from then on published_file() finds the new files, before
/// it the old ones. Then complete_publication() is called.
/// @param staging  inside the work folder of `folder`
/// @param names    of the files in it
/// @param stale    names of files in `folder` that are removed: results of earlier runs
/// @throws Error (file); where the set does not count as published, nothing has changed
void publish_staged(const std::filesystem::path& staging, const std::filesystem::path& folder,
                    const std::vector<std::string>& names, const std::vector<std::string>& stale,
                    const BeforeStep& before);

/// Moves the files of a set that counts as published to their places, where that was not yet done, and removes those
/// that it makes stale. May be cut short and repeated.
/// @throws Error (file)
void complete_publication(const std::filesystem::path& folder, const BeforeStep& before);

}  // namespace bumpfoil
