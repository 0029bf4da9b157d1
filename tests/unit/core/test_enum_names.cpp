#include "bumpfoil/core/enum_names.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace bumpfoil {

enum class Fruit { apple, pear };
enum class Nameless { one };

template <>
inline constexpr auto enum_names<Fruit> = std::to_array<std::string_view>({"apple", "pear"});

namespace {

template <typename Enum>
concept Named = requires(Enum value) {
  name_of(value);
};

TEST(EnumNames, AreInTheOrderOfTheValues) {
  EXPECT_EQ(name_of(Fruit::apple), "apple");
  EXPECT_EQ(name_of(Fruit::pear), "pear");
  EXPECT_THROW((void)name_of(static_cast<Fruit>(2)), std::out_of_range);
}

TEST(EnumNames, AreThereForWhatWasGivenSome) {
  static_assert(Named<Fruit>);
  static_assert(!Named<Nameless>);
}

}  // namespace
}  // namespace bumpfoil
