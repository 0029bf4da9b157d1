#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Maximum number of values of a sweep, over all its keys.
inline constexpr std::size_t most_sweep_points = 10'000;

/// A key of the case file and its values in order.
struct SweptKey {
  std::string key;                  ///< dotted, such as "friction.coefficient"
  std::vector<std::string> values;  ///< numbers with their units as a user would write them: "0.15", "60 um"
};

/// Reads the argument of `--over`: "KEY=FROM:TO:STEP" or "KEY=[a, b, ...]".
///
/// A range is computed with the decimals that were written: "0:0.5:0.05" gives 0.15, not 0.15000000000000002. It holds
/// FROM and TO, both as written; where STEP is a fraction such as 0.333333333 its last step ends at TO if that is no
/// further than a millionth of STEP. Units stand behind each of the three numbers, and are the same: "60 um:90 um:10
/// um". Entries of a list may be quoted, and each has a unit of its own.
///
/// @throws Error (input) on a wrong form, a missing number, steps that do not end at TO, or more than most_sweep_points
/// values
SweptKey parse_swept_key(std::string_view argument);

}  // namespace bumpfoil
