#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace bumpfoil {

/// Random numbers from bytes that a fuzzer mutates: two bytes each, and 0 after the last.
class DrawsOfBytes {
 public:
  explicit DrawsOfBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// In [0, 1).
  double probability() {
    if (bytes_.size() < 2) return 0.0;
    const unsigned number = bytes_[0] + 256U * bytes_[1];
    bytes_ = bytes_.subspan(2);
    return number / 65536.0;
  }
  bool chance(double probable) { return probability() >= 1.0 - probable; }
  double uniform(double low, double high) { return low + (high - low) * probability(); }
  /// The same in its logarithm.
  double decades(double low, double high) { return low * std::pow(high / low, probability()); }
  /// Whole, both ends included.
  int whole(int low, int high) { return low + static_cast<int>((high - low + 1) * probability()); }
  std::string among(std::initializer_list<const char*> words) {
    return words.begin()[whole(0, static_cast<int>(words.size()) - 1)];
  }
  /// Many numbers in [-1, 1) that two bytes stand for.
  std::vector<double> scatter(int count) {
    std::mt19937_64 generator(static_cast<std::uint64_t>(65536.0 * probability()));
    std::vector<double> numbers(static_cast<std::size_t>(count));
    for (double& number : numbers) number = 2.0 * std::generate_canonical<double, 53>(generator) - 1.0;
    return numbers;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// Bytes to draw from, the same for the same seed.
inline std::vector<std::uint8_t> bytes_of_seed(std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::uint8_t> bytes(512);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(generator());
  return bytes;
}

}  // namespace bumpfoil
