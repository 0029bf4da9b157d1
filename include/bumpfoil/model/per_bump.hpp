#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace bumpfoil {

/// Law of a dimension from the first bump of a foil to the last.
enum class Grading {
  linear,     ///< by equal differences
  geometric,  ///< by equal ratios
};

/// A dimension of the bumps of a foil, SI: one number for all, one for each from the weld on, or a first and a last one
/// with a law between them. With N bumps the law gives bump n = 1 ... N
///
///     linear: x_n = x_1 + (x_N - x_1) t     geometric: x_n = x_1 (x_N / x_1)^t     t = (n - 1) / (N - 1)
struct PerBump {
  std::vector<double> values{0.0};  ///< one, one per bump, or the first and the last
  std::optional<Grading> law{};     ///< between the first and the last

  PerBump() = default;
  PerBump(double common) : values{common} {}  // not explicit: most foils have bumps of one kind
  explicit PerBump(std::vector<double> each) : values(std::move(each)) {}
  PerBump(double first, double last, Grading between) : values{first, last}, law(between) {}

  /// @param bump  from 0
  /// @param bumps  of the foil; those that are listed may be more
  [[nodiscard]] double at(std::size_t bump, std::size_t bumps) const;

  [[nodiscard]] bool is_list() const { return !law && values.size() != 1; }

  bool operator==(const PerBump&) const = default;
};

/// The same with a value for each bump.
PerBump listed(const PerBump& dimension, std::size_t bumps);

/// The same with `deviation` added at every bump.
PerBump shifted(const PerBump& dimension, std::size_t bumps, double deviation);

/// Bumps `from` to `to` of a foil, counted from 1, with other dimensions; absent: as for all bumps.
struct BumpSection {
  int from{};
  int to{};
  std::optional<double> pitch{};      ///< m
  std::optional<double> length{};     ///< m
  std::optional<double> height{};     ///< m
  std::optional<double> thickness{};  ///< m

  bool operator==(const BumpSection&) const = default;
};

/// A sheet under bumps `from` to `to`, counted from 1, that raises them.
struct Shim {
  int from{};
  int to{};
  double thickness{};  ///< m

  bool operator==(const Shim&) const = default;
};

}  // namespace bumpfoil
