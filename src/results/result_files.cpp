#include "results/result_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "results/manifest.hpp"
#include "results/netcdf_provenance.hpp"
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
      const std::vector<double> values = variable.values();
      const netCDF::NcVar added =
          variable.known ? file.put_all(variable.meaning, all, values) : file.add(variable.meaning, all);
      for (const auto& [name, text] : variable.attributes) {
        if (!text.empty()) added.putAtt(name, text);
      }
      if (variable.compressed) {
        std::vector<std::size_t> chunk = chunk_of(extents);
        added.setChunking(netCDF::NcVar::nc_CHUNKED, chunk);
        added.setCompression(true, true, 1);
      }
      if (variable.known || values.empty()) continue;
      NewNetcdf::put(added, std::vector<std::size_t>(all.size()), extents, values);
    }
  }
}

std::string netcdf_of(const RunRecord& run, const Dataset& dataset, std::string_view name, std::string_view advice,
                      const std::string& run_id) {
  try {
    NewNetcdf file;
    add_provenance(file, run, run_id);
    write_dataset(file, dataset);
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt(name, error, advice);
  }
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
  files.push_back({std::string(netcdf_name), netcdf_of(run, made.dataset, netcdf_name, advice, run_id)});
  nlohmann::ordered_json summary = summary_head(run.command, run.input, run.status, make_manifest(run_id, files));
  summary.update(made.lists());
  files.push_back({"summary.json", sealed_summary(summary)});
  return files;
} catch (const std::bad_alloc&) {
  throw Error(ErrorKind::file,
              {{"summary.json", 0, "", "", "cannot be built: not enough memory", std::string(advice)}});
}

}  // namespace bumpfoil
