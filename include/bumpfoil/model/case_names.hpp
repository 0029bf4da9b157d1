#pragma once

#include <array>
#include <string_view>

#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/control.hpp"

/// Words of the case file for the choices of a Case: name_of(Wrap::clockwise) is "clockwise".
namespace bumpfoil {

template <>
inline constexpr auto enum_names<Wrap> = std::to_array<std::string_view>({"clockwise", "counterclockwise"});
template <>
inline constexpr auto enum_names<FormedTo> = std::to_array<std::string_view>({"bearing", "seated", "radius"});
template <>
inline constexpr auto enum_names<WeldEdge> = std::to_array<std::string_view>({"leading", "trailing"});
template <>
inline constexpr auto enum_names<BumpFoilModel> = std::to_array<std::string_view>({"truss", "frame", "former"});
template <>
inline constexpr auto enum_names<Geometry> = std::to_array<std::string_view>({"linear", "nonlinear"});
template <>
inline constexpr auto enum_names<HeightReference> = std::to_array<std::string_view>({"overall", "midsurface"});
template <>
inline constexpr auto enum_names<Grading> = std::to_array<std::string_view>({"linear", "geometric"});
template <>
inline constexpr auto enum_names<WeldPosition> = std::to_array<std::string_view>({"mid_flat", "arc_start"});
template <>
inline constexpr auto enum_names<SolverName> = std::to_array<std::string_view>({"newton", "uzawa", "events"});

template <>
inline constexpr auto enum_names<Sense> = std::to_array<std::string_view>({"counterclockwise", "clockwise"});
template <>
inline constexpr auto enum_names<StripWeld> = std::to_array<std::string_view>({"one_end", "none"});
template <>
inline constexpr auto enum_names<GasPreset> = std::to_array<std::string_view>({"air", "helium", "nitrogen", "steam"});
template <>
inline constexpr auto enum_names<FilmWall> = std::to_array<std::string_view>({"rigid", "springs", "rigid_across"});

}  // namespace bumpfoil
