#include "bumpfoil/core/status.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace bumpfoil {
namespace {

TEST(Status, EveryOneHasANameAndWordsOfItsOwn) {
  constexpr std::size_t count = enum_names<Status>.size();
  std::set<std::string_view> names, words;
  for (int i = 0; std::cmp_less(i, count); ++i) {
    names.insert(name_of(static_cast<Status>(i)));
    words.insert(explanation(static_cast<Status>(i)));
  }
  EXPECT_EQ(names.size(), count);
  EXPECT_EQ(words.size(), count);
  EXPECT_EQ(names.count(""), 0U);
}

TEST(Status, NamesAreThoseOfTheEnumerators) {
  EXPECT_EQ(name_of(Status::converged), "converged");
  EXPECT_EQ(name_of(Status::no_modes), "no_modes");
  EXPECT_EQ(name_of(Status::no_tangent), "no_tangent");
  EXPECT_EQ(name_of(Status::iterations_spent), "iterations_spent");
  EXPECT_EQ(name_of(Status::energy_defect), "energy_defect");
  EXPECT_EQ(name_of(Status::residual_above_bound), "residual_above_bound");
  EXPECT_EQ(name_of(Status::load_out_of_reach), "load_out_of_reach");
  EXPECT_EQ(name_of(Status::load_not_met), "load_not_met");
  EXPECT_EQ(name_of(Status::interrupted), "interrupted");
  EXPECT_EQ(name_of(Status::unstable), "unstable");
  EXPECT_EQ(name_of(Status::not_unique), "not_unique");
  EXPECT_EQ(name_of(Status::not_converged), "not_converged");
  EXPECT_EQ(name_of(Status::touchdown), "touchdown");
  EXPECT_EQ(name_of(Status::no_room), "no_room");
  EXPECT_EQ(name_of(Status::fold), "fold");
  EXPECT_EQ(name_of(Status::not_reached), "not_reached");
}

/// These numbers must stay, as they are stored in files of earlier versions.
TEST(Status, KeepTheirNumbersInFiles) {
  EXPECT_EQ(foil_statuses, 11U);
  std::vector<std::string_view> running;
  for (const Status status : running_statuses) running.push_back(name_of(status));
  EXPECT_EQ(running, (std::vector<std::string_view>{"converged", "not_converged", "touchdown", "no_room", "fold",
                                                    "not_reached", "interrupted"}));
}

}  // namespace
}  // namespace bumpfoil
