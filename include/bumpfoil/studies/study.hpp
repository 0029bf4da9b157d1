#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// One cycle run of a study: `bumpfoil cycle` of a case file with `--set` options.
struct StudyRun {
  std::string name;                    ///< of its result folder
  std::string label;                   ///< for people
  std::vector<std::string> overrides;  ///< "table.key=value" each, on the case of the preset "gen1"
  std::optional<double> parameter;     ///< value that the study varies, in the unit of Study::parameter_unit
};

/// Tables of a study, made from the results of its runs; see studies/study_tables.hpp.
enum class StudyTableKind { loops, quantities, loads, heights, foils, contacts };

/// As they are called in descriptions, and as their files without ".csv".
template <>
inline constexpr auto enum_names<StudyTableKind> = std::to_array<std::string_view>({"loops", "quantities", "loads",
                                                                                    "heights", "foils", "contacts"});

/// A table from elsewhere that a study compares with.
struct StudyData {
  std::string_view name;
  std::string_view csv;
};

/// A set of cycle runs, and the tables and the picture made of them.
struct Study {
  std::string name;  ///< "figure10" is Fig. 10 of [Arghir2019]; others have names of their own
  std::string title;
  std::vector<StudyRun> runs;
  std::string parameter;       ///< what is varied, such as "radial_clearance"; empty where nothing is
  std::string parameter_unit;  ///< such as "um"; empty for plain numbers
  std::vector<StudyTableKind> tables;
  std::vector<StudyData> data;
  std::vector<int> increments;  ///< that the table `foils` shows
  std::string script_of;        ///< the study whose script draws it, if not its own
  std::string plot_script;      ///< for gnuplot; reads the tables and writes the picture
};

/// Names of the studies in the program, figures first.
std::vector<std::string> study_names();

/// A study of the program: studies/NAME.toml and studies/NAME.gp in the sources. Keys of the description:
///
/// | key | meaning |
/// |---|---|
/// | `title` | one line |
/// | `tables` | names of StudyTableKind |
/// | `set` | overrides of every run that is not of another study |
/// | `[[run]]` | `name`, `label`, `set` of one run |
/// | `[[sweep]]` | a run for each value that `over` says, see parse_swept_key(), called `name`_value, with `set` |
/// | `runs_of`, `only` | runs of other studies come first: all, or those named by `only`; each name once |
/// | `[[variant]]` | these are run once for each variant: `name` is added to theirs, `set` to their overrides |
/// | `script_of` | the study whose script draws this one too |
/// | `data` | tables from elsewhere, studies/NAME.csv |
/// | `increments` | those that the table `foils` shows |
///
/// @throws Error (input) if there is none of this name, or its description is wrong
Study make_study(std::string_view name);

/// The same from the text of a description. @throws Error (input)
Study parse_study(std::string_view text, std::string_view name);

/// The case of a run. @throws Error (input)
Case study_case(const StudyRun& run);

}  // namespace bumpfoil
