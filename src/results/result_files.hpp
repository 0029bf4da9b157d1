#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// A run, as all of its files tell of it.
struct RunRecord {
  const Case& input;  ///< the case, or one of those, that were run
  std::string_view command;
  RunStatus status;
  std::string message;  ///< what keeps the results from being complete
  std::vector<std::string> warnings{};
  const Provenance& provenance;
};

/// The message of a run with these failures.
std::string message_of(std::vector<std::string> failures, RunStatus status);

/// What a run writes.
struct ResultContents {
  std::vector<ResultFile> texts;  ///< beside the others
  Dataset dataset;
  std::function<nlohmann::ordered_json()> lists;  ///< of summary.json, behind what all summaries begin with
};

/// The files of a run, with one new run id: its texts, its dataset as netCDF-4 after the CF conventions, and
/// summary.json with their checksums.
///
/// netCDF is not thread-safe: to be called by one thread at a time.
/// @param netcdf_name  such as result.nc
/// @param advice       what takes less memory
/// @param contents     (run id) -> what is written
/// @throws Error (file) if the memory does not suffice
std::vector<ResultFile> make_result_files(const RunRecord& run, std::string_view netcdf_name, std::string_view advice,
                                          const std::function<ResultContents(const std::string&)>& contents);

/// The same for a dataset that the memory may not hold: stages it in the folder piece by piece, and summary.json.
/// @param lists  of summary.json
/// @throws Error (file), as soon as the disk has no room for it
void stage_result_files(const RunRecord& run, const std::string& netcdf_name, std::string_view advice,
                        const Dataset& dataset, const nlohmann::ordered_json& lists, ResultFolder& folder);

}  // namespace bumpfoil
