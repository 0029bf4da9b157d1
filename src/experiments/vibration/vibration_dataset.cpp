#include "experiments/vibration/vibration_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

/// Describes vibrations, one variable at a time.
class VibrationDataset {
 public:
  VibrationDataset(const Case& input, const VibrationResult& result)
      : settings_(input.settings.get<VibrationSettings>()),
        pads_(count_pads(input) > 1 ? count_pads(input) : 0),
        result_(result),
        motion_(motion_dimension(settings_)) {
    add_coordinates();
  }

  void add_loads() {
    const auto add_load = [this](const VariableMeaning& meaning, const auto& value) {
      data_.add(meaning, {"load"}, each(result_.loads, value));
    };
    add_load({"load_status", "", "how the ramp to the static load ended", flags<Status>},
             [](const StaticLoad& load) { return static_cast<double>(load.status); });
    const auto reached = [](const StaticLoad& load, double value) {
      return load.status == Status::converged ? value : absent;
    };
    add_load({"x", "m", "journal centre under the static load, X"},
             [&](const StaticLoad& load) { return reached(load, load.position.x()); });
    add_load({"y", "m", "journal centre under the static load, Y"},
             [&](const StaticLoad& load) { return reached(load, load.position.y()); });
    for (const auto& [axes, row, column] : matrix_entries) {
      const auto entry = [i = row, j = column](const std::optional<Eigen::Matrix2d>& K) {
        return K ? (*K)(i, j) : absent;
      };
      add_load({fmt::format("k{}_stuck", axes), "N/m", "tangent stiffness under the static load, full stick"},
               [&](const StaticLoad& load) { return entry(load.tangents.unloading); });
      add_load({fmt::format("k{}_further", axes), "N/m",
                "tangent stiffness under the static load, sliding contacts keep sliding"},
               [&](const StaticLoad& load) { return entry(load.tangents.loading); });
    }
  }

  void add_vibrations() {
    for (const VibrationQuantity& quantity : vibration_quantities()) {
      data_.add(quantity.meaning(), {"load", motion_, "amplitude"}, each(result_.vibrations, quantity.value));
    }
  }

  void add_coefficients(const std::vector<LinearFoils>& all) {
    for (const auto& [axes, row, column] : matrix_entries) {
      const auto at = [i = row, j = column](const Eigen::Matrix2d& matrix) { return matrix(i, j); };
      data_.add({fmt::format("k{}", axes), "N/m", fmt::format("stiffness dF_{}/d{}", axes[0], axes[1])},
                {"load", "amplitude"}, each(all, [&](const LinearFoils& foils) { return at(foils.stiffness); }));
      std::vector<double> damping;
      damping.reserve(all.size() * settings_.frequencies.size());
      for (const LinearFoils& foils : all) {
        for (const double frequency : settings_.frequencies) damping.push_back(at(foils.damping(frequency)));
      }
      data_.add({fmt::format("c{}", axes), "N s/m", fmt::format("damping dF_{}/d(d{}/dt)", axes[0], axes[1])},
                {"load", "amplitude", "frequency"}, std::move(damping));
    }
    for (const LinearQuantity& quantity : linear_quantities()) {
      data_.add(quantity.meaning(), {"load", "amplitude"}, each(all, quantity.value));
    }
  }

  /// Forces on each of several pads.
  void add_pads() {
    if (pads_ == 0) return;
    for (const auto& [axis, name] : {std::pair{0, "x"}, std::pair{1, "y"}}) {
      data_.add({fmt::format("load_pad_force_{}", name), "N", fmt::format("part of load_{} carried by the pad", name)},
                {"load", "pad"}, padded_rows(result_.loads.size(), pads_, [&, axis = axis](std::size_t i) {
                  return Eigen::RowVectorXd(result_.loads[i].pad_forces.row(axis));
                }));
    }
    data_.add({"max_pad_forces", "N", "maximum magnitude of the pad force in the last loop"},
              {"load", motion_, "amplitude", "pad"}, padded_rows(result_.vibrations.size(), pads_, [&](std::size_t i) {
                return largest_pad_forces(result_.vibrations[i]);
              }));
  }

  /// The last loop of each vibration, linear between its points.
  void add_loops() {
    std::size_t longest = 1;
    for (const Vibration& vibration : result_.vibrations) longest = std::max(longest, vibration.cycle.curve.size());
    data_.dims.push_back({"point", longest});
    const auto add_loop = [&](const VariableMeaning& meaning, const std::string& coordinates, const auto& value) {
      data_
          .add(meaning, {"load", motion_, "amplitude", "point"},
               padded_rows(result_.vibrations.size(), longest,
                           [&](std::size_t i) { return each(result_.vibrations[i].cycle.curve, value); }))
          .attributes["coordinates"] = coordinates;
    };
    add_loop({"displacement", "m",
              "displacement of the journal along the direction (for an orbit along X) from the centre of the bearing"},
             "", [](const LoopPoint& one) { return one.displacement; });
    add_loop({"force_x", "N", "applied force on the journal, X"}, "displacement",
             [](const LoopPoint& one) { return one.force.x(); });
    add_loop({"force_y", "N", "applied force on the journal, Y"}, "displacement",
             [](const LoopPoint& one) { return one.force.y(); });
    if (pads_ > 0) add_pad_loops(longest);
  }

  Dataset take() { return std::move(data_); }

 private:
  void add_pad_loops(std::size_t longest) {
    for (const auto& [axis, name] : {std::pair{0, "x"}, std::pair{1, "y"}}) {
      data_
          .add({fmt::format("pad_force_{}", name), "N", fmt::format("part of force_{} carried by the pad", name)},
               {"load", motion_, "amplitude", "point", "pad"},
               padded_rows(result_.vibrations.size(), longest * pads_,
                           [&, axis = axis](std::size_t i) {
                             std::vector<double> values;
                             for (const LoopPoint& one : result_.vibrations[i].cycle.curve) {
                               const Eigen::RowVectorXd forces = one.pad_forces.row(axis);
                               values.insert(values.end(), forces.begin(), forces.end());
                             }
                             return values;
                           }))
          .attributes["coordinates"] = "displacement";
    }
  }

  void add_coordinates() {
    data_.add_dimension({"load", "1", "static load, in the order of the case", {Form::whole}},
                        numbers_from(1.0, settings_.loads.size()));
    data_.add_coordinate({"load_x", "N", "static load, X", {}, "load X", shown::newtons}, {"load"},
                         each(settings_.loads, [](const auto& load) { return load.x(); }));
    data_.add_coordinate({"load_y", "N", "static load, Y", {}, "load Y", shown::newtons}, {"load"},
                         each(settings_.loads, [](const auto& load) { return load.y(); }));
    if (settings_.orbits()) {
      data_.add_dimension({"sense", "", "sense of the orbit, seen with X to the right and Y up", flags<Sense>, "sense",
                           shown::unitless},
                          {0.0, 1.0});
    } else {
      data_.add_dimension(
          {"direction", "degree", "direction of the vibration, from X towards Y", {}, "direction", shown::degrees},
          each(settings_.directions, to_degrees));
    }
    data_.add_dimension(
        {"amplitude", "m", "displacement from the middle to a turning point", {}, "amplitude", shown::micrometres},
        settings_.amplitudes);
    data_.add_dimension({"frequency", "rad/s", "angular frequency of the vibration"}, settings_.frequencies);
    if (pads_ > 0) {
      data_.add_dimension({"pad", "1", "pad, in the order of the case", {Form::whole}}, numbers_from(1.0, pads_));
    }
  }

  const VibrationSettings& settings_;
  std::size_t pads_;  ///< number of pads; 0 for a single one
  const VibrationResult& result_;
  std::string motion_;
  Dataset data_;
};

}  // namespace

Dataset vibration_dataset(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                          bool with_loops) {
  VibrationDataset data(input, result);
  data.add_loads();
  data.add_vibrations();
  data.add_coefficients(all);
  data.add_pads();
  if (with_loops) data.add_loops();
  return data.take();
}

}  // namespace bumpfoil
