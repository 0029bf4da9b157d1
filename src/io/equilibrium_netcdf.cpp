#include "io/equilibrium_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "bumpfoil/analysis/film_fields.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/equilibrium_files.hpp"
#include "bumpfoil/io/equilibrium_quantities.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "io/netcdf_provenance.hpp"
#include "io/netcdf_writer.hpp"
#include "io/result_layout.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcDim;
using netCDF::NcVar;

std::vector<double> to_vector(const Vector& numbers) {
  return {numbers.begin(), numbers.end()};
}

class EquilibriumWriter {
 public:
  EquilibriumWriter(NewNetcdf& file, const Case& input, const EquilibriumResult& result)
      : file_(file),
        input_(input),
        result_(result),
        mesh_(result.bearing->foil.mesh),
        layout_(make_result_layout(input, Experiment::cycle)),
        wording_(wording_of(input, Experiment::cycle)),
        state_(file.add_dim("state", result.states.size())),
        row_(file.add_dim("row", static_cast<std::size_t>(mesh_.rows) + 1)),
        column_(file.add_dim("column", static_cast<std::size_t>(mesh_.nodes()))),
        bump_(file.add_dim("bump", layout_.bumps)),
        foot_(file.add_dim("foot", layout_.feet)) {}

  void write_geometry() {
    constexpr Form whole{Form::whole};
    const auto count = [&](const std::string& name, const std::string& meaning, const NcDim& dim) {
      std::vector<double> numbers(dim.getSize());
      std::iota(numbers.begin(), numbers.end(), 1.0);
      file_.put_all({name, "1", meaning, whole}, {dim}, numbers);
    };
    count("state", "state of the running bearing, in the order in which they were looked for", state_);
    count("bump", "bump, counted from the weld", bump_);
    count("foot", "foot of the bump foil on the sleeve, counted from the weld", foot_);
    const Vector theta = mesh_.angles();
    file_.put_all({"column_theta", "rad", "angle of the column from the weld along the foil"}, {column_},
                  to_vector(theta));
    file_.put_all({"column_phi", "rad", "polar angle of the column from X towards Y"}, {column_},
                  to_vector(polar_angles(input_.bearing, theta)));
    file_.put_all({"z", "m", "distance of the row from the mid-plane of the bearing; the last row is its side"}, {row_},
                  to_vector(Vector::LinSpaced(mesh_.rows + 1, 0.0, 0.5 * input_.bearing.axial_length)));
    for (const NamedNumbers& scalar : layout_.scalars) put(scalar, {});
    for (const NamedNumbers& numbers : layout_.at_bumps) put(numbers, {bump_});
    for (const NamedNumbers& numbers : layout_.at_feet) put(numbers, {foot_});
    const Gas& gas = result_.bearing->scales.gas;
    put({"gas_viscosity", "Pa s", "viscosity of the gas", {gas.viscosity}}, {});
    put({"ambient_pressure", "Pa", "pressure at the edges of the film and behind the foils", {gas.ambient_pressure}},
        {});
  }

  void write_quantities() {
    for (const RunningQuantity& quantity : running_quantities(*result_.bearing)) {
      std::vector<double> values;
      for (const RunningState& state : result_.states) values.push_back(value_of(quantity, *result_.bearing, state));
      const NcVar variable = file_.add(meaning(quantity, quantity.form), {state_});
      if (!values.empty()) NewNetcdf::put(variable, {0}, {values.size()}, values);
    }
    const NcVar x = file_.add({"position_x", "m", "position of the journal that was asked for, X"}, {state_});
    const NcVar y = file_.add({"position_y", "m", "position of the journal that was asked for, Y"}, {state_});
    for (std::size_t i = 0; i < result_.states.size(); ++i) {
      const OperatingPoint& asked = result_.states[i].asked;
      if (asked.control != OperatingPoint::Control::position) continue;
      NewNetcdf::put(x, {i}, {1}, {asked.journal.x()});
      NewNetcdf::put(y, {i}, {1}, {asked.journal.y()});
    }
  }

  void write_film() {
    put_nodes({"pressure", "Pa", "pressure of the film"}, film_pressure);
    if (!result_.foils) return write_thickness();
    for (const ColumnQuantity& quantity : column_quantities()) {
      const NcVar variable = file_.add(meaning(quantity), {state_, column_});
      variable.putAtt("coordinates", "column_theta column_phi");
      compress(variable);
      for_each_found([&](std::size_t i, const FilmBearingState& state) {
        NewNetcdf::put(variable, {i, 0}, {1, column_.getSize()}, to_vector(quantity.values(*result_.bearing, state)));
      });
    }
  }

  /// What is known of the foils without a film, too, but for the contact with the journal, which there is none of.
  void write_foils() {
    const Foils& foils = *result_.foils;
    FoilFields fields = make_fields(foils, static_cast<int>(result_.states.size()));
    for_each_found([&](std::size_t i, const FilmBearingState& state) {
      record(foils, foil_state(foils, *result_.bearing, state), static_cast<Eigen::Index>(i), fields);
    });
    for (const FieldQuantity& quantity : field_quantities()) {
      if (quantity.name.ends_with("journal_top")) continue;
      const FieldMatrix values = quantity.values(fields);
      if (values.cols() == 0) continue;
      NewNetcdf::Dims dims{state_};
      const bool of_all = quantity.node == Node::foil || quantity.node == Node::weld;
      if (!of_all) dims.push_back(quantity.node == Node::foot ? foot_ : bump_);
      const NcVar variable = file_.add({std::string(quantity.name), std::string(quantity.unit),
                                        spelled(quantity.long_name, wording_), quantity.form},
                                       dims);
      if (!of_all) {
        variable.putAtt("coordinates",
                        quantity.node == Node::foot ? layout_.foot_coordinates : layout_.bump_coordinates);
      }
      for_each_found([&](std::size_t i, const FilmBearingState&) {
        std::vector<std::size_t> start{i};
        std::vector<std::size_t> count{1};
        if (dims.size() > 1) {
          start.push_back(0);
          count.push_back(static_cast<std::size_t>(values.cols()));
        }
        const auto row = values.row(static_cast<Eigen::Index>(i));
        NewNetcdf::put(variable, start, count, {row.begin(), row.end()});
      });
    }
  }

 private:
  template <typename Quantity>
  [[nodiscard]] static VariableMeaning meaning(const Quantity& quantity, const Form& form = {}) {
    return {std::string(quantity.name), std::string(quantity.unit), std::string(quantity.long_name), form};
  }

  /// Values at all nodes of every state.
  template <typename Values>
  void put_nodes(const VariableMeaning& nodes, Values&& values_of) {
    const NcVar variable = file_.add(nodes, {state_, row_, column_});
    compress(variable);
    for_each_found([&](std::size_t i, const FilmBearingState& state) {
      const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows =
          values_of(*result_.bearing, state);
      NewNetcdf::put(variable, {i, 0, 0}, {1, row_.getSize(), column_.getSize()},
                     {rows.data(), rows.data() + rows.size()});
    });
  }

  /// Over a wall that yields it is not the same over the width.
  void write_thickness() {
    put_nodes({"film_thickness", "m", "film thickness"},
              [](const FilmBearing& bearing, const FilmBearingState& state) -> Matrix {
                return bearing.scales.thickness * state.foil.film.thickness;
              });
  }

  template <typename Visitor>
  void for_each_found(Visitor&& visit) const {
    for (std::size_t i = 0; i < result_.states.size(); ++i) {
      if (result_.states[i].found()) visit(i, *result_.states[i].last);
    }
  }

  void put(const NamedNumbers& numbers, const NewNetcdf::Dims& dims) {
    file_.put_all({numbers.name, numbers.unit, numbers.long_name}, dims, numbers.values);
  }

  static void compress(const NcVar& variable) { variable.setCompression(true, true, 1); }

  NewNetcdf& file_;
  const Case& input_;
  const EquilibriumResult& result_;
  const FilmMesh& mesh_;
  ResultLayout layout_;
  Wording wording_;
  NcDim state_, row_, column_, bump_, foot_;
};

}  // namespace

std::string equilibrium_netcdf(const Case& input, const EquilibriumResult& result, RunStatus status,
                               const Provenance& provenance, std::string_view run_id) {
  std::vector<std::string> messages = failure_lines(result);
  if (status == RunStatus::interrupted) messages.emplace_back("the run was interrupted by the user or the system");
  try {
    NewNetcdf file;
    add_provenance(file, {.input = input,
                          .command = command_of(result),
                          .status = status,
                          .message = fmt::format("{}", fmt::join(messages, "; ")),
                          .warnings = warning_lines(input, result),
                          .provenance = provenance,
                          .run_id = run_id});
    EquilibriumWriter writer(file, input, result);
    writer.write_geometry();
    writer.write_quantities();
    writer.write_film();
    if (result.foils) writer.write_foils();
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("result.nc", error, "fewer states or a coarser mesh take less");
  }
}

}  // namespace bumpfoil
