#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {

class DatasetNetcdf;
class NewNetcdf;

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

/// The files of a run.
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
/// @param texts  beside it
/// @param lists  of summary.json
/// @throws Error (file), as soon as the disk has no room for it
void stage_result_files(const RunRecord& run, const std::string& netcdf_name, std::string_view advice,
                        const Dataset& dataset, const nlohmann::ordered_json& lists, ResultFolder& folder,
                        const std::vector<ResultFile>& texts = {});

/// Files of a result that is written as it comes.
struct StreamedFiles {
  std::string netcdf;         ///< such as result.nc
  std::string csv{};          ///< of the first dimension that grows: a line for each entry; empty for none
  std::string_view advice{};  ///< what takes less memory
};

/// Stages the files of a run while it goes on, for results that the memory does not hold: what they have written need
/// not be kept. An observer of march() that keeps some increments feeds it, a block of them at a time.
class ResultStream {
 public:
  /// @param dataset  all that is known before the run ends. Its values over dimensions that grow are read when they are
  ///                 appended: those in memory.
  /// @throws Error (file), as do all functions; here if the disk has no room for the dimensions that are known
  ResultStream(StreamedFiles files, Dataset dataset, ResultFolder& folder);
  ~ResultStream();
  ResultStream(const ResultStream&) = delete;
  ResultStream& operator=(const ResultStream&) = delete;

  /// Appends the entries in memory to the files.
  void append();

  /// Completes the files, and stages others and summary.json.
  /// @param totals  what is known in the end; what is there already is left out
  /// @param lists   of summary.json
  void finish(const RunRecord& run, Dataset totals, const nlohmann::ordered_json& lists,
              const std::vector<ResultFile>& texts = {});

 private:
  StreamedFiles files_;
  Dataset dataset_;
  ResultFolder& folder_;
  std::filesystem::path path_;  ///< of the netCDF file
  std::optional<FileDescriptor> csv_;
  std::size_t rows_{};  ///< of the CSV file
  std::unique_ptr<NewNetcdf> file_;
  std::unique_ptr<DatasetNetcdf> variables_;
};

}  // namespace bumpfoil
