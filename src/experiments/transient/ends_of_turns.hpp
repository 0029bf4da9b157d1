#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace bumpfoil {

/// Rows at which whole turns of a run end, including the start; reads a limited number at a time.
/// @param angles  of `count` rows from `first` on, rad
std::vector<std::size_t> ends_of_turns(
    std::size_t rows, const std::function<std::vector<double>(std::size_t first, std::size_t count)>& angles);

}  // namespace bumpfoil
