#pragma once

#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "bumpfoil/core/enum_names.hpp"

/// What is told of every quantity of a result: a `name`, that of the variable in result.nc; a `unit` as UDUNITS spells
/// it, "1" where there is none, empty for words; a `long_name`; and a Form.
namespace bumpfoil {

/// Stands among numbers for one that is not known or does not exist. Files show it in their own way, never as a number.
inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// As what values are written.
struct Form {
  enum Kind {
    real,
    whole,
    truth,  ///< no or yes, as 0 or 1
    flag,   ///< one of some words, as 0, 1, 2, ...
  } kind{real};
  std::span<const std::string_view> words{};  ///< of truths and flags
};

template <typename Enum>
inline constexpr Form flags{Form::flag, enum_names<Enum>};

/// What readers are told about a variable.
struct VariableMeaning {
  std::string name;
  std::string unit;
  std::string long_name;
  Form form{};
};

/// A column of CSV or key of JSON carries its unit at its end: "force_x_N", "secant_stiffness_N_per_m", "loss_factor".
/// What tells variables of increments and cycles apart falls away: "iterations" for `total_iterations`, "status" for
/// `increment_status`.
std::string key_of(std::string_view name, std::string_view unit);

/// How the terminal shows a number.
struct ShownUnit {
  std::string_view name;
  double size{};  ///< SI
};

/// Units of tables for people.
namespace shown {

inline constexpr ShownUnit unitless{"", 1.0};
inline constexpr ShownUnit newtons{"N", 1.0};
inline constexpr ShownUnit micrometres{"um", 1e-6};
inline constexpr ShownUnit degrees{"deg", 1.0};
inline constexpr ShownUnit newton_millimetres{"N mm", 1e-3};
inline constexpr ShownUnit millijoules{"mJ", 1e-3};
inline constexpr ShownUnit watts{"W", 1.0};
inline constexpr ShownUnit megapascals{"MPa", 1e6};
inline constexpr ShownUnit bars{"bar", 1e5};
inline constexpr ShownUnit revolutions{"rpm", std::numbers::pi / 30.0};
inline constexpr ShownUnit stiffness{"MN/m", 1e6};
inline constexpr ShownUnit damping{"N s/m", 1.0};

}  // namespace shown

}  // namespace bumpfoil
