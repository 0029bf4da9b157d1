#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// A case as Python gives it.
struct CaseSource {
  std::string text;                  ///< of a case file
  std::string name;                  ///< of the file; empty if Python generated the text, whose lines the user does not
                                     ///< see
  std::vector<std::string> changes;  ///< "table.key=value" each, see CaseRequest
};

/// @throws Error as parse_case() does; errors of what was given in Python have its keys alone
Case read_source(const CaseSource& source, const std::vector<std::string>& commands = {});

/// @throws Error as check_case() does, with the same text
void check_source(const CaseSource& source);

/// @throws Error (input) about an argument
[[noreturn]] void refuse_argument(std::string name, std::string what, std::string advice);

/// What a command gave.
struct Run {
  std::string command;
  Case input;
  Outcome outcome;
  std::function<std::vector<ResultFile>()> files;  ///< made when they are requested; netCDF is not thread-safe
};

/// The grid of a sweep.
/// @throws Error as parse_sweep() and read_source() do
Sweep read_sweep(const CaseSource& source, const std::string& command, const std::vector<std::string>& over,
                 bool limits);

/// Where results come from. @param case_text  see kept_text()
Provenance provenance_of(const std::string& command, const std::string& case_text);

/// Runs an experiment.
/// @param case_text  for the provenance
Run run_command(const std::string& command, const Case& input, const std::string& case_text,
                const ProgressCallback& progress);

/// Runs the points of a sweep, several at a time. @param progress  called by this thread alone
Run run_sweep(const Sweep& sweep, const std::string& case_text, unsigned threads, const ProgressCallback& progress);

}  // namespace bumpfoil
