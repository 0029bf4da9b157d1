#include "sweep/sweep_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>

#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"
#include "results/netcdf_provenance.hpp"
#include "results/netcdf_writer.hpp"
#include "sweep/sweep_layout.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcVar;

/// Puts a sweep into a file, variable by variable.
class SweepWriter {
 public:
  SweepWriter(NewNetcdf& file, const Sweep& sweep, const std::vector<SweepPoint>& points)
      : file_(file), sweep_(sweep), points_(points), grid_(layout_of(sweep, points).grid) {
    for (const SweepAxis& axis : sweep.axes) keys_.push_back(file.add_dim(axis.name, axis.values.size()));
    for (const GridDim& dim : grid_.dims) dims_.emplace(dim.name, file.add_dim(dim.name, dim.size));
  }

  void write_coordinates() {
    for (std::size_t i = 0; i < sweep_.axes.size(); ++i) {
      const SweepAxis& axis = sweep_.axes[i];
      file_.put_all({axis.name, axis.unit, axis.title}, {keys_[i]}, axis.values).putAtt("case_key", axis.swept.key);
    }
    for (const GridVariable& coordinate : grid_.coordinates) {
      file_.put_all(coordinate.meaning, {dims_.at(coordinate.dims.front())}, coordinate.values);
    }
  }

  void write_variables() {
    for (std::size_t i = 0; i < grid_.variables.size(); ++i) {
      const GridVariable& variable = grid_.variables[i];
      NewNetcdf::Dims dims = keys_;
      for (const std::string& name : variable.dims) dims.push_back(dims_.at(name));
      const NcVar added = file_.add(variable.meaning, dims);
      if (!variable.coordinates.empty()) added.putAtt("coordinates", variable.coordinates);
      for (std::size_t point = 0; point < points_.size(); ++point) write_block(added, variable, i, point);
    }
  }

 private:
  /// What a point has of a variable; what others have more is absent there.
  void write_block(const NcVar& added, const GridVariable& variable, std::size_t number, std::size_t point) const {
    const std::vector<double>& values = points_[point].values[number];
    if (values.empty()) return;
    std::vector<std::size_t> start = indices_of(sweep_, point);
    std::vector<std::size_t> count(start.size(), 1);
    for (const std::string& name : variable.dims) {
      const auto dim =
          std::find_if(grid_.dims.begin(), grid_.dims.end(), [&name](const GridDim& one) { return one.name == name; });
      start.push_back(0);
      count.push_back(points_[point].extents[static_cast<std::size_t>(dim - grid_.dims.begin())]);
    }
    NewNetcdf::put(added, start, count, values);
  }

  NewNetcdf& file_;
  const Sweep& sweep_;
  const std::vector<SweepPoint>& points_;
  ResultGrid grid_;
  NewNetcdf::Dims keys_;
  std::map<std::string, netCDF::NcDim> dims_;
};

std::string message_of(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const auto count = [&points](RunStatus status) {
    return std::count_if(points.begin(), points.end(), [=](const SweepPoint& point) { return point.status == status; });
  };
  std::string message;
  if (const auto failed = count(RunStatus::failed); failed > 0) {
    message =
        fmt::format("{} of {} points failed: {}", failed, points.size(), fmt::join(failure_lines(sweep, points), "; "));
  }
  if (const auto missing = count(RunStatus::interrupted); missing > 0) {
    message += fmt::format("{}the sweep was interrupted by the user or the system: {} of {} points are missing",
                           message.empty() ? "" : "; ", missing, points.size());
  }
  return message;
}

}  // namespace

std::string sweep_netcdf(const Sweep& sweep, const std::vector<SweepPoint>& points, const Provenance& provenance,
                         std::string_view run_id) {
  try {
    NewNetcdf file;
    add_provenance(file, {.input = sweep.cases.front(),
                          .command = "sweep",
                          .status = status_of(points),
                          .message = message_of(sweep, points),
                          .warnings = warning_lines(sweep, points),
                          .provenance = provenance,
                          .run_id = run_id});
    file.add_text("swept_command", name_of(sweep.command));
    SweepWriter writer(file, sweep, points);
    writer.write_coordinates();
    writer.write_variables();
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("sweep.nc", error, "fewer points take less");
  }
}

}  // namespace bumpfoil
