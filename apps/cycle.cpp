#include "bumpfoil/experiments/cycle/cycle.hpp"

#include "commands.hpp"
#include "experiment.hpp"

namespace bumpfoil {

void add_cycle_command(CLI::App& program, Session& session) {
  ExperimentCommand cycle =
      cycle_experiment("cycle", "Push the journal in each direction of [cycle] and pull it back",
                       "  bumpfoil cycle case.toml -o results\n"
                       "  bumpfoil cycle case.toml -o frictionless --set friction.coefficient=0\n"
                       "  bumpfoil cycle case.toml -o fine --set cycle.steps=400 --set "
                       "'cycle.directions=[\"+X\"]'\n"
                       "  bumpfoil cycle case.toml -o seventeen --sample tolerances/ensemble.nc:17\n",
                       run_cycles);
  cycle.sampled = EnsembleCommand::cycle;
  add_experiment(program, session, cycle);
}

}  // namespace bumpfoil
