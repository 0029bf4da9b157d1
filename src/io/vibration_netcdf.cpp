#include "io/vibration_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "bumpfoil/model/case_names.hpp"
#include "io/netcdf_provenance.hpp"
#include "io/netcdf_writer.hpp"
#include "io/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcDim;
using netCDF::NcVar;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// `value` of each entry of a list.
template <typename List, typename Value>
std::vector<double> each(const List& list, const Value& value) {
  std::vector<double> values;
  std::transform(list.begin(), list.end(), std::back_inserter(values), value);
  return values;
}

/// Puts vibrations into a file, variable by variable.
class VibrationWriter {
 public:
  VibrationWriter(NewNetcdf& file, const VibrationSettings& settings, const VibrationResult& result)
      : file_(file),
        settings_(settings),
        result_(result),
        load_(file.add_dim("load", settings.loads.size())),
        motion_(file.add_dim(settings.orbits() ? "sense" : "direction", settings.motions())),
        amplitude_(file.add_dim("amplitude", settings.amplitudes.size())),
        frequency_(file.add_dim("frequency", settings.frequencies.size())) {}

  void write_coordinates() {
    std::vector<double> numbers(settings_.loads.size());
    std::iota(numbers.begin(), numbers.end(), 1.0);
    file_.put_all({"load", "1", "static load, in the order of the case", {Form::whole}}, {load_}, numbers);
    file_.put_all({"load_x", "N", "static load, X"}, {load_},
                  each(settings_.loads, [](const auto& load) { return load.x(); }));
    file_.put_all({"load_y", "N", "static load, Y"}, {load_},
                  each(settings_.loads, [](const auto& load) { return load.y(); }));
    if (settings_.orbits()) {
      file_.put_all({"sense", "", "sense of the orbit, seen with X to the right and Y up", flags<Sense>}, {motion_},
                    std::vector<double>{0.0, 1.0});
    } else {
      file_.put_all({"direction", "degree", "direction of the vibration, from X towards Y"}, {motion_},
                    each(settings_.directions, to_degrees));
    }
    file_.put_all({"amplitude", "m", "displacement from the middle to a turning point"}, {amplitude_},
                  settings_.amplitudes);
    file_.put_all({"frequency", "rad/s", "angular frequency of the vibration"}, {frequency_}, settings_.frequencies);
  }

  void write_loads() {
    const auto put_loads = [this](const VariableMeaning& meaning, const auto& value) {
      put(meaning, {load_}, each(result_.loads, value));
    };
    put_loads({"load_status", "", "how the way to the static load ended", flags<Status>},
              [](const StaticLoad& load) { return static_cast<double>(load.status); });
    const auto reached = [](const StaticLoad& load, double value) {
      return load.status == Status::converged ? value : absent;
    };
    put_loads({"x", "m", "journal centre under the static load, X"},
              [&](const StaticLoad& load) { return reached(load, load.position.x()); });
    put_loads({"y", "m", "journal centre under the static load, Y"},
              [&](const StaticLoad& load) { return reached(load, load.position.y()); });
    for (const auto& [axes, row, column] : matrix_entries) {
      const auto entry = [i = row, j = column](const std::optional<Eigen::Matrix2d>& K) {
        return K ? (*K)(i, j) : absent;
      };
      put_loads({fmt::format("k{}_stuck", axes), "N/m", "tangent stiffness there, all closed contacts sticking"},
                [&](const StaticLoad& load) { return entry(load.tangents.unloading); });
      put_loads(
          {fmt::format("k{}_further", axes), "N/m", "tangent stiffness there, slipping contacts going on to slip"},
          [&](const StaticLoad& load) { return entry(load.tangents.loading); });
    }
  }

  void write_vibrations() {
    for (const VibrationQuantity& quantity : vibration_quantities()) {
      put({std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name), quantity.form},
          {load_, motion_, amplitude_}, each(result_.vibrations, quantity.value));
    }
  }

  void write_coefficients(const std::vector<LinearFoils>& all) {
    for (const auto& [axes, row, column] : matrix_entries) {
      const auto at = [i = row, j = column](const Eigen::Matrix2d& matrix) { return matrix(i, j); };
      put({fmt::format("k{}", axes), "N/m", fmt::format("stiffness dF_{}/d{}", axes[0], axes[1])}, {load_, amplitude_},
          each(all, [&](const LinearFoils& foils) { return at(foils.stiffness); }));
      std::vector<double> damping;
      for (const LinearFoils& foils : all) {
        for (const double frequency : settings_.frequencies) damping.push_back(at(foils.damping(frequency)));
      }
      put({fmt::format("c{}", axes), "N s/m", fmt::format("damping dF_{}/d(d{}/dt)", axes[0], axes[1])},
          {load_, amplitude_, frequency_}, std::move(damping));
    }
    for (const LinearQuantity& quantity : linear_quantities()) {
      put({std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name)},
          {load_, amplitude_}, each(all, quantity.value));
    }
  }

  /// The last loop of each vibration, linear between its points.
  void write_loops() {
    std::size_t longest = 1;
    for (const Vibration& vibration : result_.vibrations) longest = std::max(longest, vibration.cycle.curve.size());
    const NcDim point = file_.add_dim("point", longest);
    const auto put_loops = [&](const VariableMeaning& meaning, const auto& value) {
      std::vector<double> values;
      for (const Vibration& vibration : result_.vibrations) {
        for (const LoopPoint& one : vibration.cycle.curve) values.push_back(value(one));
        values.resize(values.size() + longest - vibration.cycle.curve.size(), absent);
      }
      return put(meaning, {load_, motion_, amplitude_, point}, std::move(values));
    };
    put_loops({"displacement", "m",
               "displacement of the journal along the direction, of an orbit along X, from the centre of the bearing"},
              [](const LoopPoint& one) { return one.displacement; });
    put_loops({"force_x", "N", "force that holds the journal, X"}, [](const LoopPoint& one) {
      return one.force.x();
    }).putAtt("coordinates", "displacement");
    put_loops({"force_y", "N", "force that holds the journal, Y"}, [](const LoopPoint& one) {
      return one.force.y();
    }).putAtt("coordinates", "displacement");
  }

 private:
  NcVar put(const VariableMeaning& meaning, const NewNetcdf::Dims& dims, std::vector<double> values) {
    const NcVar variable = file_.add(meaning, dims);
    std::vector<std::size_t> count;
    for (const NcDim& dim : dims) count.push_back(dim.getSize());
    NewNetcdf::put(variable, std::vector<std::size_t>(dims.size()), count, std::move(values));
    return variable;
  }

  NewNetcdf& file_;
  const VibrationSettings& settings_;
  const VibrationResult& result_;
  NcDim load_, motion_, amplitude_, frequency_;
};

}  // namespace

std::string vibration_netcdf(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                             RunStatus status, const Provenance& provenance, std::string_view run_id) {
  try {
    NewNetcdf file;
    std::vector<std::string> messages = failure_lines(*input.vibration, result);
    if (status == RunStatus::interrupted) messages.emplace_back("the run was interrupted by the user or the system");
    add_provenance(file, {.input = input,
                          .command = "vibration",
                          .status = status,
                          .message = fmt::format("{}", fmt::join(messages, "; ")),
                          .warnings = warning_lines(*input.vibration, result),
                          .provenance = provenance,
                          .run_id = run_id});
    VibrationWriter writer(file, *input.vibration, result);
    writer.write_coordinates();
    writer.write_loads();
    writer.write_vibrations();
    writer.write_coefficients(all);
    writer.write_loops();
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("result.nc", error, "fewer steps, loads or amplitudes take less");
  }
}

}  // namespace bumpfoil
