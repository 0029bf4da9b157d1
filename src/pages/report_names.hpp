#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Names for some folders: the last parts of their paths, as many as it takes to tell them apart, with a number where
/// nothing does ("a/run", "b/run"; "run (1)", "run (2)"). What lies above on the machine is in none of them.
std::vector<std::string> names_of(const std::vector<std::filesystem::path>& folders);

/// A command line with the last part alone of every absolute path in it: of "/home/jo/case.toml" there stays
/// "case.toml".
std::string without_machine_paths(std::string_view command_line);

}  // namespace bumpfoil
