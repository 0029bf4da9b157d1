#include "cycle_views.hpp"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "run.hpp"

namespace bumpfoil {
namespace {

namespace py = pybind11;

struct NamedField {
  const char* name;
  FieldMatrix FoilFields::*values;
};
constexpr auto displacements = std::to_array<NamedField>({{"top_displacement", &FoilFields::top_displacement},
                                                          {"crest_u", &FoilFields::crest_u},
                                                          {"crest_v", &FoilFields::crest_v},
                                                          {"foot_u", &FoilFields::foot_u},
                                                          {"foot_v", &FoilFields::foot_v},
                                                          {"compression", &FoilFields::compression},
                                                          {"top_slope", &FoilFields::top_slope},
                                                          {"top_parabola", &FoilFields::top_parabola},
                                                          {"crest_u_slope", &FoilFields::crest_u_slope},
                                                          {"crest_v_slope", &FoilFields::crest_v_slope},
                                                          {"foot_u_slope", &FoilFields::foot_u_slope},
                                                          {"foot_v_slope", &FoilFields::foot_v_slope},
                                                          {"crest_v_parabola", &FoilFields::crest_v_parabola},
                                                          {"crest_u_parabola", &FoilFields::crest_u_parabola},
                                                          {"foot_u_parabola", &FoilFields::foot_u_parabola},
                                                          {"foot_v_parabola", &FoilFields::foot_v_parabola},
                                                          {"pad_force_x", &FoilFields::pad_force_x},
                                                          {"pad_force_y", &FoilFields::pad_force_y},
                                                          {"strip_load", &FoilFields::strip_load}});

struct NamedInterface {
  const char* name;
  InterfaceFields FoilFields::*fields;
};
constexpr auto interfaces = std::to_array<NamedInterface>({{"journal_top", &FoilFields::journal_top},
                                                           {"top_bump", &FoilFields::top_bump},
                                                           {"bump_sleeve", &FoilFields::bump_sleeve}});

struct NamedStress {
  const char* name;
  FieldMatrix StressFields::*values;
};
constexpr auto stresses = std::to_array<NamedStress>({{"stress_top_foil", &StressFields::top_crest},
                                                      {"stress_bump_foil_crest", &StressFields::bump_crest},
                                                      {"stress_bump_foil_foot", &StressFields::bump_foot},
                                                      {"stress_bump_foil", &StressFields::bump_largest},
                                                      {"stress_top_foil_weld", &StressFields::top_weld},
                                                      {"stress_bump_foil_weld", &StressFields::bump_weld}});

/// The numbers of a result where they are. @param owner  of them, kept alive by the view
template <typename Number>
py::array view(const Number* numbers, const std::vector<py::ssize_t>& shape, const py::object& owner) {
  py::array array(py::dtype::of<Number>(), shape, numbers, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// Axes of views in addition to that of bumps or feet.
enum class Rows { all, single };

/// Leaves out quantities that a model does not have, which have no columns. The weld is a single place, but for several
/// pads: its axis falls away.
template <typename Matrix>
void add_view(py::dict& fields, const std::string& name, const Matrix& matrix, Rows rows, const py::object& owner) {
  if (matrix.cols() == 0) return;
  std::vector<py::ssize_t> shape;
  if (rows == Rows::all) shape.push_back(matrix.rows());
  if (!name.ends_with("_weld") || matrix.cols() > 1) shape.push_back(matrix.cols());
  using Number = std::conditional_t<std::is_enum_v<typename Matrix::Scalar>, std::uint8_t, double>;
  static_assert(sizeof(Number) == sizeof(typename Matrix::Scalar));
  fields[name.c_str()] = view(reinterpret_cast<const Number*>(matrix.data()), shape, owner);
}

py::dict field_views(const FoilFields& fields, Rows rows, const py::object& owner) {
  py::dict views;
  for (const NamedField& field : displacements) add_view(views, field.name, fields.*field.values, rows, owner);
  for (const auto& [name, member] : interfaces) {
    const InterfaceFields& interface = fields.*member;
    add_view(views, std::string("gap_") + name, interface.gap, rows, owner);
    add_view(views, std::string("normal_force_") + name, interface.normal_force, rows, owner);
    add_view(views, std::string("friction_force_") + name, interface.friction_force, rows, owner);
    add_view(views, std::string("state_") + name, interface.mode, rows, owner);
  }
  for (const NamedStress& stress : stresses) add_view(views, stress.name, fields.stress.*stress.values, rows, owner);
  return views;
}

/// As Python says it: flags by their words; NaN and None for what is not known.
py::object spelled(double value, const Form& form) {
  if (form.kind == Form::real) return py::float_(value);
  if (std::isnan(value)) return py::none();
  const auto whole = static_cast<long>(value);
  if (form.kind == Form::whole) return py::int_(whole);
  if (form.kind == Form::truth) return py::bool_(whole != 0);
  return py::str(std::string(form.words[static_cast<std::size_t>(whole)]));
}

/// An array of one quantity of many; whole numbers where it holds nothing else, flags as result.nc numbers them.
template <typename Item>
py::array array_of(const std::vector<Item>& items, double (*value)(const Item&), const Form& form) {
  std::vector<double> numbers(items.size());
  std::transform(items.begin(), items.end(), numbers.begin(), value);
  py::array array = py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
  const bool whole = std::none_of(numbers.begin(), numbers.end(), [](double number) { return std::isnan(number); });
  if (form.kind != Form::real && whole) array = array.attr("astype")("int64");
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::dict quantities_of(const Case& input, const CycleResult& result, std::size_t number) {
  const Cycle& cycle = result.cycles[number];
  py::dict quantities;
  if (result.experiment == Experiment::cycle) quantities["direction"] = to_degrees(cycle.direction);
  if (result.experiment == Experiment::strip) quantities["cycle"] = number + 1;
  for (const CycleQuantity& quantity : cycle_quantities(result.experiment, result.over_width)) {
    quantities[std::string(quantity.name).c_str()] = spelled(quantity.value(cycle, input), quantity.form);
  }
  if (result.experiment == Experiment::cycle) {
    const std::vector<VariableMeaning> clearances =
        clearance_quantities(input.settings.get<CycleSettings>().clearance_forces);
    for (std::size_t i = 0; i < clearances.size(); ++i) {
      quantities[clearances[i].name.c_str()] = spelled(clearance_of(cycle, i), clearances[i].form);
    }
  }
  for (const LoadQuantity& quantity : load_quantities(result.experiment)) {
    const Vector loads = quantity.value(cycle);
    if (loads.size() == 0) continue;
    py::array_t<double> array(loads.size(), loads.data());
    array.attr("setflags")(py::arg("write") = false);
    quantities[std::string(quantity.name).c_str()] = array;
  }
  return quantities;
}

}  // namespace

py::dict row_views(const FoilFields& fields, const py::object& owner) {
  return field_views(fields, Rows::single, owner);
}

py::list cycle_views(const py::object& run) {
  const auto& [input, result] = [&run] {
    const Run& held = run.cast<const Run&>();
    return std::pair<const Case&, const CycleResult*>(held.input, held.outcome.cycles.get());
  }();
  py::list cycles;
  if (result == nullptr) return cycles;
  for (std::size_t i = 0; i < result->cycles.size(); ++i) {
    const Cycle& cycle = result->cycles[i];
    py::dict series;
    for (const IncrementQuantity& quantity : increment_quantities(result->experiment, result->over_width)) {
      series[std::string(quantity.name).c_str()] = array_of(cycle.increments, quantity.value, quantity.form);
    }
    py::dict events;
    for (const EventQuantity& quantity : event_quantities()) {
      events[std::string(quantity.name).c_str()] = array_of(cycle.events, quantity.value, quantity.form);
    }
    py::dict views;
    views["quantities"] = quantities_of(input, *result, i);
    views["series"] = series;
    views["fields"] = field_views(cycle.fields, Rows::all, run);
    views["events"] = events;
    cycles.append(views);
  }
  return cycles;
}

}  // namespace bumpfoil
