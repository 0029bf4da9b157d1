#include "experiments/equilibrium/film_ross_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "experiments/vibration/ross_element.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view film_head =
    R"(# Linear coefficients of the running bearing, gas film and foils together, for rotor dynamics. [bearing.element] holds
# arguments of the constructor of BearingElement of ROSS, version {} (https://github.com/petrobras/ross): in Python 3.11
# or later
#
#     bearing = tomllib.load(open("coefficients.toml", "rb"))["bearing"][0]
#     ross.BearingElement(n=0, **bearing["element"])
#
# kxy = dF_x/dy (N/m), cxy = dF_x/d(dy/dt) (N s/m), F the applied force on the journal, X and Y those of the case file.
# contacts = "stuck": too small a motion to make any bump slip; "slipping": sliding contacts keep sliding.
)";

/// Explanation of the axes.
constexpr std::string_view axes_2 = R"(# frequency is the speed of the rotor (rad/s), as version 2 reads it.
)";
constexpr std::string_view axes_3 =
    R"(# speed is that of the rotor, frequency that of a small harmonic motion about the state (rad/s); tables over both have
# a row for each speed. [bearing.synchronous] has the same arguments at the frequency of the rotation only.
)";
constexpr std::string_view synchronous_only = "\n# synchronous: for unbalance response, not for stability";

using Impedance = std::optional<JournalMatrixC> FilmWhirl::*;

/// States of one path, load or position and direction of rotation, by increasing speed.
using StatesOverSpeed = std::vector<const RunningState*>;

std::vector<StatesOverSpeed> by_speed(const std::vector<RunningState>& states) {
  std::vector<StatesOverSpeed> groups;
  for (const RunningState& state : states) {
    if (!state.found() || !state.synchronous || state.requested.speed == 0.0) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&state](const StatesOverSpeed& one) {
      const RunningState& first = *one.front();
      return first.path == state.path && first.requested.control == state.requested.control &&
             first.requested.journal == state.requested.journal && first.requested.speed * state.requested.speed > 0.0;
    });
    if (group == groups.end()) {
      groups.push_back({&state});
    } else {
      group->push_back(&state);
    }
  }
  for (StatesOverSpeed& group : groups) {
    const auto slower = [](const RunningState* a, const RunningState* b) {
      return std::abs(a->requested.speed) < std::abs(b->requested.speed);
    };
    std::stable_sort(group.begin(), group.end(), slower);
    const auto same = [](const RunningState* a, const RunningState* b) {
      return a->requested.speed == b->requested.speed;
    };
    group.erase(std::unique(group.begin(), group.end(), same), group.end());
  }
  return groups;
}

/// At the rotation frequency, or at all tabulated ones.
std::vector<FilmWhirl> whirls_of(const RunningState& state, bool synchronous) {
  return synchronous ? std::vector{*state.synchronous} : state.tabulated;
}

/// States whose coefficients of one kind are all known.
StatesOverSpeed known(StatesOverSpeed states, Impedance impedance) {
  std::erase_if(states, [impedance](const RunningState* state) {
    const auto unknown = [impedance](const FilmWhirl& whirl) { return !(whirl.*impedance); };
    return unknown(*state->synchronous) || std::any_of(state->tabulated.begin(), state->tabulated.end(), unknown);
  });
  return states;
}

RossElement element_of(const StatesOverSpeed& states, Impedance impedance, bool synchronous) {
  RossElement element;
  for (const RunningState* state : states) {
    element.speeds.push_back(std::abs(state->requested.speed));
    for (const FilmWhirl& whirl : whirls_of(*state, synchronous)) {
      if (!synchronous && state == states.front()) element.frequencies.push_back(whirl.frequency);
      const Eigen::Matrix2cd in_plane = (whirl.*impedance)->topLeftCorner<2, 2>();  // ROSS bearings do not tilt
      element.stiffness.push_back(in_plane.real());
      element.damping.push_back(in_plane.imag() / whirl.frequency);
    }
  }
  return element;
}

/// The tables of one kind of contacts, for a version of ROSS.
std::string elements_toml(const StatesOverSpeed& states, Impedance impedance, int ross_version) {
  RossElement synchronous = element_of(states, impedance, true);
  if (ross_version == 2) {
    std::swap(synchronous.speeds, synchronous.frequencies);
    return std::string(synchronous_only) + toml_of(synchronous);
  }
  return toml_of(element_of(states, impedance, false)) + std::string(synchronous_only) +
         toml_of(synchronous, "synchronous");
}

}  // namespace

std::string film_ross_toml(const Case& input, const EquilibriumResult& result, std::string_view run_id) {
  const EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  const int ross_version = equilibrium.ross_version;
  std::string out = fmt::format(film_head, ross_version);
  out += ross_version == 2 ? axes_2 : axes_3;
  if (ross_version != 2 && equilibrium.frequencies.empty()) {
    out += "# The case names no frequencies: these reach from 0.2 times the lowest speed to 1.2 times the highest.\n";
  }
  out += fmt::format("\nsource = \"bumpfoil {} ({})\"\nrun_id = \"{}\"\n", version(), commit(), run_id);
  for (const StatesOverSpeed& all : by_speed(result.states)) {
    for (const auto& [contacts, impedance] :
         {std::pair{"stuck", &FilmWhirl::stuck_impedance}, std::pair{"slipping", &FilmWhirl::impedance}}) {
      const StatesOverSpeed states = known(all, impedance);
      if (states.empty()) continue;
      const OperatingPoint& requested = states.front()->requested;
      out += fmt::format("\n[[bearing]]\npath = \"{}\"\n{} = {}\n", name_of(states.front()->path),
                         requested.by_load() ? "load_N" : "position_m",
                         toml_list({requested.journal.x(), requested.journal.y()}));
      out += fmt::format("turns = \"{}\"\ncontacts = \"{}\"\n", requested.speed > 0.0 ? "from X to Y" : "from Y to X",
                         contacts);
      if (states.size() == 1) out += fmt::format("speed_rad_per_s = {}\n", toml_number(std::abs(requested.speed)));
      out += elements_toml(states, impedance, ross_version);
    }
  }
  return out;
}

}  // namespace bumpfoil
