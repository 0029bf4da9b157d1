#include "experiments/vibration/vibration_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

/// What tables of sweeps show.
constexpr std::array<std::string_view, 4> headlines{"stiffness_direct", "loss_stiffness_direct", "harmonic_residual",
                                                    "loss_factor"};

/// `value` of each entry of a list.
template <typename List, typename Value>
std::vector<double> each(const List& list, const Value& value) {
  std::vector<double> values;
  std::transform(list.begin(), list.end(), std::back_inserter(values), value);
  return values;
}

/// Describes vibrations, variable by variable.
class VibrationGrid {
 public:
  VibrationGrid(const Case& input, const VibrationResult& result)
      : settings_(*input.vibration),
        pads_(count_pads(input) > 1 ? count_pads(input) : 0),
        result_(result),
        motion_(settings_.orbits() ? "sense" : "direction") {
    grid_.dims = {{"load", settings_.loads.size()},
                  {motion_, settings_.motions()},
                  {"amplitude", settings_.amplitudes.size()},
                  {"frequency", settings_.frequencies.size()}};
    if (pads_ > 0) grid_.dims.push_back({"pad", pads_});
    add_coordinates();
  }

  void add_loads() {
    const auto add_load = [this](const VariableMeaning& meaning, const auto& value) {
      add(meaning, {"load"}, each(result_.loads, value));
    };
    add_load({"load_status", "", "how the way to the static load ended", flags<Status>},
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
      add_load({fmt::format("k{}_stuck", axes), "N/m", "tangent stiffness there, all closed contacts sticking"},
               [&](const StaticLoad& load) { return entry(load.tangents.unloading); });
      add_load({fmt::format("k{}_further", axes), "N/m", "tangent stiffness there, slipping contacts going on to slip"},
               [&](const StaticLoad& load) { return entry(load.tangents.loading); });
    }
  }

  void add_vibrations() {
    for (const VibrationQuantity& quantity : vibration_quantities()) {
      GridVariable& variable =
          add({std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name), quantity.form},
              {"load", motion_, "amplitude"}, each(result_.vibrations, quantity.value));
      if (std::find(headlines.begin(), headlines.end(), quantity.name) == headlines.end()) continue;
      variable.heading = quantity.label;
      variable.shown = quantity.shown;
    }
  }

  void add_coefficients(const std::vector<LinearFoils>& all) {
    for (const auto& [axes, row, column] : matrix_entries) {
      const auto at = [i = row, j = column](const Eigen::Matrix2d& matrix) { return matrix(i, j); };
      add({fmt::format("k{}", axes), "N/m", fmt::format("stiffness dF_{}/d{}", axes[0], axes[1])},
          {"load", "amplitude"}, each(all, [&](const LinearFoils& foils) { return at(foils.stiffness); }));
      std::vector<double> damping;
      damping.reserve(all.size() * settings_.frequencies.size());
      for (const LinearFoils& foils : all) {
        for (const double frequency : settings_.frequencies) damping.push_back(at(foils.damping(frequency)));
      }
      add({fmt::format("c{}", axes), "N s/m", fmt::format("damping dF_{}/d(d{}/dt)", axes[0], axes[1])},
          {"load", "amplitude", "frequency"}, std::move(damping));
    }
    for (const LinearQuantity& quantity : linear_quantities()) {
      add({std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name)},
          {"load", "amplitude"}, each(all, quantity.value));
    }
  }

  /// What each of several pads takes.
  void add_pads() {
    if (pads_ == 0) return;
    for (const auto& [axis, name] : {std::pair{0, "x"}, std::pair{1, "y"}}) {
      std::vector<double> values;
      for (const StaticLoad& load : result_.loads) {
        const Eigen::RowVectorXd forces = load.pad_forces.row(axis);
        values.insert(values.end(), forces.begin(), forces.end());
        values.resize(values.size() + pads_ - static_cast<std::size_t>(forces.size()), absent);
      }
      add({fmt::format("load_pad_force_{}", name), "N", fmt::format("part of load_{} that the pad takes", name)},
          {"load", "pad"}, std::move(values));
    }
    std::vector<double> largest;
    for (const Vibration& vibration : result_.vibrations) {
      const Vector forces = largest_pad_forces(vibration);
      largest.insert(largest.end(), forces.begin(), forces.end());
      largest.resize(largest.size() + pads_ - static_cast<std::size_t>(forces.size()), absent);
    }
    add({"max_pad_forces", "N", "largest size of the force that the pad takes in the last loop"},
        {"load", motion_, "amplitude", "pad"}, std::move(largest));
  }

  /// The last loop of each vibration, linear between its points.
  void add_loops() {
    std::size_t longest = 1;
    for (const Vibration& vibration : result_.vibrations) longest = std::max(longest, vibration.cycle.curve.size());
    grid_.dims.push_back({"point", longest});
    const auto add_loop = [&](const VariableMeaning& meaning, const std::string& coordinates, const auto& value) {
      std::vector<double> values;
      for (const Vibration& vibration : result_.vibrations) {
        for (const LoopPoint& one : vibration.cycle.curve) values.push_back(value(one));
        values.resize(values.size() + longest - vibration.cycle.curve.size(), absent);
      }
      add(meaning, {"load", motion_, "amplitude", "point"}, std::move(values)).coordinates = coordinates;
    };
    add_loop({"displacement", "m",
              "displacement of the journal along the direction, of an orbit along X, from the centre of the bearing"},
             "", [](const LoopPoint& one) { return one.displacement; });
    add_loop({"force_x", "N", "force that holds the journal, X"}, "displacement",
             [](const LoopPoint& one) { return one.force.x(); });
    add_loop({"force_y", "N", "force that holds the journal, Y"}, "displacement",
             [](const LoopPoint& one) { return one.force.y(); });
    if (pads_ > 0) add_pad_loops(longest);
  }

  ResultGrid take() { return std::move(grid_); }

 private:
  void add_pad_loops(std::size_t longest) {
    for (const auto& [axis, name] : {std::pair{0, "x"}, std::pair{1, "y"}}) {
      std::vector<double> values;
      for (const Vibration& vibration : result_.vibrations) {
        for (const LoopPoint& one : vibration.cycle.curve) {
          const Eigen::RowVectorXd forces = one.pad_forces.row(axis);
          values.insert(values.end(), forces.begin(), forces.end());
        }
        values.resize(values.size() + (longest - vibration.cycle.curve.size()) * pads_, absent);
      }
      add({fmt::format("pad_force_{}", name), "N", fmt::format("part of force_{} that the pad takes", name)},
          {"load", motion_, "amplitude", "point", "pad"}, std::move(values))
          .coordinates = "displacement";
    }
  }

  void add_coordinates() {
    const auto add_coordinate = [this](const VariableMeaning& meaning, const std::string& dim,
                                       std::vector<double> values) {
      grid_.coordinates.push_back({meaning, {dim}, std::move(values)});
    };
    add_coordinate({"load", "1", "static load, in the order of the case", {Form::whole}}, "load",
                   numbers_from(1.0, settings_.loads.size()));
    add_coordinate({"load_x", "N", "static load, X"}, "load",
                   each(settings_.loads, [](const auto& load) { return load.x(); }));
    add_coordinate({"load_y", "N", "static load, Y"}, "load",
                   each(settings_.loads, [](const auto& load) { return load.y(); }));
    if (settings_.orbits()) {
      add_coordinate({"sense", "", "sense of the orbit, seen with X to the right and Y up", flags<Sense>}, motion_,
                     {0.0, 1.0});
    } else {
      add_coordinate({"direction", "degree", "direction of the vibration, from X towards Y"}, motion_,
                     each(settings_.directions, to_degrees));
    }
    add_coordinate({"amplitude", "m", "displacement from the middle to a turning point"}, "amplitude",
                   settings_.amplitudes);
    add_coordinate({"frequency", "rad/s", "angular frequency of the vibration"}, "frequency", settings_.frequencies);
    if (pads_ > 0) {
      add_coordinate({"pad", "1", "pad, in the order of the case", {Form::whole}}, "pad", numbers_from(1.0, pads_));
    }
  }

  GridVariable& add(VariableMeaning meaning, std::vector<std::string> dims, std::vector<double> values) {
    return grid_.variables.emplace_back(GridVariable{std::move(meaning), std::move(dims), std::move(values)});
  }

  const VibrationSettings& settings_;
  std::size_t pads_;  ///< of several; none of one
  const VibrationResult& result_;
  std::string motion_;
  ResultGrid grid_;
};

}  // namespace

ResultGrid vibration_grid(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                          bool with_loops) {
  VibrationGrid grid(input, result);
  grid.add_loads();
  grid.add_vibrations();
  grid.add_coefficients(all);
  grid.add_pads();
  if (with_loops) grid.add_loops();
  return grid.take();
}

VibrationResult vibrations_not_begun(const VibrationSettings& settings) {
  VibrationResult result;
  for (const Eigen::Vector2d& load : settings.loads) {
    result.loads.push_back({.load = load, .status = Status::interrupted, .position = {0.0, 0.0}, .tangents = {}});
  }
  result.vibrations.resize(settings.loads.size() * settings.motions() * settings.amplitudes.size());
  for (Vibration& vibration : result.vibrations) vibration.cycle.status = Status::interrupted;
  return result;
}

}  // namespace bumpfoil
