#include "experiments/stability/stability_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <utility>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/rotor_speeds.hpp"
#include "experiments/stability/stability_quantities.hpp"

namespace bumpfoil {
namespace {

std::vector<double> speeds_of(const StabilityResult& result) {
  return each(result.map.points, [](const SpeedPoint& point) { return point.speed; });
}

void add_bearings(const StabilityResult& result, Dataset& data) {
  add_journals(result.map.points, result.machine, data);
  for (const int axis : {0, 1}) {
    data.add({axis == 0 ? "load_x" : "load_y", "N",
              fmt::format("weight of the rotor on the bearing, {}", axis == 0 ? 'X' : 'Y')},
             {"bearing"}, each(result.machine.loads, [axis](const Eigen::Vector2d& load) { return load[axis]; }));
  }
}

/// Values of all motions. @param width  number of values of each; `value` writes them from `out` on
void add_of_motions(const StabilityResult& result, const VariableMeaning& meaning, std::vector<std::string> inside,
                    std::size_t width, const std::function<void(const SpeedMotion&, double* out)>& fill,
                    Dataset& data) {
  std::vector<std::string> dims = motion_dimensions();
  dims.insert(dims.end(), inside.begin(), inside.end());
  data.add(meaning, std::move(dims), [&result, width, fill] {
    constexpr std::size_t kinds = enum_names<ContactMotion>.size();
    const std::size_t modes = result.map.motions;
    std::vector<double> all(result.map.points.size() * kinds * modes * width, absent);
    for (std::size_t i = 0; i < result.map.points.size(); ++i) {
      for (const SpeedMotion& motion : motions_at(result.map.points[i])) {
        const std::size_t row = (i * kinds + static_cast<std::size_t>(motion.contacts)) * modes + motion.number;
        fill(motion, &all[row * width]);
      }
    }
    return all;
  });
}

void add_motions(const StabilityResult& result, Dataset& data) {
  constexpr auto contact_words = std::span(enum_names<ContactMotion>);
  data.add_dimension({"contacts", "", "what slipping contacts do", {Form::flag, contact_words}},
                     numbers_from(0.0, contact_words.size()));
  data.add_dimension({"mode", "1", "number of the motion, the same at all speeds", {Form::whole}},
                     numbers_from(1.0, result.map.motions));
  for (const MotionQuantity& quantity : motion_quantities()) {
    add_of_motions(
        result, quantity.meaning(), {}, 1,
        [quantity](const SpeedMotion& motion, double* out) { *out = quantity.value(motion); }, data);
  }
}

/// Shapes of all motions at the positions of the rotor, scaled to a largest displacement of 1 with phase 0.
void add_shapes(const StabilityResult& result, Dataset& data) {
  const std::vector<RotorStation> places = result.machine.places();
  add_stations(places, data);
  for (const int axis : {0, 1}) {
    const char letter = axis == 0 ? 'x' : 'y';
    for (const bool phase : {false, true}) {
      const std::string name = fmt::format("shape_{}_{}", phase ? "phase" : "amplitude", letter);
      const std::string what = fmt::format("{} of the motion along {}{}", phase ? "phase" : "amplitude",
                                           axis == 0 ? 'X' : 'Y', phase ? "" : ", over the largest one");
      add_of_motions(
          result, {name, phase ? "degree" : "1", what}, {"station"}, places.size(),
          [places, axis, phase](const SpeedMotion& motion, double* out) {
            std::complex<double> largest;
            for (const RotorStation& place : places) {
              for (const std::complex<double> one : place.orbit(motion.whirl.shape)) {
                if (std::abs(one) > std::abs(largest)) largest = one;
              }
            }
            for (std::size_t i = 0; i < places.size(); ++i) {
              const std::complex<double> here = places[i].orbit(motion.whirl.shape)[axis] / largest;
              out[i] = phase ? to_degrees(std::arg(here)) : std::abs(here);
            }
          },
          data);
    }
  }
}

}  // namespace

std::vector<std::string> motion_dimensions() {
  return {"speed", "contacts", "mode"};
}

Dataset stability_dataset(const StabilityResult& result, bool with_motions) {
  Dataset data;
  for (const StabilityQuantity& quantity : stability_quantities()) {
    data.add(quantity.meaning(), {}, std::vector<double>{quantity.value(result)});
  }
  add_speeds(speeds_of(result), data);
  for (const SpeedQuantity& quantity : speed_quantities()) {
    data.add(quantity.meaning(), {"speed"},
             each(result.map.points, [&](const SpeedPoint& point) { return quantity.value(result, point); }));
  }
  add_bearings(result, data);
  if (!with_motions) return data;
  add_motions(result, data);
  add_shapes(result, data);
  return data;
}

std::vector<std::vector<std::size_t>> motion_rows(const StabilityResult& result, bool with_all_speeds) {
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < result.map.points.size(); ++i) {
    const std::vector<SpeedMotion> motions = motions_at(result.map.points[i]);
    for (const SpeedMotion& motion : motions) {
      rows.push_back({i, static_cast<std::size_t>(motion.contacts), motion.number});
    }
    if (motions.empty() && with_all_speeds) rows.push_back({i, no_entry, no_entry});
  }
  return rows;
}

std::vector<std::string> motion_columns() {
  std::vector<std::string> columns{"mode"};
  for (const MotionQuantity& quantity : motion_quantities()) {
    columns.emplace_back(quantity.name);
    if (quantity.name == "direction") columns.emplace_back("contacts");
  }
  return columns;
}

Table motion_table(const StabilityResult& result) {
  std::vector<std::string> columns = motion_columns();
  for (const MotionQuantity& quantity : motion_quantities()) {
    if (!quantity.is(tag::csv)) std::erase(columns, quantity.name);
  }
  columns.insert(columns.begin(), "speed");
  columns.insert(std::find(columns.begin(), columns.end(), "contacts") + 1, "speed_status");
  return table_of(stability_dataset(result),
                  {.over = motion_dimensions(), .columns = std::move(columns), .rows = motion_rows(result, true)});
}

}  // namespace bumpfoil
