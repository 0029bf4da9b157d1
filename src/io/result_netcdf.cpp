#include "bumpfoil/io/result_netcdf.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <netcdf>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/io/case_writer.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "io/netcdf_writer.hpp"
#include "io/result_columns.hpp"
#include "io/result_layout.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcDim;
using netCDF::NcGroup;
using netCDF::NcVar;

double finite_or_absent(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? *number : Storage<double>::absent;
}

/// Meanings of flags: of 0, 1, 2, ..., in the order of the enumerations.
constexpr std::string_view mode_meanings = "open stick slip_forward slip_backward";
constexpr std::string_view branch_meanings = "loading unloading";
constexpr std::string_view interface_meanings = "journal_top top_bump bump_sleeve";
constexpr std::string_view truth_meanings = "no yes";

struct NodalField {
  std::string_view name;
  std::string_view long_name;
  Vector Increment::*values;
  bool at_feet;
};
constexpr std::array<NodalField, 5> nodal_fields{{
    {"top_displacement", "radial displacement of the top foil over the bump, positive outward",
     &Increment::top_displacement, false},
    {"crest_u", "tangential displacement of the crest, positive away from the weld", &Increment::crest_u, false},
    {"crest_v", "radial displacement of the crest, positive outward", &Increment::crest_v, false},
    {"foot_u", "tangential displacement of the foot, positive away from the weld", &Increment::foot_u, true},
    {"foot_v", "radial displacement of the foot, positive outward", &Increment::foot_v, true},
}};

struct StressField {
  std::string_view name;
  std::string_view long_name;
  Vector FoilStress::*values;
  bool at_feet;
};
constexpr std::array<StressField, 4> stress_fields{{
    {"stress_top_foil", "bending stress of the top foil over the crest", &FoilStress::top_crest, false},
    {"stress_bump_foil_crest", "bending stress of the bump foil at the crest", &FoilStress::bump_crest, false},
    {"stress_bump_foil_foot", "bending stress of the bump foil at the foot", &FoilStress::bump_foot, true},
    {"stress_bump_foil", "largest bending stress along the arc of the bump", &FoilStress::bump_largest, false},
}};

struct WeldStress {
  std::string_view name;
  std::string_view long_name;
  std::optional<double> FoilStress::*value;
};
constexpr std::array<WeldStress, 2> weld_stresses{{
    {"stress_top_foil_weld", "bending stress of the top foil at the weld", &FoilStress::top_weld},
    {"stress_bump_foil_weld", "bending stress of the bump foil at the weld", &FoilStress::bump_weld},
}};

struct InterfaceName {
  std::string_view name;
  std::string_view between;  ///< of what presses, what touches the crests, what carries
  InterfaceFields Increment::*fields;
  bool at_feet;
  std::string_view loads;  ///< what its normal forces at full displacement are called
};
constexpr std::array<InterfaceName, 3> interfaces{{
    {"journal_top", "between {0} and top foil", &Increment::journal_top, false, "journal_loads"},
    {"top_bump", "between {1} and crest", &Increment::top_bump, false, "bump_loads"},
    {"bump_sleeve", "between foot and {2}", &Increment::bump_sleeve, true, "foot_loads"},
}};

struct InterfaceQuantity {
  std::string_view name;
  std::string_view unit;
  Vector InterfaceFields::*values;
};
constexpr std::array<InterfaceQuantity, 3> interface_quantities{{
    {"gap", "m", &InterfaceFields::gap},
    {"normal_force", "N", &InterfaceFields::normal_force},
    {"friction_force", "N", &InterfaceFields::friction_force},
}};

/// Puts a result into a file, variable by variable.
class ResultWriter {
 public:
  ResultWriter(const NcGroup& file, const Case& input, const CycleResult& result)
      : file_(file),
        input_(input),
        result_(result),
        layout_(make_result_layout(input, result.experiment)),
        loop_(file.addDim(layout_.loop.name, layout_.loop.values.size())),
        increment_(file.addDim("increment", layout_.increments)),
        bump_(file.addDim("bump", layout_.bumps)),
        foot_(file.addDim("foot", layout_.feet)) {
    BUMPFOIL_ASSERT(result.cycles.size() <= layout_.loop.values.size());
  }

  void write_coordinates() {
    put(meaning(layout_.loop), {loop_}, layout_.loop.values);
    put({"increment", "1", "increment; 0 is the start of the loop"}, {increment_}, numbers_from(0, increment_));
    put({"bump", "1", "bump, counted from the weld"}, {bump_}, numbers_from(1, bump_));
    put({"foot", "1", fmt::format("foot of the bump foil on the {}, counted from the weld", layout_.carrying)}, {foot_},
        numbers_from(1, foot_));
  }

  void write_geometry() {
    for (const NamedNumbers& scalar : layout_.scalars) put(meaning(scalar), {}, scalar.values);
    for (const NamedNumbers& numbers : layout_.at_bumps) put(meaning(numbers), {bump_}, numbers.values);
    for (const NamedNumbers& numbers : layout_.at_feet) put(meaning(numbers), {foot_}, numbers.values);
  }

  void write_cycles() {
    for (const CycleColumn& column : cycle_columns(result_.experiment)) {
      put_cycles<double>(meaning(column), [&](const Cycle& cycle) { return finite_or_absent(column.value(cycle)); });
    }
    put_cycles<double>({"amplitude", "m", "full displacement"}, [](const Cycle& cycle) { return cycle.amplitude; });
    put_cycles<int>({"steps", "1", "increments per branch"}, [](const Cycle& cycle) { return cycle.steps; });
    put_cycles<int>({"total_iterations", "1", "linear solves of all increments"},
                    [](const Cycle& cycle) { return cycle.total().iterations; });
    put_cycles<int>({"total_factorisations", "1", "factorisations of all increments"},
                    [](const Cycle& cycle) { return cycle.total().factorisations; });
    put_cycles<int>({"total_substeps", "1", "extra solves of all increments because they had to be halved"},
                    [](const Cycle& cycle) { return cycle.substeps(); });
    for (const StressedFoil& foil : stressed_foils()) {
      put_cycles<Flag>(
          {fmt::format("above_yield_{}", foil.name), "",
           fmt::format("whether the stress of the {} exceeds its yield stress", foil.long_name)},
          [&](const Cycle& cycle) {
            const std::optional<bool> above = above_yield(foil, input_, cycle);
            return above ? static_cast<Flag>(*above) : Storage<Flag>::absent;
          },
          truth_meanings);
    }
    // A loop that was never begun did not converge.
    std::vector<Flag> converged(loop_.getSize());
    for (std::size_t i = 0; i < result_.cycles.size(); ++i) converged[i] = result_.cycles[i].converged ? 1 : 0;
    put({"converged", "", "whether every increment of the cycle is there and converged"}, {loop_}, converged,
        truth_meanings);
  }

  void write_increments() {
    for (const IncrementColumn& column : increment_columns(result_.experiment)) {
      put_increments<double>(meaning(column), [&](const Increment& increment, double* to) {
        *to = finite_or_absent(column.value(increment));
      });
    }
    put_increments<int>({"iterations", "1", "linear solves"},
                        [](const Increment& increment, int* to) { *to = increment.solve.iterations; });
    put_increments<int>({"factorisations", "1", "factorisations of the system of equations"},
                        [](const Increment& increment, int* to) { *to = increment.solve.factorisations; });
    put_increments<int>({"substeps", "1", "extra solves because the increment had to be halved"},
                        [](const Increment& increment, int* to) { *to = increment.substeps; });
    put_increments<Flag>(
        {"branch", "", "branch of the cycle"},
        [](const Increment& increment, Flag* to) { *to = static_cast<Flag>(increment.branch); }, branch_meanings);
    put_increments<Flag>(
        {"increment_converged", "", "whether the increment meets the bound of the solver"},
        [](const Increment& increment, Flag* to) { *to = increment.solve.converged ? 1 : 0; }, truth_meanings);
  }

  void write_fields() {
    for (const NodalField& field : nodal_fields) {
      put_vectors({std::string(field.name), "m", std::string(field.long_name)}, field.at_feet,
                  [&](const Increment& increment) -> const Vector& { return increment.*field.values; });
    }
    for (const InterfaceName& interface : interfaces) {
      const std::string between = between_bodies(interface);
      for (const InterfaceQuantity& quantity : interface_quantities) {
        std::string long_name = fmt::format("{} {}", quantity.name, between);
        std::replace(long_name.begin(), long_name.end(), '_', ' ');
        put_vectors(
            {fmt::format("{}_{}", quantity.name, interface.name), quantity.unit, long_name}, interface.at_feet,
            [&](const Increment& increment) -> const Vector& { return increment.*interface.fields.*quantity.values; });
      }
      put_increments<Flag>(
          {fmt::format("state_{}", interface.name), "", fmt::format("state of the contact {}", between)},
          [&](const Increment& increment, Flag* to) {
            const std::vector<ContactMode>& mode = (increment.*interface.fields).mode;
            std::transform(mode.begin(), mode.end(), to, [](ContactMode m) { return static_cast<Flag>(m); });
          },
          mode_meanings, &node(interface.at_feet));
      put_loads(interface);
    }
  }

  void write_stress() {
    for (const StressField& field : stress_fields) {
      put_vectors({std::string(field.name), "Pa", std::string(field.long_name)}, field.at_feet,
                  [&](const Increment& increment) -> const Vector& { return increment.stress.*field.values; });
    }
    for (const WeldStress& weld : weld_stresses) {
      put_increments<double>(
          {std::string(weld.name), "Pa", std::string(weld.long_name)},
          [&](const Increment& increment, double* to) { *to = finite_or_absent(increment.stress.*weld.value); });
    }
  }

  /// Changes of mode, where the solver followed them.
  void write_events() {
    std::vector<double> loop, displacement;
    std::vector<Flag> branch, interface, from, to;
    std::vector<int> index;
    for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
      for (const CycleEvent& event : result_.cycles[i].events) {
        loop.push_back(layout_.loop.values[i]);
        displacement.push_back(event.displacement);
        branch.push_back(static_cast<Flag>(event.branch));
        interface.push_back(static_cast<Flag>(event.interface));
        index.push_back(event.index + 1);
        from.push_back(static_cast<Flag>(event.from));
        to.push_back(static_cast<Flag>(event.to));
      }
    }
    if (loop.empty()) return;
    const std::vector<NcDim> dims{file_.addDim("event", loop.size())};
    put({"event_" + layout_.loop.name, layout_.loop.unit, layout_.loop.long_name}, dims, loop);
    put({"event_displacement", "m", fmt::format("displacement of the {}", layout_.pressing)}, dims, displacement);
    put({"event_index", "1", fmt::format("bump or, at the {}, foot, counted from the weld", layout_.carrying)}, dims,
        index);
    put({"event_branch", "", "branch of the cycle"}, dims, branch, branch_meanings);
    put({"event_interface", "", "interface of the contact"}, dims, interface, interface_meanings);
    put({"event_from", "", "state of the contact before"}, dims, from, mode_meanings);
    put({"event_to", "", "state of the contact after"}, dims, to, mode_meanings);
  }

 private:
  template <typename Column>
  static Meaning meaning(const Column& column) {
    return {std::string(column.name), column.unit, std::string(column.long_name)};
  }

  [[nodiscard]] std::string between_bodies(const InterfaceName& interface) const {
    return fmt::format(fmt::runtime(interface.between), layout_.pressing, layout_.over_crest, layout_.carrying);
  }

  static std::vector<int> numbers_from(int first, const NcDim& dim) {
    std::vector<int> numbers(dim.getSize());
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
  }

  const NcDim& node(bool foot) const { return foot ? foot_ : bump_; }

  /// A variable that is all there.
  template <typename Number>
  void put(const Meaning& meaning, const std::vector<NcDim>& dims, const std::vector<Number>& values,
           std::string_view flag_meanings = {}) {
    define_variable<Number>(file_, meaning, dims, flag_meanings).putVar(values.data());
  }

  /// A variable with one value per loop, absent for those that were not begun.
  template <typename Number, typename ValueOf>
  void put_cycles(const Meaning& meaning, const ValueOf& value_of, std::string_view flag_meanings = {}) {
    std::vector<Number> values(loop_.getSize(), Storage<Number>::absent);
    std::transform(result_.cycles.begin(), result_.cycles.end(), values.begin(), value_of);
    const NcVar variable = define_variable<Number>(file_, meaning, {loop_}, flag_meanings);
    variable.setFill(true, Storage<Number>::absent);
    variable.putVar(values.data());
  }

  /// A variable with one value per loop and increment or, where `node` is not null, per bump or foot besides.
  /// @param values_of  (increment, to): puts the values of an increment from `to` on; what it leaves out is absent
  template <typename Number, typename ValuesOf>
  void put_increments(const Meaning& meaning, const ValuesOf& values_of, std::string_view flag_meanings = {},
                      const NcDim* node = nullptr) {
    std::vector<NcDim> dims{loop_, increment_};
    if (node != nullptr) dims.push_back(*node);
    const NcVar variable = define_variable<Number>(file_, meaning, dims, flag_meanings);
    variable.setFill(true, Storage<Number>::absent);
    if (node != nullptr) {
      variable.putAtt("coordinates", node->getName() == "foot" ? layout_.foot_coordinates : layout_.bump_coordinates);
    }
    const std::size_t width = node != nullptr ? node->getSize() : 1;
    // One chunk per loop, unless it passes a megabyte.
    std::vector<std::size_t> chunk{1, std::clamp<std::size_t>(131072 / width, 1, increment_.getSize()), width};
    chunk.resize(dims.size());
    variable.setChunking(NcVar::nc_CHUNKED, chunk);
    variable.setCompression(true, true, 1);

    std::vector<std::size_t> start{0, 0, 0};
    std::vector<std::size_t> count{1, 0, width};
    start.resize(dims.size());
    count.resize(dims.size());
    for (std::size_t loop = 0; loop < result_.cycles.size(); ++loop) {
      const std::vector<Increment>& increments = result_.cycles[loop].increments;
      if (increments.empty()) continue;
      std::vector<Number> values(increments.size() * width, Storage<Number>::absent);
      for (std::size_t i = 0; i < increments.size(); ++i) values_of(increments[i], values.data() + i * width);
      start[0] = loop;
      count[1] = increments.size();
      variable.putVar(start, count, values.data());
    }
  }

  template <typename VectorOf>
  void put_vectors(const Meaning& meaning, bool at_feet, const VectorOf& vector_of) {
    put_increments<double>(
        meaning,
        [&](const Increment& increment, double* to) {
          const Vector& values = vector_of(increment);
          std::transform(values.begin(), values.end(), to, [](double value) { return finite_or_absent(value); });
        },
        {}, &node(at_feet));
  }

  /// Normal forces at full displacement.
  void put_loads(const InterfaceName& interface) {
    const NcDim& dim = node(interface.at_feet);
    std::vector<double> values(loop_.getSize() * dim.getSize(), Storage<double>::absent);
    for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
      if (!result_.cycles[i].turning_point) continue;
      const Vector& loads = (result_.cycles[i].at_turning_point().*interface.fields).normal_force;
      std::transform(loads.begin(), loads.end(), values.data() + i * dim.getSize(),
                     [](double load) { return finite_or_absent(load); });
    }
    const NcVar variable =
        define_variable<double>(file_,
                                {std::string(interface.loads), "N",
                                 fmt::format("normal force {} at full displacement", between_bodies(interface))},
                                {loop_, dim}, {});
    variable.setFill(true, Storage<double>::absent);
    variable.putVar(values.data());
  }

  NcGroup file_;
  const Case& input_;
  const CycleResult& result_;
  ResultLayout layout_;
  NcDim loop_, increment_, bump_, foot_;
};

std::string_view message_of(RunStatus status) {
  switch (status) {
    case RunStatus::complete:
      return "";
    case RunStatus::failed:
      return "an increment did not converge: its cycle ends there";
    case RunStatus::interrupted:
      return "the run was interrupted by the user or the system";
  }
  return "";
}

void write_provenance(const NcGroup& file, const Case& input, const CycleResult& result, RunStatus status,
                      const Provenance& provenance, std::string_view run_id) {
  const auto put = [&file](const char* name, std::string_view text) {
    // An attribute without a single character is more than some readers expect.
    if (!text.empty()) file.putAtt(name, std::string(text));
  };
  const std::string date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  put("Conventions", "CF-1.8");
  put("schema", "bumpfoil-result/1");
  put("title", input.title);
  put("source", fmt::format("bumpfoil {} ({})", version(), commit()));
  put("history", fmt::format("{}: {}", date, provenance.command_line));
  put("date_created", date);
  put("run_id", run_id);
  put("command_line", provenance.command_line);
  put("bumpfoil_command", name_of(result.experiment));
  put("solver", name_of(result.solver));
  put("status", status == RunStatus::complete ? "complete" : "partial");
  put("status_message", message_of(status));
  put("case_text", provenance.case_text);
  put("case_understood", case_to_toml(input));
}

}  // namespace

std::string result_netcdf(const Case& input, const CycleResult& result, RunStatus status, const Provenance& provenance,
                          std::string_view run_id) {
  try {
    NewNetcdf file;
    write_provenance(file.root(), input, result, status, provenance, run_id);
    ResultWriter writer(file.root(), input, result);
    writer.write_coordinates();
    writer.write_geometry();
    writer.write_cycles();
    writer.write_increments();
    writer.write_fields();
    writer.write_stress();
    writer.write_events();
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    // The first line says what went wrong, the second where in the library.
    const std::string_view reason = error.what();
    throw Error(ErrorKind::file,
                {{"result.nc", 0, "", "", fmt::format("cannot be built: {}", reason.substr(0, reason.find('\n'))),
                  "the memory may not suffice: fewer steps or directions take less"}});
  }
}

}  // namespace bumpfoil
