#include "bumpfoil/results/row_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class RowLogs : public ::testing::Test {
 protected:
  void write_two_blocks() {
    RowLog log(path_, "identity", 2);
    log.append(std::vector{1.0, 10.0, 2.0, 20.0, 3.0, 30.0});
    log.append(std::vector<double>{4.0, NAN});
  }

  test_support::TemporaryFolder folder_;
  std::filesystem::path path_{folder_.path() / "log"};
};

TEST_F(RowLogs, AreReadByColumnsAcrossBlocks) {
  write_two_blocks();
  EXPECT_EQ(RowLog::identity_of(path_), "identity");
  RowLog log = RowLog::open(path_, 2);
  ASSERT_EQ(log.rows(), 4U);
  EXPECT_EQ(log.column(0), (std::vector{1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(log.column(0, 1, 3), (std::vector{2.0, 3.0, 4.0}));
  EXPECT_EQ(log.column(1, 1, 1), (std::vector{20.0}));
  EXPECT_TRUE(std::isnan(log.column(1)[3]));
  EXPECT_TRUE(log.column(1, 2, 0).empty());
  log.append(std::vector{5.0, 50.0});
  EXPECT_EQ(log.column(0, 2, 3), (std::vector{3.0, 4.0, 5.0}));
  EXPECT_EQ(RowLog::open(path_, 2).rows(), 5U);
}

TEST_F(RowLogs, AreCutBackToWholeBlocks) {
  write_two_blocks();
  EXPECT_EQ(RowLog::open(path_, 2, 4).rows(), 4U);
  {
    RowLog log = RowLog::open(path_, 2, 3);
    EXPECT_EQ(log.rows(), 3U);
    log.append(std::vector{7.0, 70.0});
  }
  EXPECT_EQ(RowLog::open(path_, 2).column(0), (std::vector{1.0, 2.0, 3.0, 7.0}));
  EXPECT_EQ(RowLog::open(path_, 2, 2).rows(), 0U);
}

/// However many rows came at a time.
TEST_F(RowLogs, AreTheSameBytesInEvenBlocks) {
  constexpr int count = 2500;
  std::vector<double> rows;
  for (int i = 0; i < count; ++i) rows.insert(rows.end(), {1.0 * i, i % 7 == 0 ? NAN : -2.0 * i});
  RowLog whole(path_, "identity", 2);
  whole.append(rows);
  RowLog pieces(folder_.path() / "pieces", "identity", 2);
  for (std::size_t i = 0; i < rows.size(); i += 2 * 625) pieces.append({&rows[i], 2 * 625});
  EXPECT_NE(folder_.read("pieces"), folder_.read("log"));
  whole.rewrite_evenly();
  pieces.rewrite_evenly();
  EXPECT_EQ(folder_.read("pieces"), folder_.read("log"));
  pieces.append(std::vector{7.0, 8.0});
  const RowLog again = RowLog::open(folder_.path() / "pieces", 2);
  ASSERT_EQ(again.rows(), count + 1U);
  EXPECT_EQ(again.column(0, 999, 2), (std::vector{999.0, 1000.0}));
  EXPECT_EQ(again.column(1, 2498, 1), std::vector{-4996.0});
  EXPECT_EQ(again.column(1, 2500, 1), std::vector{8.0});
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "log.new"));
}

TEST_F(RowLogs, TornAnywhereHoldWhatIsWhole) {
  write_two_blocks();
  const std::string whole = folder_.read("log");
  constexpr std::size_t record = 40;  // bytes before the data of each row
  const std::size_t second = whole.size() - record - 2 * sizeof(double);
  const std::size_t first = second - record - 6 * sizeof(double);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder_.write("log", whole.substr(0, size));
    EXPECT_EQ(RowLog::identity_of(path_).has_value(), size >= first) << size;
    if (size < first) continue;
    RowLog log = RowLog::open(path_, 2);
    EXPECT_EQ(log.rows(), size >= second ? 3U : 0U) << size;
    log.append(std::vector{7.0, 8.0});
    EXPECT_EQ(RowLog::open(path_, 2).rows(), size >= second ? 4U : 1U) << size;
  }
}

TEST_F(RowLogs, DamageAnywhereIsFoundOut) {
  write_two_blocks();
  const std::string whole = folder_.read("log");
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x10);
    folder_.write("log", damaged);
    if (!RowLog::identity_of(path_)) continue;
    EXPECT_LT(RowLog::open(path_, 2).rows(), 4U) << place;
  }
}

TEST_F(RowLogs, AreNoneWhereThereIsSomethingElse) {
  EXPECT_FALSE(RowLog::identity_of(path_));
  folder_.write("log", "something else");
  EXPECT_FALSE(RowLog::identity_of(path_));
  EXPECT_FALSE(RowLog::identity_of(folder_.path()));
}

}  // namespace
}  // namespace bumpfoil
