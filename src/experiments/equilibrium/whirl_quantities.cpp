#include "experiments/equilibrium/whirl_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bumpfoil/results/quantity.hpp"
#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

std::vector<WhirlQuantity> make_whirl_quantities() {
  std::vector<WhirlQuantity> quantities;
  for (const bool stuck : {false, true}) {
    const auto impedance = stuck ? &FilmWhirl::stuck_impedance : &FilmWhirl::impedance;
    const char* contacts = stuck ? "full stick" : "sliding contacts keep sliding";
    for (const bool damping : {false, true}) {
      for (const auto& [axes, row, column] : matrix_entries) {
        const std::string motion = damping ? fmt::format("d(d{}/dt)", axes[1]) : fmt::format("d{}", axes[1]);
        quantities.push_back({.axes = std::string(axes),
                              .damping = damping,
                              .suffix = stuck ? "_stuck" : "",
                              .unit = damping ? "N s/m" : "N/m",
                              .long_name = fmt::format("dF_{}/{} at the frequency, {}", axes[0], motion, contacts),
                              .value = [=, i = row, j = column](const FilmWhirl& whirl) {
                                if (!(whirl.*impedance)) return absent;
                                const std::complex<double> Z = (*(whirl.*impedance))(i, j);
                                return damping ? Z.imag() / whirl.frequency : Z.real();
                              }});
      }
    }
  }
  return quantities;
}

}  // namespace

const std::vector<WhirlQuantity>& whirl_quantities() {
  static const std::vector<WhirlQuantity> quantities = make_whirl_quantities();
  return quantities;
}

std::vector<double> common_frequencies(const EquilibriumSettings& settings, const EquilibriumResult& result) {
  if (result.bearing->bumps() == 0) return {};  // a wall
  if (!settings.frequencies.empty()) return settings.frequencies;
  const bool tabulated = std::any_of(result.states.begin(), result.states.end(),
                                     [](const RunningState& state) { return !state.tabulated.empty(); });
  return tabulated ? tabulated_frequencies(settings) : std::vector<double>{};
}

const std::vector<FilmWhirl>& common_whirls(const EquilibriumSettings& settings, const RunningState& state) {
  return settings.frequencies.empty() ? state.tabulated : state.whirls;
}

void add_whirls(const EquilibriumSettings& settings, const EquilibriumResult& result, std::vector<std::string> dims,
                const std::vector<std::size_t>& places, Dataset& data) {
  const std::vector<double> frequencies = common_frequencies(settings, result);
  if (frequencies.empty()) return;
  const std::size_t count = frequencies.size();
  data.add_dimension({"frequency", "rad/s", "angular frequency of small motions about the state"}, frequencies);
  dims.emplace_back("frequency");
  for (const WhirlQuantity& quantity : whirl_quantities()) {
    std::vector<double> values(result.states.size() * count, absent);
    for (std::size_t i = 0; i < result.states.size(); ++i) {
      if (!result.states[i].found()) continue;
      const std::vector<FilmWhirl>& whirls = common_whirls(settings, result.states[i]);
      std::transform(whirls.begin(), whirls.end(), values.begin() + static_cast<std::ptrdiff_t>(places[i] * count),
                     quantity.value);
    }
    data.add({quantity.name("_at_frequency"), quantity.unit, quantity.long_name}, dims, std::move(values));
  }
}

}  // namespace bumpfoil
