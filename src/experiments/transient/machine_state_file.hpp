#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bumpfoil/motion/machine.hpp"

namespace bumpfoil {

/// A state as bytes, to the last bit: numbers as they lie in memory, for the machine that wrote them.
std::string bytes_of(const MachineState& state);

/// The state again; nothing where the bytes end too early or too late.
std::optional<MachineState> machine_state_of(std::string_view bytes);

}  // namespace bumpfoil
