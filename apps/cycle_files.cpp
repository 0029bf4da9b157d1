#include "cycle_files.hpp"

#include "bumpfoil/io/cycle_files.hpp"

namespace bumpfoil {

void stage_cycle_files(ResultFolder& folder, const Case& input, const CycleResult& result, RunStatus status,
                       const Provenance& provenance) {
  for (const ResultFile& file : cycle_files(input, result, status, provenance)) folder.stage(file.name, file.contents);
}

}  // namespace bumpfoil
