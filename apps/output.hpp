#pragma once

#include <string_view>

namespace bumpfoil {

/// Prints on standard output. @throws Error (file) if it cannot take it, a full disk for one.
void print_output(std::string_view text);

}  // namespace bumpfoil
