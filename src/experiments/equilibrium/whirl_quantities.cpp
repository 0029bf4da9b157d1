#include "experiments/equilibrium/whirl_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Motions of the journal: displacements and slopes along X and Y.
constexpr std::string_view letters = "xyab";

/// The unit of a derivative of a force or, for moment rows, a moment, by a displacement or a slope.
std::string unit_of(Eigen::Index row, Eigen::Index column, bool damping) {
  const bool moment = row > 1;
  const bool slope = column > 1;
  const std::string force = moment && slope ? "N m" : "N";  // N m over m is N
  const std::string time = damping ? " s" : "";
  return force + time + (moment == slope ? (slope ? "/rad" : "/m") : (slope ? "/rad" : ""));
}

std::vector<WhirlQuantity> make_whirl_quantities(Eigen::Index motions) {
  std::vector<WhirlQuantity> quantities;
  for (const bool stuck : {false, true}) {
    const auto impedance = stuck ? &FilmWhirl::stuck_impedance : &FilmWhirl::impedance;
    const char* contacts = stuck ? "full stick" : "sliding contacts keep sliding";
    for (const bool damping : {false, true}) {
      for (Eigen::Index entry = 0; entry < motions * motions; ++entry) {
        const Eigen::Index row = entry / motions;
        const Eigen::Index column = entry % motions;
        const char to = letters[static_cast<std::size_t>(column)];
        const std::string motion = damping ? fmt::format("d(d{}/dt)", to) : fmt::format("d{}", to);
        const std::string force = row < 2 ? fmt::format("F_{}", letters[static_cast<std::size_t>(row)])
                                          : fmt::format("M_{}", letters[static_cast<std::size_t>(row) - 2]);
        quantities.push_back({.axes = {letters[static_cast<std::size_t>(row)], to},
                              .damping = damping,
                              .suffix = stuck ? "_stuck" : "",
                              .unit = unit_of(row, column, damping),
                              .long_name = fmt::format("d{}/{} at the frequency, {}", force, motion, contacts),
                              .value = [=](const FilmWhirl& whirl) {
                                if (!(whirl.*impedance)) return absent;
                                const std::complex<double> Z = (*(whirl.*impedance))(row, column);
                                return damping ? Z.imag() / whirl.frequency : Z.real();
                              }});
      }
    }
  }
  return quantities;
}

}  // namespace

const std::vector<WhirlQuantity>& whirl_quantities(Eigen::Index motions) {
  static const std::vector<WhirlQuantity> in_plane = make_whirl_quantities(2);
  static const std::vector<WhirlQuantity> with_tilt = make_whirl_quantities(4);
  return motions == 2 ? in_plane : with_tilt;
}

std::vector<double> common_frequencies(const EquilibriumSettings& settings, const EquilibriumResult& result) {
  if (result.bearing->bumps() == 0) return {};  // rigid or elastic surface without bumps
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
  for (const WhirlQuantity& quantity : whirl_quantities(result.bearing->film->motions())) {
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
