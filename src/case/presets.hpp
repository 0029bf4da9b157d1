#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A bearing to start a case file from.
struct Preset {
  std::string_view name;
  std::string_view head;  ///< lines of comment that its file begins with: what it is, and where it comes from
  Case input;
  /// Remarks on some keys in addition to their meaning: that they are assumed, or why they have this value. By path.
  std::vector<std::pair<std::string_view, std::string_view>> remarks;
};

/// All of them; the first is reference_case().
const std::vector<Preset>& presets();

}  // namespace bumpfoil
