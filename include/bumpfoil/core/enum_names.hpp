#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace bumpfoil {

/// The words for the values of an enumeration in case files, results and messages, in the order of the values, which
/// count from zero. Specialised once for each enumeration that has words:
///
///     template <>
///     inline constexpr auto enum_names<Wrap> = std::to_array<std::string_view>({"clockwise", "counterclockwise"});
template <typename Enum>
inline constexpr auto enum_names = nullptr;

/// The word for a value.
template <typename Enum>
constexpr std::string_view name_of(Enum value) requires(!std::is_null_pointer_v<decltype(enum_names<Enum>)>) {
  return enum_names<Enum>.at(static_cast<std::size_t>(value));
}

}  // namespace bumpfoil
