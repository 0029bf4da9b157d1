#include "bumpfoil/experiments/path/path.hpp"

#include "commands.hpp"
#include "experiment.hpp"

namespace bumpfoil {

void add_path_command(CLI::App& program, Session& session) {
  add_experiment(program, session,
                 cycle_experiment("path", "Take the journal along the path of [path]: positions, loads, orbits",
                                  "  bumpfoil path case.toml -o orbit --set 'path.centre=[\"0 um\",\"-45 um\"]' --set "
                                  "'path.semi_axes=[\"10 um\",\"5 um\"]'\n"
                                  "  bumpfoil path case.toml -o whirl --set 'path.centre=[\"0 N\",\"-100 N\"]' --set "
                                  "'path.semi_axes=[\"20 N\",\"20 N\"]'\n"
                                  "  bumpfoil path case.toml -o measured --set path.file=path.csv\n",
                                  run_path));
}

}  // namespace bumpfoil
