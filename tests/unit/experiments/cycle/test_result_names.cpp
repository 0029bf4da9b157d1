#include "bumpfoil/experiments/cycle/result_names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace bumpfoil {
namespace {

TEST(ResultNames, AreThoseOfTheEnumerators) {
  EXPECT_EQ(name_of(ContactMode::open), "open");
  EXPECT_EQ(name_of(ContactMode::stick), "stick");
  EXPECT_EQ(name_of(ContactMode::slip_forward), "slip_forward");
  EXPECT_EQ(name_of(ContactMode::slip_backward), "slip_backward");
  EXPECT_EQ(name_of(Branch::loading), "loading");
  EXPECT_EQ(name_of(Branch::unloading), "unloading");
  EXPECT_EQ(name_of(Interface::journal_top), "journal_top");
  EXPECT_EQ(name_of(Interface::top_bump), "top_bump");
  EXPECT_EQ(name_of(Interface::bump_sleeve), "bump_sleeve");
  EXPECT_EQ(name_of(StressPlace::weld), "weld");
  EXPECT_EQ(name_of(StressPlace::crest), "crest");
  EXPECT_EQ(name_of(StressPlace::foot), "foot");
  EXPECT_EQ(name_of(StressPlace::arc), "arc");
  EXPECT_EQ(name_of(Experiment::cycle), "cycle");
  EXPECT_EQ(name_of(Experiment::strip), "strip");
}

/// The page has its own list of contact states, in plain words.
TEST(ResultNames, OfContactsAreInTheOrderThatThePageHas) {
  std::string list;
  for (const std::string_view name : enum_names<ContactMode>) {
    list += std::string(list.empty() ? "" : ", ") + '\'' + std::string(name) + '\'';
  }
  std::replace(list.begin(), list.end(), '_', ' ');
  std::ifstream file("../web/src/data/run.ts");
  const std::string source{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(source.find("export const contactStates = [" + list + "]"), std::string::npos) << list;
}

}  // namespace
}  // namespace bumpfoil
