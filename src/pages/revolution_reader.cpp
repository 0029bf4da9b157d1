#include "pages/revolution_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/transient/ends_of_turns.hpp"
#include "pages/grid_reader.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Fraction of all numbers for each of revolutions, spectra and steps: a page of some megabytes.
constexpr std::size_t part_of_rows = 8;
/// Maximum number of steps per revolution of an orbit plot.
constexpr std::size_t most_steps_of_orbit = 200;
/// Number of consecutive orbits kept if others are omitted: whirl at half the speed takes two revolutions.
constexpr std::size_t orbits_together = 4;
/// Variables read per step; energies are read per revolution.
constexpr std::array<std::string_view, 6> read_of_steps{"time", "speed", "x", "y", "h_min", "asperity_load"};
/// Larger angles in radians are invalid.
constexpr double largest_angle = 1e12;

bool is_over(const StoredVariable& variable, std::string_view dimension) {
  return !variable.dims.empty() && variable.dims.front() == dimension;
}

bool is_read(const StoredVariable& variable) {
  return !is_over(variable, "step") ||
         std::find(read_of_steps.begin(), read_of_steps.end(), variable.name) != read_of_steps.end();
}

/// Number of entries of a dimension, and numbers per entry.
struct RowSize {
  std::size_t rows{};
  double width{};  ///< floating point: damaged files may declare any size
};

RowSize row_size(const NetcdfImage& file, std::string_view dimension) {
  RowSize size;
  for (const auto& [name, variable] : file.variables()) {
    if (!is_over(variable, dimension) || !is_read(variable)) continue;
    size.rows = variable.extents.front();
    size.width += std::accumulate(variable.extents.begin() + 1, variable.extents.end(), 1.0, std::multiplies<>());
  }
  return size;
}

/// Stride at which rows are read if they are too many.
std::size_t stride_of(std::size_t rows, double width, std::size_t most_values) {
  const double values = static_cast<double>(rows) * width;
  return values <= static_cast<double>(most_values)
             ? 1
             : static_cast<std::size_t>(std::ceil(values / static_cast<double>(most_values)));
}

/// Adds every n-th from `first` to `last`, and the last.
void add_every(std::size_t first, std::size_t last, std::size_t stride, std::vector<std::size_t>& rows) {
  for (std::size_t row = first; row < last; row += stride) rows.push_back(row);
  rows.push_back(last);
}

/// Steps of the selected revolutions, and the start of each among them.
struct OrbitSteps {
  std::vector<std::size_t> rows;
  Json orbits = Json::array();
};

/// All steps of the selected revolutions, including the last one, complete or not.
OrbitSteps orbit_steps(const NetcdfImage& file, const RowSize& size, std::size_t most_values) {
  const StoredVariable& stored = file.variable("angle", {"step"});
  const std::vector<std::size_t> ends = ends_of_turns(size.rows, [&](std::size_t first, std::size_t count) {
    std::vector<double> angles = file.numbers(stored, {first}, {count});
    if (!std::all_of(angles.begin(), angles.end(), [](double angle) { return std::abs(angle) < largest_angle; })) {
      file.refuse("angle", "has a value that is not an angle");
    }
    return angles;
  });
  std::vector<std::pair<std::size_t, std::size_t>> all;  // first and last step of each revolution
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::size_t last = i + 1 < ends.size() ? ends[i + 1] : size.rows - 1;
    if (last > ends[i]) all.emplace_back(ends[i], last);
  }
  const auto stride_in = [](const auto& orbit) {
    return (orbit.second - orbit.first + most_steps_of_orbit - 1) / most_steps_of_orbit;
  };
  const std::size_t steps = std::accumulate(
      all.begin(), all.end(), std::size_t{1},
      [&](std::size_t sum, const auto& orbit) { return sum + (orbit.second - orbit.first) / stride_in(orbit) + 1; });
  const std::size_t stride = stride_of(steps, size.width, most_values);
  OrbitSteps found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((all.size() - 1 - i) / orbits_together % stride != 0) continue;
    const auto& [first, last] = all[i];
    // If the previous revolution was read, too, its last step is the first of this one.
    if (!found.rows.empty() && found.rows.back() == first) found.rows.pop_back();
    const std::size_t begin = found.rows.size();
    add_every(first, last, stride_in(all[i]), found.rows);
    found.orbits.push_back({{"revolution", i + 1}, {"first", begin}, {"steps", found.rows.size() - begin}});
  }
  return found;
}

}  // namespace

Json read_revolutions(const NetcdfImage& file, std::size_t most_values) {
  const std::size_t most = std::max<std::size_t>(1, most_values / part_of_rows);
  GridParts parts{is_read};
  Json stored = Json::object();
  for (const char* dimension : {"revolution", "spectrum"}) {
    const RowSize size = row_size(file, dimension);
    if (size.rows == 0) continue;
    stored[dimension] = size.rows;
    add_every(0, size.rows - 1, stride_of(size.rows, size.width, most), parts.rows[dimension]);
  }
  Json orbits = Json::array();
  if (const RowSize size = row_size(file, "step"); size.rows > 0) {
    stored["step"] = size.rows;
    OrbitSteps steps = orbit_steps(file, size, most);
    parts.rows["step"] = std::move(steps.rows);
    orbits = std::move(steps.orbits);
  }
  Json json = read_grid(file, most_values, parts);
  json["stored"] = std::move(stored);
  json["orbits"] = std::move(orbits);
  return json;
}

}  // namespace bumpfoil
