#pragma once

#include <array>
#include <string_view>

#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"

/// Words of results for what they flag: name_of(ContactMode::stick) is "stick".
namespace bumpfoil {

template <>
inline constexpr auto enum_names<ContactMode> = std::to_array<std::string_view>({"open", "stick", "slip_forward",
                                                                                 "slip_backward"});
template <>
inline constexpr auto enum_names<Branch> = std::to_array<std::string_view>({"loading", "unloading"});
template <>
inline constexpr auto enum_names<Interface> = std::to_array<std::string_view>({"journal_top", "top_bump",
                                                                               "bump_sleeve"});
template <>
inline constexpr auto enum_names<StressPlace> = std::to_array<std::string_view>({"weld", "crest", "foot", "arc"});
/// The commands that experiments are run by.
template <>
inline constexpr auto enum_names<Experiment> = std::to_array<std::string_view>({"cycle", "strip", "path"});

}  // namespace bumpfoil
