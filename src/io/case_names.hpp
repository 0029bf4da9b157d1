#pragma once

#include <array>
#include <numbers>
#include <string_view>
#include <utility>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Words of the case file for the choices of a Case.
template <typename Enum, std::size_t N>
using Names = std::array<std::pair<std::string_view, Enum>, N>;

inline constexpr Names<Wrap, 2> wrap_names{
    {{"clockwise", Wrap::clockwise}, {"counterclockwise", Wrap::counterclockwise}}};
inline constexpr Names<BumpFoilModel, 3> model_names{
    {{"truss", BumpFoilModel::truss}, {"frame", BumpFoilModel::frame}, {"former", BumpFoilModel::former}}};
inline constexpr Names<Geometry, 2> geometry_names{{{"linear", Geometry::linear}, {"nonlinear", Geometry::nonlinear}}};
inline constexpr Names<HeightReference, 2> height_reference_names{
    {{"overall", HeightReference::overall}, {"midsurface", HeightReference::midsurface}}};
inline constexpr Names<WeldPosition, 2> weld_position_names{
    {{"mid_flat", WeldPosition::mid_flat}, {"arc_start", WeldPosition::arc_start}}};
inline constexpr Names<StripWeld, 2> strip_weld_names{{{"one_end", StripWeld::one_end}, {"none", StripWeld::none}}};
inline constexpr Names<SolverName, 3> solver_names{
    {{"newton", SolverName::newton}, {"uzawa", SolverName::uzawa}, {"events", SolverName::events}}};

template <typename Enum, std::size_t N>
constexpr std::string_view name_in(const Names<Enum, N>& names, Enum value) {
  for (const auto& [name, meaning] : names) {
    if (meaning == value) return name;
  }
  return "";
}

}  // namespace bumpfoil
