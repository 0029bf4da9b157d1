#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/studies/study.hpp"

namespace bumpfoil {

/// A run of a study and its result.
struct StudyRunResult {
  Case input;
  CycleResult result;
  RunStatus status{RunStatus::complete};
};

/// Nothing, a whole number, a number or a word without commas.
using TableCell = std::variant<std::monostate, int, double, std::string>;

/// Columns with their units in their names, and rows of as many cells.
struct StudyTable {
  std::string name;
  std::vector<std::string> columns;
  std::vector<std::vector<TableCell>> rows;
};

/// A table of the results of a study, SI. The first column is always `run`.
///
/// | table | one row for each |
/// |---|---|
/// | loops | increment: force against displacement |
/// | quantities | direction: what `summary.json` has, and the parameter that is varied |
/// | loads | bump: loads at full displacement |
/// | heights | bump: its height over the sleeve, and that of the journal (less the top foil) at both ends of the push |
/// | foils | bump at one of Study::increments: heights over the sleeve, gaps, forces, states; the foot after it |
/// | contacts | increment: closed and slipping contacts of each interface, and those that opened and closed in it |
///
/// @param results  in the order of Study::runs
StudyTable make_study_table(StudyTableKind kind, const Study& study, const std::vector<StudyRunResult>& results);

/// The table as CSV: a header and a line per row, numbers with 17 significant digits, nothing for what is not finite.
std::string table_csv(const StudyTable& table);

}  // namespace bumpfoil
