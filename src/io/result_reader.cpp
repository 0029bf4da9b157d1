#include "io/result_reader.hpp"

#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <netcdf>
#include <string>
#include <string_view>
#include <vector>

#include "io/base64.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;
using netCDF::NcFile;
using netCDF::NcVar;
using Flag = signed char;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

/// Fields that the page does not show.
bool is_left_out(const NcVar& variable) {
  const std::string name = variable.getName();
  return name.starts_with("gap_") || name.starts_with("stress_") || name == "friction_force_journal_top";
}

bool has_dims(const NcVar& variable, const std::vector<std::string_view>& names) {
  const std::vector<netCDF::NcDim> dims = variable.getDims();
  return std::equal(dims.begin(), dims.end(), names.begin(), names.end(),
                    [](const netCDF::NcDim& dim, std::string_view name) { return dim.getName() == name; });
}

/// Of the loops: directions of a bearing, cycles of a strip.
std::string loop_dimension(const NcFile& file) {
  return file.getDim("direction").isNull() ? "cycle" : "direction";
}

bool is_series(const NcVar& variable) {
  return has_dims(variable, {"direction", "increment"}) || has_dims(variable, {"cycle", "increment"});
}

bool is_field(const NcVar& variable) {
  for (const std::string_view loop : {"direction", "cycle"}) {
    for (const std::string_view node : {"bump", "foot"}) {
      if (has_dims(variable, {loop, "increment", node})) return true;
    }
  }
  return false;
}

/// Part of a variable; NaN where the file has its fill value.
std::vector<double> read_numbers(const NcVar& variable, const std::vector<std::size_t>& start,
                                 const std::vector<std::size_t>& count) {
  std::size_t size = 1;
  for (const std::size_t extent : count) size *= extent;
  std::vector<double> numbers(size);
  variable.getVar(start, count, numbers.data());
  bool may_be_absent = false;
  double fill = 0.0;
  // Of the variable's own type in the file; integers of 32 bits and their fill values are exact in binary64.
  if (variable.getAtts().contains("_FillValue")) {
    variable.getAtt("_FillValue").getValues(&fill);
    may_be_absent = true;
  }
  for (double& number : numbers) {
    if ((may_be_absent && number == fill) || !std::isfinite(number)) number = absent;
  }
  return numbers;
}

Json global_texts(const NcFile& file) {
  Json texts = Json::object();
  for (const auto& [name, attribute] : file.getAtts()) {
    if (attribute.getType() != netCDF::ncChar && attribute.getType() != netCDF::ncString) continue;
    std::string text;
    attribute.getValues(text);
    texts[name] = text;
  }
  return texts;
}

/// Reads one loop after the other.
class LoopReader {
 public:
  LoopReader(const NcFile& file, std::size_t stride)
      : variables_(file.getVars()),
        increments_(file.getDim("increment").getSize()),
        stride_(std::max<std::size_t>(stride, 1)),
        loops_(read_all(loop_dimension(file))),
        steps_(read_all("steps")) {}

  [[nodiscard]] std::size_t size() const { return loops_.size(); }

  [[nodiscard]] Json read(std::size_t loop) const {
    const std::vector<double> displacement = read_numbers(find("displacement"), {loop, 0}, {1, increments_});
    const auto end = std::find_if(displacement.begin(), displacement.end(), [](double d) { return std::isnan(d); });
    const std::vector<std::size_t> kept = kept_of(static_cast<std::size_t>(end - displacement.begin()), steps_[loop]);
    Json json{{"at", loops_[loop]}, {"increments", kept}, {"series", Json::object()}, {"fields", Json::object()}};
    for (const auto& [name, variable] : variables_) {
      if (is_series(variable)) {
        json["series"][name] = encoded(variable, loop, kept, 1);
      } else if (is_field(variable) && !is_left_out(variable)) {
        const netCDF::NcDim nodes = variable.getDim(2);
        json["fields"][name] = {{"at", nodes.getName()}, {"values", encoded(variable, loop, kept, nodes.getSize())}};
      }
    }
    return json;
  }

 private:
  /// The values of a variable with one for each loop.
  [[nodiscard]] std::vector<double> read_all(const std::string& name) const {
    const NcVar variable = find(name);
    return read_numbers(variable, {0}, {variable.getDim(0).getSize()});
  }

  [[nodiscard]] NcVar find(const std::string& name) const {
    const auto found = variables_.find(name);
    if (found == variables_.end()) throw NotAResult("is damaged: there is no " + name);
    return found->second;
  }

  /// Every n-th increment of each branch; those at which branches end are kept themselves, and so is the last one.
  [[nodiscard]] std::vector<std::size_t> kept_of(std::size_t reached, double steps) const {
    const auto branch = steps >= 1.0 ? static_cast<std::size_t>(steps) : increments_;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < reached; ++i) {
      if (i % branch % stride_ == 0 || i + 1 == reached) kept.push_back(i);
    }
    return kept;
  }

  [[nodiscard]] std::string encoded(const NcVar& variable, std::size_t loop, const std::vector<std::size_t>& kept,
                                    std::size_t width) const {
    if (kept.empty()) return "";
    std::vector<std::size_t> start{loop, 0, 0};
    std::vector<std::size_t> count{1, kept.back() + 1, width};
    start.resize(static_cast<std::size_t>(variable.getDimCount()));
    count.resize(start.size());
    const std::vector<double> all = read_numbers(variable, start, count);
    std::vector<double> numbers;
    numbers.reserve(kept.size() * width);
    for (const std::size_t i : kept) {
      const auto row = all.begin() + static_cast<std::ptrdiff_t>(i * width);
      numbers.insert(numbers.end(), row, row + static_cast<std::ptrdiff_t>(width));
    }
    if (variable.getType() != netCDF::ncByte) return base64_of(numbers);
    std::vector<Flag> flags(numbers.size());
    std::transform(numbers.begin(), numbers.end(), flags.begin(),
                   [](double number) { return std::isnan(number) ? NC_FILL_BYTE : static_cast<Flag>(number); });
    return base64_of(flags);
  }

  std::multimap<std::string, NcVar> variables_;
  std::size_t increments_;
  std::size_t stride_;
  std::vector<double> loops_;
  std::vector<double> steps_;
};

Json geometry_of(const NcFile& file) {
  Json geometry = Json::object();
  for (const auto& [name, variable] : file.getVars()) {
    if (variable.getDimCount() == 0) {
      geometry[name] = read_numbers(variable, {}, {}).front();
    } else if (has_dims(variable, {"bump"}) || has_dims(variable, {"foot"})) {
      geometry[name] = read_numbers(variable, {0}, {variable.getDim(0).getSize()});
    }
  }
  return geometry;
}

std::size_t node_values(const NcFile& file) {
  std::size_t count = 0;
  for (const auto& [name, variable] : file.getVars()) {
    if (!is_field(variable) || is_left_out(variable)) continue;
    std::size_t size = 1;
    for (const netCDF::NcDim& dim : variable.getDims()) size *= dim.getSize();
    count += size;
  }
  return count;
}

}  // namespace

Json read_result(const std::filesystem::path& path, std::size_t most_values) {
  const NcFile file(path.string(), NcFile::read);
  Json attributes = global_texts(file);
  if (attributes.value("schema", "") != "bumpfoil-result/1") throw NotAResult("is no result of this program");
  // Results that were written before there were others do not say what they are.
  const std::string kind = attributes.value("bumpfoil_command", "cycle");
  if (kind != "cycle" && kind != "strip")
    throw NotAResult("is a result of `bumpfoil " + kind + "`, which reports cannot show");
  const std::size_t stride = (node_values(file) + most_values - 1) / most_values;
  Json nodes = Json::object();
  for (const char* name : {"bump", "foot"}) nodes[name] = file.getDim(name).getSize();
  Json loops = Json::array();
  const LoopReader reader(file, stride);
  for (std::size_t i = 0; i < reader.size(); ++i) loops.push_back(reader.read(i));
  return {{"kind", kind},
          {"attributes", attributes},
          {"geometry", geometry_of(file)},
          {"nodes", nodes},
          {"last_increment", file.getDim("increment").getSize() - 1},
          {"loops", loops}};
}

}  // namespace bumpfoil
