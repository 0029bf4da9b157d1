#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Names for folders: the shortest unique ends of their paths, numbered if even these are equal ("a/run", "b/run"; "run
/// (1)", "run (2)"). They do not reveal higher folders of the machine.
std::vector<std::string> names_of(const std::vector<std::filesystem::path>& folders);

/// A command line with every absolute path reduced to its last part: "/home/jo/case.toml" becomes "case.toml".
std::string without_machine_paths(std::string_view command_line);

}  // namespace bumpfoil
