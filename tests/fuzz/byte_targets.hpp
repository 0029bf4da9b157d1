#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace bumpfoil {

/// Readers of untrusted bytes, by name. Each may reject them with an Error whose message is safe to print; any other
/// failure ends the program.
const std::map<std::string, std::function<void(std::string_view bytes)>>& byte_targets();

}  // namespace bumpfoil
