#include "bumpfoil/model/settings_by_type.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

struct First {
  static constexpr std::string_view table = "first";

  int number{};
  bool operator==(const First&) const = default;
};

struct Second {
  static constexpr std::string_view table = "second";

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

TEST(SettingsByType, MissesATableThatItHasNot) {
  SettingsByType settings;
  try {
    static_cast<void>(settings.get<First>());
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.errors().front().key, "first");
  }
  settings.get_or_create<First>().number = 4;
  EXPECT_EQ(settings.get<First>().number, 4);
  EXPECT_EQ(settings.get_or_create<First>().number, 4);
  settings.remove<First>();
  EXPECT_EQ(settings.find<First>(), nullptr);
}

TEST(SettingsByType, KeepsThoseOfOneTypeAlone) {
  SettingsByType settings;
  settings.set(First{3});
  settings.set(Second{0.5});
  settings.keep_only<Second>();
  EXPECT_EQ(settings.find<First>(), nullptr);
  EXPECT_EQ(settings.get<Second>().number, 0.5);
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
