#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "experiments/rotor_speeds.hpp"
#include "experiments/transient/step_row.hpp"
#include "experiments/transient/transient_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::array<std::string_view, 2> spectrum_axes{"X", "Y"};

/// Values of several columns over some rows, row by row.
std::vector<double> columns_of(const StepTable& steps, const std::vector<std::size_t>& columns, std::size_t first,
                               std::size_t count) {
  std::vector<double> values(count * columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::vector<double> column = steps.column(columns[i], first, count);
    for (std::size_t row = 0; row < count; ++row) values[row * columns.size() + i] = column[row];
  }
  return values;
}

void add_steps(const TransientResult& result, Dataset& data) {
  const std::size_t rows = result.steps->rows();
  data.dims.push_back({.name = "step", .size = rows, .grows = true});
  const auto add = [&](const VariableMeaning& meaning, std::vector<std::string> over,
                       std::vector<std::size_t> columns) {
    Variable& variable = data.add(meaning, std::move(over));
    variable.compressed = true;
    variable.known = true;
    variable.rows = [steps = result.steps, columns = std::move(columns)](std::size_t first, std::size_t count) {
      return columns_of(*steps, columns, first, count);
    };
  };
  for (std::size_t i = 0; i < step_quantities().size(); ++i) add(step_quantities()[i].meaning(), {"step"}, {i});
  for (std::size_t i = 0; i < place_quantities().size(); ++i) {
    std::vector<std::size_t> columns;
    columns.reserve(result.layout.places);
    for (std::size_t place = 0; place < result.layout.places; ++place) {
      columns.push_back(place_column(place, i));
    }
    add(place_quantities()[i].meaning(), {"step", "station"}, std::move(columns));
  }
  for (std::size_t i = 0; i < bearing_quantities().size(); ++i) {
    std::vector<std::size_t> columns;
    columns.reserve(result.layout.bearings);
    for (std::size_t bearing = 0; bearing < result.layout.bearings; ++bearing) {
      columns.push_back(bearing_column(result.layout, bearing, static_cast<BearingColumn>(i)));
    }
    add(bearing_quantities()[i].meaning(), {"step", "bearing"}, std::move(columns));
  }
}

TurnView view_of(const TransientTurn& revolution, std::size_t place) {
  return {revolution, revolution.places[place],
          place < revolution.bearings.size() ? &revolution.bearings[place] : nullptr};
}

void add_turns(const TransientReading& reading, Dataset& data) {
  data.add_dimension({"revolution", "1", "whole revolution of the rotor", {Form::whole}},
                     numbers_from(1.0, reading.turns.size()));
  for (const WholeTurnQuantity& quantity : whole_turn_quantities()) {
    data.add(quantity.meaning(), {"revolution"}, each(reading.turns, quantity.value));
  }
  for (const TurnQuantity& quantity : turn_quantities()) {
    data.add(quantity.meaning(), {"revolution", "station"}, [&reading, quantity] {
      std::vector<double> values;
      values.reserve(reading.turns.size() * reading.result.layout.places);
      for (const TransientTurn& revolution : reading.turns) {
        for (std::size_t i = 0; i < revolution.places.size(); ++i)
          values.push_back(quantity.value(view_of(revolution, i)));
      }
      return values;
    });
  }
}

void add_orders(const Waterfall& waterfall, Dataset& data) {
  data.add_dimension({"order", "1", "frequency over that of rotation"}, waterfall.orders);
  data.add_dimension({"axis", "", "direction", {Form::flag, spectrum_axes}}, numbers_from(0.0, spectrum_axes.size()));
}

void add_waterfall(const TransientReading& reading, Dataset& data) {
  const Waterfall& waterfall = reading.waterfall;
  data.add_dimension({"spectrum", "1", "spectrum of the motion over some revolutions", {Form::whole}},
                     numbers_from(1.0, waterfall.times.size()));
  add_orders(waterfall, data);
  data.add({"spectrum_time", "s", "middle of the spectrum"}, {"spectrum"}, waterfall.times);
  data.add({"spectrum_speed", "rad/s", "mean speed in the spectrum"}, {"spectrum"}, waterfall.speeds);
  Variable& amplitudes = data.add({"spectrum_amplitude", "m", "amplitude of a sine wave at the order"},
                                  {"spectrum", "station", "axis", "order"}, waterfall.amplitudes);
  amplitudes.compressed = true;
}

}  // namespace

Dataset run_dataset(const TransientReading& reading) {
  Dataset data;
  for (const RunQuantity& quantity : run_quantities()) {
    data.add(quantity.meaning(), {}, std::vector<double>{quantity.value(reading)});
  }
  return data;
}

Dataset swept_dataset(const TransientReading& reading) {
  Dataset data = run_dataset(reading);
  const Waterfall& waterfall = reading.waterfall;
  const std::vector<RotorStation> places = reading.result.machine.places();
  add_stations(places, data);
  add_orders(waterfall, data);
  const std::size_t size = places.size() * spectrum_axes.size() * waterfall.orders.size();
  std::vector<double> last(size, absent);
  if (!waterfall.times.empty()) {
    std::copy(waterfall.amplitudes.end() - static_cast<std::ptrdiff_t>(size), waterfall.amplitudes.end(), last.begin());
  }
  data.add({"last_spectrum_speed", "rad/s", "mean speed in the last spectrum"}, {},
           std::vector<double>{waterfall.speeds.empty() ? absent : waterfall.speeds.back()});
  data.add({"last_spectrum_amplitude", "m", "amplitude of a sine wave at the order, in the last spectrum"},
           {"station", "axis", "order"}, std::move(last));
  return data;
}

Dataset transient_dataset(const TransientReading& reading) {
  const TransientResult& result = reading.result;
  Dataset data = run_dataset(reading);
  add_stations(result.machine.places(), data);
  add_bearing_numbers(result.layout.bearings, data);
  if (result.steps && result.steps->rows() > 0) add_steps(result, data);
  add_turns(reading, data);
  add_waterfall(reading, data);
  return data;
}

Table revolution_table(const TransientReading& reading) {
  std::vector<std::string> columns = names_of(whole_turn_quantities(), {"revolution"});
  columns.emplace_back("station");
  return table_of(transient_dataset(reading),
                  {.over = {"revolution", "station"}, .columns = names_of(turn_quantities(), std::move(columns))});
}

}  // namespace bumpfoil
