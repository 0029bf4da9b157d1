#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A bearing as the start of a case file.
struct Preset {
  std::string_view name;
  std::string_view head;  ///< comment at the top of its file: what it is, and its source
  Case input;
  /// Remarks on some keys beyond their meaning, by path: that values are assumed, or why they were chosen.
  std::vector<std::pair<std::string_view, std::string_view>> remarks;
};

/// All presets; the first is the reference case. They are defined in a higher layer, as case_tables() are: they have
/// settings of experiments.
const std::vector<Preset>& presets();

}  // namespace bumpfoil
