#include "bumpfoil/experiments/strip/strip.hpp"

#include "commands.hpp"
#include "experiment.hpp"

namespace bumpfoil {

void add_strip_command(CLI::App& program, Session& session) {
  add_experiment(program, session,
                 cycle_experiment("strip", "Compress a flat strip of the foils between two plates, as [strip] says",
                                  "  bumpfoil strip examples/strip.toml -o strip\n"
                                  "  bumpfoil strip examples/strip.toml -o pressed --set strip.preload=\"100 N\"\n"
                                  "  bumpfoil strip examples/strip.toml -o free --set strip.weld=none\n",
                                  run_strip));
}

}  // namespace bumpfoil
