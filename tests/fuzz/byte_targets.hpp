#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace bumpfoil {

/// What reads bytes of others, by name. Each may refuse them with an Error whose message is safe to print, and does
/// nothing else that is wrong: whatever does ends the program.
const std::map<std::string, std::function<void(std::string_view bytes)>>& byte_targets();

}  // namespace bumpfoil
