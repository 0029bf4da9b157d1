#pragma once

#include <string>
#include <vector>

#include "bumpfoil/studies/study.hpp"
#include "bumpfoil/studies/study_tables.hpp"

namespace bumpfoil {

/// How a study went: a line of the table that `bumpfoil reproduce` ends with.
struct StudyOutcome {
  std::string name, title;
  std::size_t runs{};
  std::size_t increments{};             ///< of all runs
  double max_residual{};                ///< largest of all runs
  bool converged{true};                 ///< all of them
  double wall_time{};                   ///< s, with the files and the picture
  std::vector<std::string> failures{};  ///< study, run and failure_lines() of each
};

/// Counts what the runs of a study took; the time is left to the caller.
StudyOutcome outcome_of(const Study& study, const std::vector<StudyRunResult>& results);

/// Outcomes as a text table, one line each.
std::string study_outcomes_table(const std::vector<StudyOutcome>& outcomes);

/// Contents of study.json: title, version, every run with its overrides and status, and all tables column by column.
std::string study_json(const Study& study, const std::vector<StudyRunResult>& results,
                       const std::vector<StudyTable>& tables);

}  // namespace bumpfoil
