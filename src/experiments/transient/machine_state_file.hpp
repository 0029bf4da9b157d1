#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bumpfoil/motion/machine.hpp"

namespace bumpfoil {

/// A bit-exact binary image of a state, in the number format of this machine.
std::string bytes_of(const MachineState& state);

/// Restores the state; nothing if the length is wrong.
std::optional<MachineState> machine_state_of(std::string_view bytes);

}  // namespace bumpfoil
