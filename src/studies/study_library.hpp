#pragma once

#include <string_view>
#include <vector>

#include "bumpfoil/studies/study.hpp"

namespace bumpfoil {

/// A compiled-in study.
struct StudyText {
  std::string_view name;
  std::string_view description;  ///< TOML
  std::string_view script;       ///< for gnuplot; empty if it shares that of another
};

const std::vector<StudyText>& study_library();

/// All compiled-in tables.
const std::vector<StudyData>& study_data_library();

/// Common start of all scripts.
std::string_view study_style_script();

}  // namespace bumpfoil
