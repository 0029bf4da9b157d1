#include "pages/result_reader.hpp"
#include "readers/result_kinds.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/printable.hpp"
#include "core/base64.hpp"
#include "pages/ensemble_reader.hpp"
#include "pages/grid_reader.hpp"
#include "pages/revolution_reader.hpp"
#include "pages/shown_run.hpp"
#include "results/netcdf_image.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;
using Flag = signed char;

/// NaN if all are unknown.
double largest(std::vector<double>::const_iterator begin, std::vector<double>::const_iterator end) {
  return std::accumulate(begin, end, std::numeric_limits<double>::quiet_NaN(),
                         [](double most, double number) { return std::fmax(most, number); });
}

/// The dimension of cycles: a bearing has one per direction.
std::string cycle_dimension(std::string_view kind) {
  return kind == "strip" ? "cycle" : "direction";
}

bool is_field(const StoredVariable& variable, std::string_view cycle) {
  return std::any_of(node_dimensions.begin(), node_dimensions.end(), [&](std::string_view node) {
    return variable.has_dims({cycle, "increment", node});
  });
}

/// Reads the cycles one by one.
class CycleReader {
 public:
  CycleReader(const NetcdfImage& file, const std::string& cycle_dimension, std::size_t most_values)
      : file_(file),
        cycle_(cycle_dimension),
        increments_(file.size_of("increment")),
        force_(file.variable("force_direct", {cycle_, "increment"})),
        cycles_(file.numbers(file.variable(cycle_, {cycle_}))),
        branches_(read_branches()),
        stride_(std::max<std::size_t>(1, (field_values() + most_values - 1) / most_values)) {
    static_cast<void>(file_.variable("displacement", {cycle_, "increment"}));
    if (increments_ == 0) file_.refuse("increment", "is empty");
    if (cycles_.empty()) file_.refuse(cycle_, "is empty");
    if (std::any_of(cycles_.begin(), cycles_.end(), [](double at) { return std::isnan(at); })) {
      file_.refuse(cycle_, "has a value that is not numeric");
    }
  }

  [[nodiscard]] std::size_t size() const { return cycles_.size(); }
  [[nodiscard]] std::size_t last_increment() const { return increments_ - 1; }

  [[nodiscard]] Json read(std::size_t cycle) const {
    // A failed increment has a displacement, but no force.
    const std::vector<double> force = file_.numbers(force_, {cycle, 0}, {1, increments_});
    const auto end = std::find_if(force.begin(), force.end(), [](double f) { return std::isnan(f); });
    const std::vector<std::size_t> kept = kept_of(static_cast<std::size_t>(end - force.begin()), branches_[cycle]);
    Json json{{"at", cycles_[cycle]}, {"increments", kept}, {"series", Json::object()}, {"fields", Json::object()}};
    for (const auto& [name, variable] : file_.variables()) {
      if (variable.has_dims({cycle_, "increment"})) {
        json["series"][name] = encoded(variable, numbers(variable, cycle, kept, 1));
      } else if (is_field(variable, cycle_) && is_reduced(name)) {
        json["series"][name] = encoded(variable, largest_values(variable, cycle, kept));
      } else if (is_field(variable, cycle_) && !is_left_out(name)) {
        json["fields"][name] = {{"at", variable.dims[2]},
                                {"values", encoded(variable, numbers(variable, cycle, kept, variable.extents[2]))}};
      }
    }
    return json;
  }

 private:
  /// Increments per branch of every cycle; 0 if it was not started.
  [[nodiscard]] std::vector<std::size_t> read_branches() const {
    const std::vector<double> steps = file_.numbers(file_.variable("steps", {cycle_}));
    std::vector<std::size_t> branches;
    for (const double number : steps) {
      // Loading and unloading; fully reversed cycles also on the other side.
      const auto all = static_cast<double>(increments_) - 1.0;
      const bool fits = number == std::floor(number) && (number * 2.0 == all || number * 4.0 == all);
      if (!std::isnan(number) && !fits) {
        file_.refuse("steps", fmt::format("is {} for cycles of {} increments", number, increments_));
      }
      branches.push_back(std::isnan(number) ? 0 : static_cast<std::size_t>(number));
    }
    return branches;
  }

  /// Numbers per increment and node in the file that the page would show.
  [[nodiscard]] std::size_t field_values() const {
    std::size_t count = 0;
    for (const auto& [name, variable] : file_.variables()) {
      if (!is_field(variable, cycle_) || is_left_out(name) || is_reduced(name)) continue;
      count += variable.extents[0] * variable.extents[1] * variable.extents[2];
    }
    return count;
  }

  /// Every n-th increment of each branch, plus the ends of branches and the last one.
  [[nodiscard]] std::vector<std::size_t> kept_of(std::size_t reached, std::size_t branch) const {
    if (reached > 0 && branch == 0) file_.refuse("steps", "is missing for a started cycle");
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < reached; ++i) {
      if (i % branch % stride_ == 0 || i + 1 == reached) kept.push_back(i);
    }
    return kept;
  }

  /// Values at the kept increments, `width` for each.
  [[nodiscard]] std::vector<double> numbers(const StoredVariable& variable, std::size_t cycle,
                                            const std::vector<std::size_t>& kept, std::size_t width) const {
    if (kept.empty()) return {};
    std::vector<std::size_t> start{cycle, 0, 0};
    std::vector<std::size_t> count{1, kept.back() + 1, width};
    start.resize(variable.extents.size());
    count.resize(start.size());
    const std::vector<double> all = file_.numbers(variable, start, count);
    std::vector<double> numbers;
    numbers.reserve(kept.size() * width);
    for (const std::size_t i : kept) {
      const auto row = all.begin() + static_cast<std::ptrdiff_t>(i * width);
      numbers.insert(numbers.end(), row, row + static_cast<std::ptrdiff_t>(width));
    }
    return numbers;
  }

  [[nodiscard]] std::vector<double> largest_values(const StoredVariable& variable, std::size_t cycle,
                                                   const std::vector<std::size_t>& kept) const {
    const std::size_t width = variable.extents[2];
    const std::vector<double> all = numbers(variable, cycle, kept, width);
    std::vector<double> most;
    for (auto row = all.begin(); row != all.end(); row += static_cast<std::ptrdiff_t>(width)) {
      most.push_back(largest(row, row + static_cast<std::ptrdiff_t>(width)));
    }
    return most;
  }

  [[nodiscard]] static std::string encoded(const StoredVariable& variable, const std::vector<double>& numbers) {
    if (variable.type != NC_BYTE) return base64_of(numbers);
    std::vector<Flag> flags(numbers.size());
    std::transform(numbers.begin(), numbers.end(), flags.begin(),
                   [](double number) { return std::isnan(number) ? NC_FILL_BYTE : static_cast<Flag>(number); });
    return base64_of(flags);
  }

  const NetcdfImage& file_;
  std::string cycle_;
  std::size_t increments_;
  const StoredVariable& force_;
  std::vector<double> cycles_;
  std::vector<std::size_t> branches_;
  std::size_t stride_;
};

Json geometry_of(const NetcdfImage& file) {
  Json geometry = Json::object();
  for (const auto& [name, variable] : file.variables()) {
    if (variable.dims.empty()) {
      geometry[name] = file.numbers(variable).front();
    } else if (variable.dims.size() == 1 && is_node(variable.dims.front())) {
      geometry[name] = file.numbers(variable);
    }
  }
  return geometry;
}

/// Descriptions of the variables of cycles and increments in the file.
Json meanings_of(const NetcdfImage& file, const std::string& cycle) {
  Json meanings = Json::object();
  for (const auto& [name, variable] : file.variables()) {
    if (variable.dims.empty() || variable.dims[0] != cycle || variable.long_name.empty()) continue;
    meanings[name] = {{"unit", variable.units == "1" ? "" : variable.units}, {"text", variable.long_name}};
  }
  return meanings;
}

/// The command that wrote the file: one that this version has.
std::string kind_of(const NetcdfImage& file) {
  const std::map<std::string, std::string>& texts = file.texts();
  const auto text = [&texts](const char* name) {
    const auto found = texts.find(name);
    return found != texts.end() ? found->second : std::string();
  };
  const std::string schema = text("schema");
  if (!schema.starts_with("bumpfoil-result/")) file.refuse("", "is not a result of this program");
  if (schema != "bumpfoil-result/2") {
    file.refuse("schema",
                fmt::format("is \"{}\", which this version cannot read: use the one that wrote it", printable(schema)));
  }
  std::string kind = text("bumpfoil_command");
  if (!is_known(kind)) {
    file.refuse("", fmt::format("is a result of `bumpfoil {}`, which this version does not have", printable(kind)));
  }
  return kind;
}

Json read_cycles(const NetcdfImage& file, const std::string& kind, std::size_t most_values) {
  const CycleReader reader(file, cycle_dimension(kind), most_values);
  Json nodes = Json::object();
  for (const std::string_view node : node_dimensions) {
    // Bearings with one pad lack the dimension of pads.
    if (node != "pad" || file.variables().contains("pad")) nodes[node] = file.size_of(std::string(node));
  }
  Json cycles = Json::array();
  for (std::size_t i = 0; i < reader.size(); ++i) cycles.push_back(reader.read(i));
  return {{"meanings", meanings_of(file, cycle_dimension(kind))},
          {"geometry", geometry_of(file)},
          {"nodes", nodes},
          {"last_increment", reader.last_increment()},
          {"cycles", cycles}};
}

}  // namespace

Json read_result(std::string bytes, const std::string& name, std::size_t most_values) {
  const NetcdfImage file(std::move(bytes), name);
  const std::string kind = kind_of(file);
  Json result{{"kind", kind}, {"attributes", file.texts()}};
  if (has_cycles(kind)) {
    result.update(read_cycles(file, kind, most_values));
  } else if (has_distributions(kind)) {
    result.update(read_distributions(file));
  } else if (has_revolutions(kind)) {
    result.update(read_revolutions(file, most_values));
  } else {
    result.update(read_grid(file, most_values, {[all = has_states(kind)](const StoredVariable& variable) {
                              return all || !is_of_nodes(variable);
                            }}));
  }
  return result;
}

}  // namespace bumpfoil
