#include "results/result_files.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "results/dataset_netcdf.hpp"
#include "results/manifest.hpp"
#include "results/netcdf_writer.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

/// Random, unless files must be reproducible.
std::string run_id_of(const RunRecord& run) {
  if (run.provenance.times) return make_run_id();
  return xxh3_128(fmt::format("{} {} {}\n{}", version(), commit(), run.command, case_to_toml(run.input)));
}

/// Of the computing time of a part of a run, `wall_time`.
constexpr const char* key_of_times = "wall_time_s";

void erase_times(Dataset& dataset) {
  std::erase_if(dataset.variables, [](const Variable& variable) { return variable.meaning.key() == key_of_times; });
}

void erase_times(nlohmann::ordered_json& json) {
  if (!json.is_structured()) return;
  if (json.is_object()) json.erase(key_of_times);
  for (nlohmann::ordered_json& part : json) erase_times(part);
}

ResultFile csv_file(const RunRecord& run, const TableFile& file) {
  if (run.provenance.times) return {file.name, csv_text(file.table)};
  Table table = file.table;
  table.erase(key_of_times);
  return {file.name, csv_text(table)};
}

nlohmann::ordered_json lists_of(const RunRecord& run, nlohmann::ordered_json lists) {
  if (!run.provenance.times) erase_times(lists);
  return lists;
}

void add_provenance(NewNetcdf& file, const RunRecord& run, std::string_view run_id) {
  const bool times = run.provenance.times;
  const std::string date = times ? fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))) : "";
  file.add_text("Conventions", "CF-1.8");
  file.add_text("schema", "bumpfoil-result/2");
  file.add_text("title", run.input.title);
  file.add_text("source", fmt::format("bumpfoil {} ({})", version(), commit()));
  file.add_text("history", times ? fmt::format("{}: {}", date, run.provenance.command_line) : "");
  file.add_text("date_created", date);
  file.add_text("run_id", run_id);
  file.add_text("command_line", run.provenance.command_line);
  file.add_text("bumpfoil_command", run.command);
  file.add_text("solver", name_of(run.input.solver.chosen()));
  file.add_text("status", run.status == RunStatus::complete ? "complete" : "partial");
  file.add_text("status_message", run.message);
  file.add_text("warnings", fmt::format("{}", fmt::join(run.warnings, "\n")));
  file.add_text("case_text", run.provenance.case_text);
  file.add_text("case_understood", case_to_toml(run.input));
}

/// Builds a netCDF file; failure is due to lack of memory. @param build  ()
template <typename Build>
auto built(std::string_view name, std::string_view advice, const Build& build) try {
  return build();
} catch (const netCDF::exceptions::NcException& error) {
  // The first line gives the error, the second its location in the library.
  const std::string_view reason = error.what();
  throw Error(ErrorKind::file,
              {{std::string(name), 0, "", "", fmt::format("cannot be built: {}", reason.substr(0, reason.find('\n'))),
                fmt::format("possibly not enough memory: {}", advice)}});
}

/// netCDF fails fatally on a full disk.
void require_room(const ResultFolder& folder, const std::string& name, std::size_t numbers) {
  constexpr std::size_t declarations = 20'000'000;  // including the text of the case
  const std::size_t needed = declarations + numbers * sizeof(double);
  const auto refuse = [&](std::string_view place, std::uintmax_t room, std::string advice) {
    throw Error(ErrorKind::file,
                {{(folder.path() / name).string(), 0, "", "",
                  fmt::format("takes up to {} MB, but {} {} MB", needed / 1'000'000, place, room / 1'000'000),
                  std::move(advice)}});
  };
  std::error_code code;
  const std::filesystem::space_info space = std::filesystem::space(folder.path(), code);
  if (!code && space.available < needed) {
    refuse("the free space of the disk is", space.available, "free some space, or use another folder");
  }
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur < needed) {
    refuse("the limit of file sizes is", limit.rlim_cur, "raise it: ulimit -f");
  }
}

/// Numbers in a dataset, as far as its dimensions are known.
std::size_t count_numbers(const Dataset& dataset) {
  std::size_t numbers = 0;
  for (const std::vector<Variable>* variables : {&dataset.coordinates, &dataset.variables}) {
    for (const Variable& variable : *variables) numbers += dataset.size_of(variable);
  }
  return numbers;
}

std::string summary_text(const RunRecord& run, const Manifest& manifest, const nlohmann::ordered_json& lists) {
  nlohmann::ordered_json summary = summary_head(run.command, run.input, run.status, manifest);
  summary["failures"] = run.failures;
  summary["warnings"] = run.warnings;
  summary.update(lists_of(run, lists));
  return sealed_summary(summary);
}

}  // namespace

std::string message_of(std::vector<std::string> failures, RunStatus status) {
  if (status == RunStatus::interrupted) failures.emplace_back("the run was interrupted by the user or the system");
  return fmt::format("{}", fmt::join(failures, "; "));
}

std::vector<ResultFile> make_result_files(const RunRecord& run, std::string_view netcdf_name, std::string_view advice,
                                          const std::function<ResultContents(const std::string&)>& contents) try {
  const std::string run_id = run_id_of(run);
  ResultContents made = contents(run_id);
  if (!run.provenance.times) erase_times(made.dataset);
  std::vector<ResultFile> files;
  for (const TableFile& table : made.tables) files.push_back(csv_file(run, table));
  std::move(made.texts.begin(), made.texts.end(), std::back_inserter(files));
  files.push_back({std::string(netcdf_name), built(netcdf_name, advice, [&] {
                     NewNetcdf file;
                     add_provenance(file, run, run_id);
                     DatasetNetcdf dataset(file);
                     dataset.add(made.dataset);
                     dataset.append(made.dataset);
                     return file.close();
                   })});
  files.push_back({"summary.json", summary_text(run, make_manifest(run_id, files), made.lists)});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file,
              {{"summary.json", 0, "", "", "cannot be built: not enough memory", std::string(advice)}});
}

void stage_result_files(const RunRecord& run, const std::string& netcdf_name, std::string_view advice,
                        const Dataset& dataset, const nlohmann::ordered_json& lists, ResultFolder& folder,
                        const std::vector<TableFile>& tables) {
  ResultStream({.netcdf = netcdf_name, .csv = {}, .advice = advice}, dataset, folder).finish(run, {}, lists, tables);
}

ResultStream::ResultStream(StreamedFiles files, Dataset dataset, ResultFolder& folder)
    : files_(std::move(files)), dataset_(std::move(dataset)), folder_(folder), path_(folder.stage(files_.netcdf)) {
  require_room(folder_, files_.netcdf, count_numbers(dataset_));
  if (!files_.csv.empty()) {
    csv_.emplace(folder.stage(files_.csv), folder.path() / files_.csv, O_WRONLY | O_CREAT | O_TRUNC);
    write_all(*csv_, csv_header(grown_table(dataset_, 0)), folder.path() / files_.csv);
  }
  built(files_.netcdf, files_.advice, [&] {
    file_ = std::make_unique<NewNetcdf>(path_);
    variables_ = std::make_unique<DatasetNetcdf>(*file_);
    variables_->add(dataset_);
  });
}

ResultStream::~ResultStream() = default;

void ResultStream::append() {
  require_room(folder_, files_.netcdf, 0);
  if (csv_) {
    const Table entries = grown_table(dataset_, rows_);
    rows_ += entries.rows();
    write_all(*csv_, csv_rows(entries), folder_.path() / files_.csv);
  }
  built(files_.netcdf, files_.advice, [&] { variables_->append(dataset_); });
}

void ResultStream::finish(const RunRecord& run, Dataset totals, const nlohmann::ordered_json& lists,
                          const std::vector<TableFile>& tables) {
  Manifest manifest{run_id_of(run), {}};
  if (!run.provenance.times) erase_times(totals);
  built(files_.netcdf, files_.advice, [&] {
    add_provenance(*file_, run, manifest.run_id);
    variables_->add(totals);
    file_->close_file();
  });
  for (const std::string& name : {files_.csv, files_.netcdf}) {
    if (name.empty()) continue;
    const std::filesystem::path path = path_.parent_path() / name;
    manifest.files.push_back(
        {name, static_cast<std::size_t>(std::filesystem::file_size(path)), xxh3_128_of_file(path)});
  }
  for (const TableFile& table : tables) {
    const ResultFile text = csv_file(run, table);
    folder_.stage(text.name, text.contents);
    manifest.files.push_back({text.name, text.contents.size(), xxh3_128(text.contents)});
  }
  folder_.stage("summary.json", summary_text(run, manifest, lists));
}

}  // namespace bumpfoil
