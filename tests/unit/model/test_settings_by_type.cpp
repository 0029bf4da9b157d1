#include "bumpfoil/model/settings_by_type.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

struct First {
  int number{};
  bool operator==(const First&) const = default;
};

struct Second {
  double number{};
  bool operator==(const Second&) const = default;
};

TEST(SettingsByType, HoldsOneOfEachType) {
  SettingsByType settings;
  EXPECT_EQ(settings.find<First>(), nullptr);
  settings.set(First{3}).number = 4;
  settings.set(Second{0.5});
  ASSERT_NE(settings.find<First>(), nullptr);
  EXPECT_EQ(settings.find<First>()->number, 4);
  EXPECT_EQ(settings.find<Second>()->number, 0.5);
  settings.set(First{5});
  EXPECT_EQ(settings.find<First>()->number, 5);
}

TEST(SettingsByType, IsCopiedAndComparedByValue) {
  SettingsByType one;
  one.set(First{3});
  SettingsByType other = one;
  EXPECT_EQ(one, other);
  other.set(First{4});
  EXPECT_EQ(one.find<First>()->number, 3);
  EXPECT_NE(one, other);
  other.set(First{3});
  EXPECT_EQ(one, other);
  other.set(Second{});
  EXPECT_NE(one, other);  // absent differs from default
}

}  // namespace
}  // namespace bumpfoil
