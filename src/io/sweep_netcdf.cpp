#include "io/sweep_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/io/sweep_table.hpp"
#include "io/netcdf_provenance.hpp"
#include "io/netcdf_writer.hpp"
#include "io/sweep_values.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcDim;
using netCDF::NcVar;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// Puts a sweep into a file, variable by variable.
class SweepWriter {
 public:
  SweepWriter(NewNetcdf& file, const Sweep& sweep, const std::vector<SweepPoint>& points)
      : file_(file),
        sweep_(sweep),
        points_(points),
        wording_(wording_of(sweep.cases.front(), sweep.experiment)),
        layout_(layout_of(sweep)) {
    for (const SweepAxis& axis : sweep.axes) dims_.push_back(file.add_dim(axis.name, axis.values.size()));
    dims_.push_back(file.add_dim(cycles().name, cycles().values.size()));
  }

  void write_coordinates() {
    for (std::size_t i = 0; i < sweep_.axes.size(); ++i) {
      const SweepAxis& axis = sweep_.axes[i];
      file_.put_all({axis.name, axis.unit, axis.title}, {dims_[i]}, axis.values).putAtt("case_key", axis.swept.key);
    }
    file_.put_all({cycles().name, cycles().unit, cycles().long_name}, {dims_.back()}, cycles().values);
  }

  void write_quantities() {
    for (const CycleQuantity& quantity : cycle_quantities(sweep_.experiment)) {
      std::vector<double> values(points_.size() * layout_.places.size());
      for (std::size_t point = 0; point < points_.size(); ++point) {
        for (std::size_t cycle = 0; cycle < layout_.places.size(); ++cycle) {
          values[row(point, cycle)] = value_at(quantity, sweep_.cases[point], points_[point], cycle);
        }
      }
      put({std::string(quantity.name), std::string(quantity.unit), spelled(quantity.long_name, wording_),
           quantity.form},
          dims_, std::move(values));
    }
  }

  /// Displacements at which thresholds of the force are reached.
  void write_clearances() {
    const std::vector<double>& forces = sweep_.cases.front().cycle.clearance_forces;
    if (sweep_.experiment == Experiment::strip || forces.empty()) return;
    const NcDim threshold = file_.add_dim("clearance_force", forces.size());
    file_.put_all({"clearance_force", "N", "force at which a push test would take the journal for touching"},
                  {threshold}, forces);
    put({"clearance", "m", "displacement at which the direct force first reaches the threshold"}, inside(threshold),
        blocks(forces.size(), [](const SweepPoint& point, std::size_t cycle) {
          std::vector<double> found;
          for (const Clearance& clearance : point.result.cycles[cycle].clearances) {
            found.push_back(clearance.displacement.value_or(absent));
          }
          return found;
        }));
  }

  void write_loops() {
    const NcDim increment = file_.add_dim("increment", layout_.increments);
    std::vector<double> numbers(increment.getSize());
    std::iota(numbers.begin(), numbers.end(), 0.0);
    file_.put_all({"increment", "1", "increment; 0 is the start of the cycle", {Form::whole}}, {increment}, numbers);
    for (const IncrementQuantity& quantity : increment_quantities(sweep_.experiment)) {
      const bool displacement = quantity.name == "displacement";
      if (!displacement && quantity.name != "force_direct") continue;
      const auto values = displacement ? &Loop::displacement : &Loop::force_direct;
      const NcVar variable =
          put({std::string(quantity.name), std::string(quantity.unit), spelled(quantity.long_name, wording_)},
              inside(increment), blocks(increment.getSize(), [values](const SweepPoint& point, std::size_t cycle) {
                return cycle < point.loops.size() ? point.loops[cycle].*values : std::vector<double>{};
              }));
      if (!displacement) variable.putAtt("coordinates", "displacement");
    }
  }

 private:
  [[nodiscard]] const NamedNumbers& cycles() const { return layout_.cycles; }

  /// Where the file holds a cycle of a point.
  [[nodiscard]] std::size_t row(std::size_t point, std::size_t cycle) const {
    return point * layout_.places.size() + layout_.places[cycle];
  }

  /// All dimensions, and one more.
  [[nodiscard]] NewNetcdf::Dims inside(const NcDim& last) const {
    NewNetcdf::Dims dims = dims_;
    dims.push_back(last);
    return dims;
  }

  /// Numbers of every cycle of every point, so many of each; what is missing is absent.
  /// @param numbers_of  (point, cycle that was begun) -> numbers
  template <typename NumbersOf>
  [[nodiscard]] std::vector<double> blocks(std::size_t size, const NumbersOf& numbers_of) const {
    std::vector<double> all(points_.size() * layout_.places.size() * size, absent);
    for (std::size_t point = 0; point < points_.size(); ++point) {
      for (std::size_t cycle = 0; cycle < points_[point].result.cycles.size(); ++cycle) {
        const std::vector<double> numbers = numbers_of(points_[point], cycle);
        BUMPFOIL_ASSERT(numbers.size() <= size);
        std::copy(numbers.begin(), numbers.end(), all.begin() + static_cast<std::ptrdiff_t>(row(point, cycle) * size));
      }
    }
    return all;
  }

  NcVar put(const VariableMeaning& meaning, const NewNetcdf::Dims& dims, std::vector<double> values) {
    const NcVar variable = file_.add(meaning, dims);
    std::vector<std::size_t> extents;
    for (const NcDim& dim : dims) extents.push_back(dim.getSize());
    NewNetcdf::put(variable, std::vector<std::size_t>(dims.size(), 0), extents, std::move(values));
    return variable;
  }

  NewNetcdf& file_;
  const Sweep& sweep_;
  const std::vector<SweepPoint>& points_;
  Wording wording_;
  ResultLayout layout_;
  NewNetcdf::Dims dims_;  ///< of the keys, and of the cycles
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
    file.add_text("swept_command", name_of(sweep.experiment));
    SweepWriter writer(file, sweep, points);
    writer.write_coordinates();
    writer.write_quantities();
    writer.write_clearances();
    if (keeps_loops(sweep)) writer.write_loops();
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("sweep.nc", error, "fewer points take less");
  }
}

}  // namespace bumpfoil
