#include "experiments/equilibrium/check_state.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <vector>

#include "bumpfoil/bearing/fields.hpp"
#include "experiments/equilibrium/small_motions.hpp"

namespace bumpfoil {
namespace {

/// Contacts below this load, N, may be open: if the stability of a state depends on them, it is doubtful.
constexpr double light_contact_load = 1e-3;
/// Range of tabulated frequencies over the speed: unstable rotor whirl is at about half the speed, and the speed itself
/// should lie inside. The ratios between them are equal, in a number that leaves at least nine frequencies in the range
/// of any speed, wherever the grid starts.
constexpr double lowest_frequency = 0.2;
constexpr double highest_frequency = 1.2;
constexpr double frequency_intervals = 9.0;

/// How a state responds to small motions: with sliding contacts that keep sliding, and with full stick.
struct Impedances {
  const BearingModel& bearing;
  std::optional<FilmImpedance> moving, stuck;

  /// @param rates  at which accuracy is ensured, 1/s
  Impedances(FilmStepper& stepper, const BearingState& state, const std::vector<std::complex<double>>& rates)
      : bearing(stepper.bearing()),
        moving(stepper.impedance(state, rates)),
        stuck(stepper.impedance(state, rates, true)) {}

  [[nodiscard]] std::vector<FilmWhirl> at(const std::vector<double>& frequencies) const {
    std::vector<FilmWhirl> whirls;
    for (const double frequency : frequencies) {
      FilmWhirl& whirl = whirls.emplace_back();
      whirl.frequency = frequency;
      if (moving) whirl.impedance = bearing.film->by_slopes(moving->at({0.0, frequency}));
      if (stuck) whirl.stuck_impedance = bearing.film->by_slopes(stuck->at({0.0, frequency}));
    }
    return whirls;
  }
};

std::vector<std::complex<double>> rates_of(const std::vector<double>& frequencies) {
  std::vector<std::complex<double>> rates;
  rates.reserve(frequencies.size());
  for (const double frequency : frequencies) rates.emplace_back(0.0, frequency);
  return rates;
}

/// None at rest, and if film and foils are unstable by themselves. @param held  with the same contact modes
std::optional<CriticalMass> critical_mass_of_state(const std::optional<FilmImpedance>& impedance, double speed,
                                                   const std::optional<HeldMotion>& held) {
  if (speed == 0.0 || !impedance || !held || held->rate.real() >= 0.0) return std::nullopt;
  return least_critical_mass(*impedance, speed);
}

/// Opens closed contacts with negligible load. @return their number
int open_light_contacts(ContactState& contacts) {
  int count = 0;
  for (std::size_t c = 0; c < contacts.mode.size(); ++c) {
    if (contacts.mode[c] == ContactMode::open ||
        contacts.normal_force[static_cast<Eigen::Index>(c)] >= light_contact_load) {
      continue;
    }
    contacts.mode[c] = ContactMode::open;
    ++count;
  }
  return count;
}

/// Adds the maximum stresses of all pads to a state.
void find_stresses(const BearingModel& bearing, RunningState& found) {
  const BearingState& state = *found.last;
  for (std::size_t k = 0; k < bearing.film->pads.size(); ++k) {
    const FilmPad& pad = bearing.film->pads[k];
    const double moment = pad.foil.stiffness * pad.foil.pitch * bearing.film->scales.thickness;
    const Vector of_lines = state.film.moment(Eigen::all, pad.columns()).cwiseAbs().rowwise().maxCoeff();
    const double top =
        moment * of_lines.cwiseQuotient(pad.foil.lines.weight).maxCoeff() / bearing.stress[k].top_section_modulus;
    found.top_foil_stress = std::max(found.top_foil_stress.value_or(0.0), top);
    const FoilStress stress = pad_stress(bearing, state.contacts.x, static_cast<int>(k));
    if (stress.bump_largest.size() == 0) continue;
    found.bump_foil_stress = std::max(
        {found.bump_foil_stress.value_or(0.0), stress.bump_largest.maxCoeff(), stress.bump_weld.value_or(0.0)});
  }
}

}  // namespace

void check_state(const SharedBearing& bearing, const EquilibriumSettings& settings, bool tabulates,
                 RunningState& found) {
  const auto begin = std::chrono::steady_clock::now();
  FilmStepper stepper(bearing);
  const BearingState& state = *found.last;
  found.outcome = film_bearing_outcome(*bearing, state);
  const auto moving = stepper.slow_motion(state);
  const auto stuck = stepper.slow_motion(state, true);
  if (moving) found.stiffness = bearing->film->by_slopes(moving->stiffness);
  if (stuck) found.stuck_stiffness = bearing->film->by_slopes(stuck->stiffness);
  if (moving || stuck) {
    found.foil_response = std::max(moving ? moving->foil_response : 0.0, stuck ? stuck->foil_response : 0.0);
  }
  found.held = stepper.held_motions(state);
  BearingState opened = state;
  found.light_contacts = open_light_contacts(opened.contacts);
  if (found.light_contacts > 0) found.held_if_open = stepper.held_motions(opened);
  const std::vector<double> frequencies = frequencies_of(settings, state.speed);
  const std::vector<double> tabulated = tabulates ? tabulated_frequencies(settings) : std::vector<double>{};
  // The slowest comes first: it is the last to converge, and the others need no earlier check.
  std::vector<std::complex<double>> rates = rates_of(tabulated);
  for (const auto& further : {rates_of(frequencies), whirling_rates(state.speed)}) {
    rates.insert(rates.end(), further.begin(), further.end());
  }
  const Impedances impedances(stepper, state, rates);
  found.critical_mass = critical_mass_of_state(impedances.moving, state.speed, found.held.sliding);
  found.stuck_critical_mass = critical_mass_of_state(impedances.stuck, state.speed, found.held.stuck);
  found.whirls = impedances.at(frequencies);
  if (tabulates) {
    found.synchronous = impedances.at({std::abs(state.speed)}).front();  // one of whirling_rates()
    found.tabulated = impedances.at(tabulated);
  }
  find_stresses(*bearing, found);
  found.wall_time += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<double> tabulated_frequencies(const EquilibriumSettings& equilibrium) {
  std::vector<double> frequencies = equilibrium.frequencies;
  if (frequencies.empty()) {
    double slowest = std::numeric_limits<double>::infinity();  // except rest
    double fastest = 0.0;
    for (const double speed : equilibrium.speeds) {
      if (speed != 0.0) slowest = std::min(slowest, std::abs(speed));
      fastest = std::max(fastest, std::abs(speed));
    }
    if (fastest == 0.0) return {};
    const double first = lowest_frequency * slowest;
    const double range = highest_frequency * fastest / first;
    // Minus round-off, so that a single speed does not add an interval.
    const double intervals =
        std::ceil(frequency_intervals * std::log(range) / std::log(highest_frequency / lowest_frequency) - 1e-9);
    for (double i = 0.0; i <= intervals; ++i) frequencies.push_back(first * std::pow(range, i / intervals));
  }
  std::sort(frequencies.begin(), frequencies.end());
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end()), frequencies.end());
  return frequencies;
}

}  // namespace bumpfoil
