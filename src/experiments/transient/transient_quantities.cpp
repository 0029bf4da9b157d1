#include "experiments/transient/transient_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/motion/response.hpp"
#include "experiments/rotor_speeds.hpp"
#include "experiments/transient/step_row.hpp"

namespace bumpfoil {
namespace {

using namespace tag;  // NOLINT(google-build-using-namespace): for the tables below

/// Largest accepted defect of the energy balance, relative to the energy exchanged.
constexpr double largest_energy_defect = 0.05;
/// Fraction of the entrained work below which the defect is round-off.
constexpr double rounded_work = 1e-9;

template <int axis>
double turn_amplitude(const TurnView& view) {
  return std::abs(view.place.orbit.once[axis]);
}
template <int axis>
double turn_phase(const TurnView& view) {
  return to_degrees(std::arg(view.place.orbit.once[axis]));
}
template <int axis>
double turn_twice(const TurnView& view) {
  return std::abs(view.place.orbit.twice[axis]);
}
template <int axis>
double turn_half(const TurnView& view) {
  return view.place.half ? std::abs((*view.place.half)[axis]) : absent;
}
template <int axis>
double turn_range(const TurnView& view) {
  return view.place.orbit.half_peak_to_peak[axis];
}
template <int axis>
double turn_mean(const TurnView& view) {
  return view.place.orbit.mean[axis];
}
template <int axis>
double turn_end(const TurnView& view) {
  return view.place.at_end[axis];
}

constexpr auto turn_quantity_table = std::to_array<TurnQuantity>({
    {"amplitude_x", "m", "amplitude along X at the rotation frequency", turn_amplitude<0>, csv | shown_first,
     "amplitude, X", shown::micrometres},
    {"phase_x", "degree", "phase of X in x = Re(X exp(i a)), a the magnitude of the angle of the rotor", turn_phase<0>,
     csv, "phase, X"},
    {"amplitude_y", "m", "amplitude along Y at the rotation frequency", turn_amplitude<1>, csv, "amplitude, Y",
     shown::micrometres},
    {"phase_y", "degree", "phase of Y in y = Re(Y exp(i a)), a the magnitude of the angle of the rotor", turn_phase<1>,
     csv, "phase, Y"},
    {"half_peak_to_peak_x", "m", "half of the peak-to-peak displacement along X", turn_range<0>,
     csv | shown_first | leading, "half peak-to-peak, X", shown::micrometres},
    {"half_peak_to_peak_y", "m", "half of the peak-to-peak displacement along Y", turn_range<1>, csv,
     "half peak-to-peak, Y", shown::micrometres},
    {"amplitude_x_half", "m",
     "amplitude along X at half the rotation frequency, of two revolutions with this one in their middle", turn_half<0>,
     csv | shown_first, "amplitude at half the speed, X"},
    {"amplitude_y_half", "m",
     "amplitude along Y at half the rotation frequency, of two revolutions with this one in their middle", turn_half<1>,
     csv, "amplitude at half the speed, Y"},
    {"amplitude_x_2x", "m", "amplitude along X at twice the rotation frequency", turn_twice<0>, csv,
     "amplitude at twice the speed, X"},
    {"amplitude_y_2x", "m", "amplitude along Y at twice the rotation frequency", turn_twice<1>, csv,
     "amplitude at twice the speed, Y"},
    {"mean_x", "m", "mean of the position along X", turn_mean<0>, csv, "mean position, X"},
    {"mean_y", "m", "mean of the position along Y", turn_mean<1>, csv, "mean position, Y"},
    {"section_x", "m", "position along X at the end of the revolution: of a Poincare section", turn_end<0>, csv,
     "position at the end, X"},
    {"section_y", "m", "position along Y at the end of the revolution: of a Poincare section", turn_end<1>, csv,
     "position at the end, Y"},
    {"thinnest_film", "m", "minimum film thickness of the bearing in the revolution",
     [](const TurnView& view) { return view.bearing == nullptr ? absent : view.bearing->thinnest; }, csv | shown_first,
     "minimum film thickness", shown::micrometres},
    {"mean_power", "W", "mean power of the film of the bearing in the revolution",
     [](const TurnView& view) { return view.bearing == nullptr ? absent : view.bearing->power; }, csv, "power",
     shown::watts},
    {"largest_asperity_load", "N", "largest force that asperities of the bearing carry in the revolution",
     [](const TurnView& view) { return view.bearing == nullptr ? absent : view.bearing->asperity_load; },
     csv | shown_first, "largest asperity load"},
});

template <double WorkBalance::*term>
double turn_energy(const TransientTurn& revolution) {
  return revolution.energy.*term;
}

constexpr auto whole_turn_quantity_table = std::to_array<WholeTurnQuantity>({
    {"revolution_time", "s", "time at the end of the revolution",
     [](const TransientTurn& revolution) { return revolution.time; }, shown_first, "time"},
    {"revolution_speed", "rad/s", "mean speed in the revolution",
     [](const TransientTurn& revolution) { return revolution.speed; }, shown_first, "speed"},
    {"revolution_force_work", "J", "work of weight, unbalance, pulses and base on the rotor in the revolution",
     turn_energy<&WorkBalance::forces>, none, "work of forces"},
    {"revolution_rubbing_work", "J", "work of the friction of asperities on the motion of the rotor in the revolution",
     turn_energy<&WorkBalance::rubbing>, none, "work of rubbing"},
    {"revolution_film_work", "J",
     "work of the films on the rotor and its foils in the revolution: entrained and supplied less dissipated",
     [](const TransientTurn& revolution) { return revolution.energy.films(); }, none, "work of films"},
    {"revolution_film_dissipation", "J",
     "dissipated by the flow of the films under gradients of pressure in the revolution",
     turn_energy<&WorkBalance::dissipated>, none, "dissipation of films"},
    {"revolution_friction_loss", "J", "energy dissipated by friction of the foils in the revolution",
     turn_energy<&WorkBalance::friction>, none, "friction loss of foils"},
    {"revolution_rotor_damping_loss", "J", "energy dissipated by damping of the rotor in the revolution",
     turn_energy<&WorkBalance::damping>, none, "damping loss of the rotor"},
    {"revolution_stored_energy", "J", "change of the energy of motion, of films, foils and asperities",
     turn_energy<&WorkBalance::stored>, none, "stored energy"},
    {"energy_defect", "J", "defect of the energy balance of the revolution: the error of the time steps",
     [](const TransientTurn& revolution) { return revolution.energy.defect(); }, none, "defect of the balance"},
});

/// Maximum over all turns and bearings; NaN if there is none.
template <typename Value>
double largest_of(const TransientReading& reading, const Value& value) {
  double largest = absent;
  for (const TransientTurn& revolution : reading.turns) {
    for (std::size_t i = 0; i < revolution.bearings.size(); ++i) {
      largest = std::fmax(largest, value(revolution, i));
    }
  }
  return largest;
}

constexpr auto run_quantity_table = std::to_array<RunQuantity>({
    {"status",
     "",
     "how the march ended",
     [](const TransientReading& reading) { return static_cast<double>(reading.result.status); },
     sampled,
     "",
     {},
     search_status},
    {"end_time", "s", "time that was reached", [](const TransientReading& reading) { return reading.result.time; },
     sampled},
    {"end_speed", "rad/s", "speed at the end", [](const TransientReading& reading) { return reading.result.speed; },
     sampled},
    {"largest_half_peak_to_peak", "m",
     "largest half peak-to-peak displacement of a journal along X or Y in a revolution",
     [](const TransientReading& reading) {
       return largest_of(reading, [](const TransientTurn& revolution, std::size_t i) {
         return revolution.places[i].orbit.half_peak_to_peak.maxCoeff();
       });
     },
     headline | csv | sampled | leading, "largest half peak-to-peak", shown::micrometres},
    {"largest_amplitude_half", "m",
     "largest amplitude of a journal along X or Y at half the rotation frequency: half-speed whirl",
     [](const TransientReading& reading) {
       return largest_of(reading, [](const TransientTurn& revolution, std::size_t i) {
         const auto& amplitudes = revolution.places[i].half;
         return amplitudes ? amplitudes->cwiseAbs().maxCoeff() : absent;
       });
     },
     csv | sampled, "amplitude at half speed", shown::micrometres},
    {"thinnest_film_of_run", "m", "minimum film thickness of all bearings in all revolutions",
     [](const TransientReading& reading) {
       return -largest_of(
           reading, [](const TransientTurn& revolution, std::size_t i) { return -revolution.bearings[i].thinnest; });
     },
     headline | csv | sampled, "minimum film thickness", shown::micrometres},
    {"largest_asperity_load_of_run", "N", "largest force that asperities of a bearing carry",
     [](const TransientReading& reading) {
       return largest_of(reading, [](const TransientTurn& revolution, std::size_t i) {
         return revolution.bearings[i].asperity_load;
       });
     },
     headline | csv | sampled, "largest asperity load", shown::newtons},
    {"rub_count", "1", "number of intervals in which a journal rubs on its foils",
     [](const TransientReading& reading) { return static_cast<double>(reading.rubs.size()); }, csv | sampled, "rubs",
     shown::unitless, whole_number},
    {"friction_loss_of_run", "J", "energy dissipated by friction of the foils in all whole revolutions",
     [](const TransientReading& reading) { return reading.energy.sum.friction; }, headline | csv | sampled,
     "friction loss", shown::millijoules},
    {"energy_defect_of_run", "1",
     "sum of the magnitudes of the energy defects over the energy supplied, dissipated or stored, whichever is largest",
     [](const TransientReading& reading) { return reading.energy.relative(); }, of_solver | sampled},
});

}  // namespace

std::span<const TurnQuantity> turn_quantities() {
  return turn_quantity_table;
}
std::span<const WholeTurnQuantity> whole_turn_quantities() {
  return whole_turn_quantity_table;
}
std::span<const RunQuantity> run_quantities() {
  return run_quantity_table;
}

TransientReading::TransientReading(TransientResult made)
    : result(std::move(made)),
      turns(turns_of(result)),
      rubs(rubs_of(result)),
      waterfall(waterfall_of(result)),
      energy(energy_check(turns)) {}

std::vector<std::string> failure_lines(const TransientReading& reading) {
  const TransientResult& result = reading.result;
  if (result.status == Status::converged || result.status == Status::interrupted) return {};
  if (!result.steps || result.steps->rows() == 0) {
    return {fmt::format("no equilibrium found to start from, at {}: {}", rotor_speed_text(result.speed),
                        explanation(result.status))};
  }
  return {fmt::format("the march ends after {:.6g} s, at {}, revolution {}: {}", result.time,
                      rotor_speed_text(result.speed), reading.turns.size() + 1, explanation(result.status))};
}

std::vector<std::string> warning_lines(const Case& input, const TransientReading& reading) {
  std::vector<std::string> lines = rotor_case_warnings(input);
  const EnergyCheck& energy = reading.energy;
  if (energy.defect > largest_energy_defect * energy.largest &&
      energy.defect > rounded_work * std::abs(energy.sum.entrained)) {
    lines.push_back(fmt::format("the balance of energy is met to {:.2g} % only: give more steps per revolution",
                                100.0 * energy.relative()));
  }
  if (!reading.rubs.empty()) {
    const auto worst = std::max_element(reading.rubs.begin(), reading.rubs.end(),
                                        [](const RubEvent& a, const RubEvent& b) { return a.load < b.load; });
    lines.push_back(fmt::format(
        "journals touch foils in {} intervals: from {:.4g} s on asperities of bearing {} carry up to {:.3g} N",
        reading.rubs.size(), worst->begin, worst->bearing + 1, worst->load));
  }
  return lines;
}

}  // namespace bumpfoil
