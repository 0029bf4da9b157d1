#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/table.hpp"
#include "results/posix_file.hpp"

namespace bumpfoil {

class DatasetNetcdf;
class NewNetcdf;

/// The message of a run with these failures.
std::string message_of(std::vector<std::string> failures, RunStatus status);

/// A run, in the form common to all of its files.
struct RunRecord {
  const Case& input;  ///< the case that was run, or one of several
  std::string_view command;
  RunStatus status;
  std::vector<std::string> failures{};
  std::vector<std::string> warnings{};
  const Provenance& provenance;
  std::string message = message_of(failures, status);  ///< why the results are incomplete
};

/// The files of a run.
struct ResultContents {
  std::vector<TableFile> tables{};  ///< CSV files
  std::vector<ResultFile> texts{};  ///< additional text files
  nlohmann::ordered_json lists;     ///< of summary.json, after what all have
  Dataset dataset{};                ///< of experiments that of their Outcome
};

/// The files of a run, with one new run id: its tables as CSV, its texts, its dataset as netCDF-4 with CF conventions,
/// and summary.json with their checksums.
/// | netCDF is not thread-safe: call from one thread at a time.
/// @param netcdf_name  such as result.nc
/// @param advice       how to reduce memory
/// @param contents     (run id) -> contents to write
/// @throws Error (file) if memory does not suffice
std::vector<ResultFile> make_result_files(const RunRecord& run, std::string_view netcdf_name, std::string_view advice,
                                          const std::function<ResultContents(const std::string&)>& contents);

/// The same for a dataset that may exceed memory: stages it in the folder piece by piece, and summary.json.
/// @param lists   of summary.json
/// @param tables  CSV files
/// @throws Error (file), as soon as the disk is full
void stage_result_files(const RunRecord& run, const std::string& netcdf_name, std::string_view advice,
                        const Dataset& dataset, const nlohmann::ordered_json& lists, ResultFolder& folder,
                        const std::vector<TableFile>& tables = {});

/// Files of a result that is written during the run.
struct StreamedFiles {
  std::string netcdf;         ///< such as result.nc
  std::string csv{};          ///< over the first growing dimension: one line per entry; empty: none
  std::string_view advice{};  ///< how to reduce memory
};

/// Stages the files of a run in progress, for results larger than memory: written data need not be kept. An observer of
/// march() that keeps some increments supplies them in blocks.
class ResultStream {
 public:
  /// @param dataset  everything known before the end of the run. Values over growing dimensions are read when they are
  ///                 appended: those in memory.
  /// @throws Error (file), as do all functions; here if the disk has no room for the known dimensions
  ResultStream(StreamedFiles files, Dataset dataset, ResultFolder& folder);
  ~ResultStream();
  ResultStream(const ResultStream&) = delete;
  ResultStream& operator=(const ResultStream&) = delete;

  /// Appends the entries in memory to the files.
  void append();

  /// Completes the files, and stages others and summary.json.
  /// @param totals  final results; those already present are skipped
  /// @param lists   of summary.json
  void finish(const RunRecord& run, Dataset totals, const nlohmann::ordered_json& lists,
              const std::vector<TableFile>& tables = {});

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
