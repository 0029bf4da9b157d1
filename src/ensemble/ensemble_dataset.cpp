#include "ensemble/ensemble_dataset.hpp"

#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/model/pads.hpp"
#include "experiments/cycle/result_layout.hpp"

namespace bumpfoil {
namespace {

void add_places(const EnsembleLayout& layout, Dataset& data) {
  data.add_dimension(layout.place, each(layout.places, [](const EnsemblePlace& one) { return one.at; }));
  for (const PlaceCoordinate& coordinate : layout.coordinates) {
    data.add_coordinate(coordinate.meaning, {layout.place.name}, coordinate.values);
  }
}

/// Random numbers are regenerated. @param of  (sample) -> its numbers
template <typename Of>
void add_drawn(const Case& input, Dataset& data, VariableMeaning meaning, std::vector<std::string> over, const Of& of) {
  data.add(std::move(meaning), std::move(over)).rows = [&input, of](std::size_t first, std::size_t count) {
    std::vector<double> all;
    for (std::size_t i = first; i < first + count; ++i) {
      const std::vector<double> numbers = of(draw_sample(input, i));
      all.insert(all.end(), numbers.begin(), numbers.end());
    }
    return all;
  };
}

void add_deviations(const Case& input, Dataset& data) {
  const MonteCarloSettings& ensemble = *input.montecarlo;
  if (ensemble.bump_height) {
    std::vector<std::string> over{"sample", "bump"};
    if (strips_drawn_apart(input) > 1) over.insert(over.begin() + 1, "strip");
    add_drawn(input, data, {"bump_height_deviation", "m", "deviation of the height of the bump"}, std::move(over),
              [](const Sample& sample) { return sample.height_deviations; });
  }
  for (std::size_t i = 0; i < scattered_numbers().size(); ++i) {
    const ScatteredNumber& number = scattered_numbers()[i];
    if (!(ensemble.*number.distribution)) continue;
    add_drawn(input, data,
              {std::string(number.name) + "_deviation", std::string(number.unit), std::string(number.long_name)},
              {"sample"}, [i](const Sample& sample) { return std::vector{sample.deviations[i]}; });
  }
  if (ensemble.sleeve_waviness) {
    add_drawn(input, data, {"sleeve_waviness_phase", "rad", "phase of the waves of the sleeve"}, {"sample"},
              [](const Sample& sample) { return std::vector{sample.waviness_phase}; });
  }
}

/// The given number of log columns per place, from a first one on.
void add_logged(const EnsembleLayout& layout, const RowLog& log, std::size_t column, std::size_t columns,
                Variable& variable) {
  variable.rows = [&layout, &log, column, columns](std::size_t first, std::size_t count) {
    const std::size_t stride = layout.places.size() * columns;
    std::vector<double> all(count * stride);
    for (std::size_t place = 0; place < layout.places.size(); ++place) {
      for (std::size_t k = 0; k < columns; ++k) {
        const std::vector<double> values = log.column(layout.entry(place, column + k), first, count);
        for (std::size_t i = 0; i < count; ++i) all[i * stride + place * columns + k] = values[i];
      }
    }
    return all;
  };
}

}  // namespace

Dataset ensemble_dataset(const Case& input, const EnsembleLayout& layout, const RowLog& log) {
  Dataset data;
  data.add_dimension({"sample", "1", "number of the sample; its bearing depends on seed and number only", whole_number},
                     numbers_from(0.0, log.rows()));
  add_places(layout, data);
  data.add_dimension(
      {"bump", "1",
       count_pads(input) > 1 ? "number of the bump from the weld, pad after pad" : "number of the bump from the weld",
       whole_number},
      numbers_from(1.0, layout.bumps));
  if (const std::size_t strips = strips_drawn_apart(input); strips > 1) {
    data.add_dimension({"strip", "1", "strip of the bump foil, from the side z < 0 on", whole_number},
                       numbers_from(1.0, strips));
  }
  for (const NamedNumbers& geometry : make_bearing_layout(input).at_bumps) {
    data.add_coordinate({geometry.name, geometry.unit, geometry.long_name}, {"bump"}, geometry.values);
  }
  add_deviations(input, data);
  data.attributes = {{"sampled_command", input.montecarlo->command}, {"target_quantity", std::string(layout.target)}};
  const std::string& place = layout.place.name;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    add_logged(layout, log, k, 1, data.add(layout.columns[k].meaning, {"sample", place}));
  }
  if (layout.loads() == 0) return data;
  add_logged(layout, log, layout.columns.size(), layout.loads(),
             data.add({"bump_load", "N", std::string(layout.load)}, {"sample", place, "bump"}));
  return data;
}

}  // namespace bumpfoil
