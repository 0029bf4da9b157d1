#include "pages/ensemble_reader.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Minimum number of bars of a histogram.
constexpr double fewest_bars = 8.0;
constexpr double most_bars = 60.0;

/// Number of bars of a histogram: width 2 IQR / n^(1/3), the rule of Freedman and Diaconis.
std::size_t bars_of(const std::vector<double>& sorted) {
  const std::size_t n = sorted.size();
  const double quartiles = sorted[3 * n / 4] - sorted[n / 4];
  const double width = 2.0 * quartiles / std::cbrt(static_cast<double>(n));
  const double bars = (sorted.back() - sorted.front()) / width;
  return static_cast<std::size_t>(std::isfinite(bars) ? std::clamp(std::ceil(bars), fewest_bars, most_bars)
                                                      : fewest_bars);
}

/// The numbers of a quantity: sample by sample, one per place each.
class Values {
 public:
  Values(std::vector<double> values, std::size_t places) : values_(std::move(values)), places_(places) {}

  [[nodiscard]] std::vector<double> known() const {
    std::vector<double> known;
    std::copy_if(values_.begin(), values_.end(), std::back_inserter(known),
                 [](double value) { return !std::isnan(value); });
    std::sort(known.begin(), known.end());
    return known;
  }

  /// Visits the numbers of a place in order, up to the requested count.
  template <typename Visitor>
  void for_each(std::size_t place, std::size_t samples, Visitor&& visit) const {
    for (std::size_t i = 0; i < std::min(samples, values_.size() / places_); ++i) {
      visit(values_[i * places_ + place]);
    }
  }

 private:
  std::vector<double> values_;
  std::size_t places_;
};

/// All places share the same bars, for comparison.
Json distribution_json(const Values& values, std::size_t places, std::size_t samples) {
  const std::vector<double> known = values.known();
  Json json{{"from", nullptr}, {"to", nullptr}, {"counts", Json::array()}, {"first", Json::array()}};
  const bool varies = !known.empty() && known.front() < known.back();
  if (!known.empty()) {
    json["from"] = known.front();
    json["to"] = known.back();
  }
  const std::size_t bars = varies ? bars_of(known) : 1;
  const double width = varies ? (known.back() - known.front()) / static_cast<double>(bars) : 1.0;
  for (std::size_t place = 0; place < places; ++place) {
    std::vector<std::size_t> counts(bars, 0);
    values.for_each(place, samples, [&](double value) {
      if (std::isnan(value)) return;
      const auto bar = static_cast<std::size_t>((value - known.front()) / width);
      ++counts[std::min(bar, bars - 1)];
    });
    Json first = Json::array();
    values.for_each(place, most_shown_samples,
                    [&](double value) { first.push_back(std::isnan(value) ? Json(nullptr) : Json(value)); });
    json["counts"].push_back(counts);
    json["first"].push_back(std::move(first));
  }
  return json;
}

}  // namespace

Json read_distributions(const NetcdfImage& file) {
  // Places are directions of cycles, states of running bearings, or the rotor.
  const bool turns = file.variables().contains("rotor");
  const bool runs = turns || file.variables().contains("state");
  const std::string place = turns ? "rotor" : runs ? "state" : "direction";
  const std::vector<double> places = file.numbers(file.variable(place, {place}));
  if (places.empty()) file.refuse(place, "is empty");
  const std::size_t samples = file.size_of("sample");
  Json distributions = Json::object();
  for (const auto& [name, variable] : file.variables()) {
    if (!variable.has_dims({"sample", place}) || !variable.flag_meanings.empty()) continue;
    const Values values(file.numbers(variable), places.size());
    distributions[name] = distribution_json(values, places.size(), samples);
    distributions[name]["unit"] = variable.units == "1" ? "" : variable.units;
    distributions[name]["text"] = variable.long_name;
  }
  return {{"directions", runs ? Json::array() : Json(places)},
          {"states", runs ? Json(places) : Json::array()},
          {"sample_count", samples},
          {"distributions", distributions}};
}

}  // namespace bumpfoil
