#pragma once

#include <array>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "bumpfoil/core/status.hpp"

/// Description of every quantity of a result: a `name`, that of the variable in result.nc; a `unit` as UDUNITS spells
/// it, "1" where there is none, empty for words; a `long_name`; and a Form.
namespace bumpfoil {

/// Represents a number that is unknown or does not exist. Files show it in their own way, never as a number.
inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// What an absent value stands for in statistics.
enum class Undefined {
  unknown,  ///< nothing: it is left out
  largest,  ///< too large to be known, such as a clearance that was never taken up: the largest in percentiles
};

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

/// Of foils under no film.
template <>
inline constexpr Form flags<Status>{Form::flag, std::span(enum_names<Status>).first(foil_statuses)};

inline constexpr Form whole_number{Form::whole};
inline constexpr std::array<std::string_view, 2> truth_words{"no", "yes"};
inline constexpr Form yes_or_no{Form::truth, truth_words};

/// How the terminal shows a number.
struct ShownUnit {
  std::string_view name;
  double size{};  ///< SI
};

/// Units of tables for people.
namespace shown {

inline constexpr ShownUnit in_files{};  ///< not on the terminal
inline constexpr ShownUnit unitless{"", 1.0};
inline constexpr ShownUnit newtons{"N", 1.0};
inline constexpr ShownUnit micrometres{"um", 1e-6};
inline constexpr ShownUnit degrees{"deg", 1.0};
inline constexpr ShownUnit kilograms{"kg", 1.0};
inline constexpr ShownUnit newton_millimetres{"N mm", 1e-3};
inline constexpr ShownUnit millijoules{"mJ", 1e-3};
inline constexpr ShownUnit watts{"W", 1.0};
inline constexpr ShownUnit megapascals{"MPa", 1e6};
inline constexpr ShownUnit bars{"bar", 1e5};
inline constexpr ShownUnit revolutions{"rpm", std::numbers::pi / 30.0};
inline constexpr ShownUnit stiffness{"MN/m", 1e6};
inline constexpr ShownUnit tilting_stiffness{"N mm/mrad", 1.0};
inline constexpr ShownUnit milliradians{"mrad", 1e-3};
inline constexpr ShownUnit damping{"N s/m", 1.0};

}  // namespace shown

/// Where a quantity is shown, and which results have it: a sum of these, and of those that an experiment adds.
using Tags = unsigned;

namespace tag {

inline constexpr Tags none = 0;
inline constexpr Tags csv = 1;           ///< a column of the CSV file, too
inline constexpr Tags headline = 2;      ///< one of the few in tables of sweeps on the terminal; shown first on pages
inline constexpr Tags shown_first = 4;   ///< on pages
inline constexpr Tags sampled = 8;       ///< kept of the samples of ensembles: needs no fields, same on all machines
inline constexpr Tags of_solver = 16;    ///< how it was computed
inline constexpr Tags measured = 32;     ///< follows from displacement and force alone
inline constexpr Tags leading = 64;      ///< charts begin with it
inline constexpr Tags no_limits = 128;   ///< no limits on it in ensembles: absent in good samples and in bad ones
inline constexpr Tags key_figure = 256;  ///< with the leading one, of the three that pages show large
/// Tags of an experiment begin here.
inline constexpr Tags first_of_experiment = 512;

}  // namespace tag

/// A column of CSV or key of JSON carries its unit at its end: "force_x_N", "secant_stiffness_N_per_m", "loss_factor".
/// What distinguishes variables of one netCDF file is dropped, as each table has one of them: "iterations" for
/// `total_iterations`, "status" for `increment_status` and `speed_status`.
std::string key_of(std::string_view name, std::string_view unit);

/// What a variable means.
struct VariableMeaning {
  std::string name;
  std::string unit;
  std::string long_name;
  Form form{};
  std::string label{};  ///< in tables for people; empty where it is in files only
  ShownUnit shown{};    ///< on the terminal; a size of 0 where it is not
  Tags tags{};

  [[nodiscard]] std::string key() const { return key_of(name, unit); }
};

/// A quantity of a result, described once: what it means, and how it is read off. All files, tables and pages take it
/// from here.
/// @tparam Value  function of what it is a quantity of; not a number where it is not known
template <typename Value>
struct Quantity {
  std::string_view name, unit, long_name;
  Value value;
  Tags tags{};
  std::string_view label{};
  ShownUnit shown{};
  Form form{};

  /// Whether it has any of these tags.
  [[nodiscard]] constexpr bool is(Tags some) const { return (tags & some) != 0; }
  [[nodiscard]] std::string key() const { return key_of(name, unit); }
  [[nodiscard]] VariableMeaning meaning() const {
    return {std::string(name), std::string(unit), std::string(long_name), form, std::string(label), shown, tags};
  }
};

}  // namespace bumpfoil
