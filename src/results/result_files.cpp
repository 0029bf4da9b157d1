#include "results/result_files.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "results/manifest.hpp"
#include "results/netcdf_writer.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

/// Numbers of a chunk of a compressed variable, a megabyte, unless its last dimension alone has more.
constexpr std::size_t most_in_chunk = 131'072;

/// One chunk holds whole rows of the last dimensions, as many as fit.
std::vector<std::size_t> chunk_of(const std::vector<std::size_t>& extents) {
  std::vector<std::size_t> chunk(extents.size(), 1);
  std::size_t room = most_in_chunk;
  for (std::size_t i = extents.size(); i-- > 0 && room > 0;) {
    chunk[i] = i + 1 == extents.size() ? extents[i] : std::min(extents[i], room);
    if (chunk[i] < extents[i]) break;
    room /= std::max<std::size_t>(chunk[i], 1);
  }
  return chunk;
}

/// Entries of the first dimension of a variable with rows that are in memory at a time.
constexpr std::size_t entries_at_once = 10'000;

void put_values(const netCDF::NcVar& added, const Variable& variable, std::vector<std::size_t> extents) {
  std::vector<std::size_t> start(extents.size());
  if (!variable.rows) {
    const std::vector<double> values = variable.values();
    if (!values.empty()) NewNetcdf::put(added, start, extents, values);
    return;
  }
  const std::size_t end = extents.front();
  for (std::size_t& first = start.front(); first < end; first += entries_at_once) {
    extents.front() = std::min(entries_at_once, end - first);
    NewNetcdf::put(added, start, extents, variable.rows(first, extents.front()));
  }
}

void add_provenance(NewNetcdf& file, const RunRecord& run, std::string_view run_id) {
  const std::string date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  file.add_text("Conventions", "CF-1.8");
  file.add_text("schema", "bumpfoil-result/2");
  file.add_text("title", run.input.title);
  file.add_text("source", fmt::format("bumpfoil {} ({})", version(), commit()));
  file.add_text("history", fmt::format("{}: {}", date, run.provenance.command_line));
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

void write_dataset(NewNetcdf& file, const Dataset& dataset) {
  for (const auto& [name, text] : dataset.attributes) file.add_text(name, text);
  std::map<std::string, netCDF::NcDim> dims;
  for (const DataDimension& dim : dataset.dims) dims.emplace(dim.name, file.add_dim(dim.name, dim.size));
  for (const std::vector<Variable>* variables : {&dataset.coordinates, &dataset.variables}) {
    for (const Variable& variable : *variables) {
      NewNetcdf::Dims all;
      std::vector<std::size_t> extents;
      for (const std::string& name : variable.dims) {
        all.push_back(dims.at(name));
        extents.push_back(all.back().getSize());
      }
      const netCDF::NcVar added =
          variable.known ? file.put_all(variable.meaning, all, variable.values()) : file.add(variable.meaning, all);
      for (const auto& [name, text] : variable.attributes) {
        if (!text.empty()) added.putAtt(name, text);
      }
      if (variable.compressed) {
        std::vector<std::size_t> chunk = chunk_of(extents);
        added.setChunking(netCDF::NcVar::nc_CHUNKED, chunk);
        added.setCompression(true, true, 1);
      }
      if (!variable.known) put_values(added, variable, std::move(extents));
    }
  }
}

/// Builds a netCDF file; that it fails is for want of memory. @param build  ()
template <typename Build>
auto built(std::string_view name, std::string_view advice, const Build& build) try {
  return build();
} catch (const netCDF::exceptions::NcException& error) {
  // The first line says what went wrong, the second where in the library.
  const std::string_view reason = error.what();
  throw Error(ErrorKind::file,
              {{std::string(name), 0, "", "", fmt::format("cannot be built: {}", reason.substr(0, reason.find('\n'))),
                fmt::format("possibly not enough memory: {}", advice)}});
}

/// netCDF does not survive a full disk.
void require_room(const std::filesystem::path& path, const Dataset& dataset) {
  constexpr std::size_t declarations = 20'000'000;  // with the text of the case
  std::size_t needed = declarations;
  for (const std::vector<Variable>* variables : {&dataset.coordinates, &dataset.variables}) {
    for (const Variable& variable : *variables) needed += dataset.size_of(variable) * sizeof(double);
  }
  std::error_code code;
  const std::filesystem::space_info space = std::filesystem::space(path.parent_path(), code);
  if (code || space.available >= needed) return;
  throw Error(
      ErrorKind::file,
      {{path.filename().string(), 0, "", "",
        fmt::format("takes up to {} MB, but the disk has {} MB free", needed / 1'000'000, space.available / 1'000'000),
        "free some space, or use another folder"}});
}

std::string summary_text(const RunRecord& run, const Manifest& manifest, const nlohmann::ordered_json& lists) {
  nlohmann::ordered_json summary = summary_head(run.command, run.input, run.status, manifest);
  summary.update(lists);
  return sealed_summary(summary);
}

}  // namespace

std::string message_of(std::vector<std::string> failures, RunStatus status) {
  if (status == RunStatus::interrupted) failures.emplace_back("the run was interrupted by the user or the system");
  return fmt::format("{}", fmt::join(failures, "; "));
}

std::vector<ResultFile> make_result_files(const RunRecord& run, std::string_view netcdf_name, std::string_view advice,
                                          const std::function<ResultContents(const std::string&)>& contents) try {
  const std::string run_id = make_run_id();
  ResultContents made = contents(run_id);
  std::vector<ResultFile> files = std::move(made.texts);
  files.push_back({std::string(netcdf_name), built(netcdf_name, advice, [&] {
                     NewNetcdf file;
                     add_provenance(file, run, run_id);
                     write_dataset(file, made.dataset);
                     return file.close();
                   })});
  files.push_back({"summary.json", summary_text(run, make_manifest(run_id, files), made.lists())});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file,
              {{"summary.json", 0, "", "", "cannot be built: not enough memory", std::string(advice)}});
}

void stage_result_files(const RunRecord& run, const std::string& netcdf_name, std::string_view advice,
                        const Dataset& dataset, const nlohmann::ordered_json& lists, ResultFolder& folder) {
  Manifest manifest{make_run_id(), {}};
  const std::filesystem::path path = folder.stage(netcdf_name);
  require_room(path, dataset);
  built(netcdf_name, advice, [&] {
    NewNetcdf file(path);
    add_provenance(file, run, manifest.run_id);
    write_dataset(file, dataset);
    file.close_file();
  });
  manifest.files.push_back(
      {netcdf_name, static_cast<std::size_t>(std::filesystem::file_size(path)), xxh3_128_of_file(path)});
  folder.stage("summary.json", summary_text(run, manifest, lists));
}

}  // namespace bumpfoil
