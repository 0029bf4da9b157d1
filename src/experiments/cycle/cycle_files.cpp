#include "bumpfoil/experiments/cycle/cycle_files.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/increment_rows.hpp"
#include "bumpfoil/experiments/cycle/result_names.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "experiments/cycle/cycle_dataset.hpp"
#include "experiments/cycle/cycle_json.hpp"
#include "experiments/cycle/cycle_record.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {

std::vector<std::string> cycle_file_names(std::string_view command) {
  return {"summary.json", fmt::format("{}.csv", command), "result.nc"};
}

RunRecord cycle_record(const Case& input, const CycleResult& result, RunStatus status, const Provenance& provenance) {
  return {.input = input,
          .command = name_of(result.experiment),
          .status = status,
          .message = message_of(failure_lines(input, result), status),
          .warnings = warning_lines(input, result),
          .provenance = provenance};
}

std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance) {
  const std::string_view command = name_of(result.experiment);
  return make_result_files(cycle_record(input, result, status, provenance), "result.nc", cycle_advice,
                           [&](const std::string& /*run_id*/) {
                             return ResultContents{.tables = {{fmt::format("{}.csv", command), increment_rows(result)}},
                                                   .dataset = cycle_dataset(input, result, status, Extent::everything),
                                                   .lists = [&] { return cycle_lists(input, result); }};
                           });
}

}  // namespace bumpfoil
