#include "bumpfoil/results/checksum.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

// Expected values: printed by `xxhsum -H2` 0.8.1 for the same bytes. The algorithm uses a different branch for each of
// these lengths.
TEST(Checksum, IsThatOfTheProgramXxhsum) {
  EXPECT_EQ(xxh3_128(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(xxh3_128("bumpfoil"), "16966a90cb6bc6f4b6d197e1212206d1");
  EXPECT_EQ(xxh3_128(std::string(100, 'a')), "7d09cdccbc6bead248fb02115fe96a8a");
  EXPECT_EQ(xxh3_128(std::string(100'000, '\0')), "e1f876364c6fec62315c72a64b7df4d2");
}

TEST(Checksum, ChangesWithEveryBit) {
  const std::string text(1000, 'x');
  for (std::size_t place = 0; place < text.size(); place += 37) {
    std::string damaged = text;
    damaged[place] = static_cast<char>(damaged[place] ^ 1);
    EXPECT_NE(xxh3_128(damaged), xxh3_128(text)) << place;
  }
}

TEST(Checksum, SealsATextThatHoldsItsOwn) {
  const std::string text = "{\"xxh3_128\": \"" + std::string(blank_checksum) + "\", \"title\": \"x\"}";
  const std::string checksum = xxh3_128(text);
  std::string whole = sealed(text);
  EXPECT_EQ(whole, "{\"xxh3_128\": \"" + checksum + "\", \"title\": \"x\"}");
  EXPECT_TRUE(is_sealed(whole, checksum));
  EXPECT_FALSE(is_sealed(whole, ""));
  EXPECT_FALSE(is_sealed(whole, blank_checksum));
  EXPECT_FALSE(is_sealed(whole, "title"));
  for (char& letter : whole) {
    letter = static_cast<char>(letter ^ 1);
    EXPECT_FALSE(is_sealed(whole, checksum));
    letter = static_cast<char>(letter ^ 1);
  }
}

}  // namespace
}  // namespace bumpfoil
