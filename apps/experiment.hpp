#pragma once

#include "bumpfoil/experiments/experiments.hpp"
#include "commands.hpp"

namespace bumpfoil {

/// Advice for a folder with an unfinished run.
inline constexpr const char* resume_advice = "continue it with --resume, restart with --force, or use another folder";

/// Exit code for the status of a run.
ExitCode exit_code_of(RunStatus status);

/// Adds the command of an experiment to the program.
void add_experiment(CLI::App& program, Session& session, const ExperimentInfo& experiment);

}  // namespace bumpfoil
