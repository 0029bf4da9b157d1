#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Keys of the case file, by their paths.
std::vector<std::string> key_paths();

/// The first key of a table.
std::string first_key_of(const std::string& table);

/// Of these paths, those that end with the words of a name ("coefficient", "clearance", "foil.pitch"): the outermost,
/// or those with the fewest words.
std::vector<std::string> keys_with_words(std::string_view name, const std::vector<std::string>& paths);

/// Of these paths, those that end with a likely correction of a name; the outermost.
std::vector<std::string> keys_near(const std::string& name, const std::vector<std::string>& paths);

/// "did you mean "a", "b" or "c"?"
std::string did_you_mean(const std::vector<std::string>& keys);

}  // namespace bumpfoil
