#include "io/film_ross_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "io/ross_element.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view film_head =
    R"(# Linear coefficients of the running bearing, gas film and foils together, for rotor dynamics. [bearing.element] holds
# arguments of the constructor of ROSS's BearingElement (https://github.com/petrobras/ross): in Python 3.11 or later
#
#     bearing = tomllib.load(open("coefficients.toml", "rb"))["bearing"][0]
#     ross.BearingElement(n=0, **bearing["element"])
#
# kxy = dF_x/dy (N/m), cxy = dF_x/d(dy/dt) (N s/m), F the force that holds the journal, X and Y those of the case file.
# speed is that of the rotor, frequency that of a small harmonic motion about the state (rad/s). contacts = "stuck": too
# small a motion to make any bump slip, as unbalance and stability ask for; "slipping": contacts that slipped slip on.
)";

using Impedance = std::optional<Eigen::Matrix2cd> FilmWhirl::*;

/// States of one path, load or position and sense of rotation, slow before fast.
using StatesOverSpeed = std::vector<const RunningState*>;

std::vector<StatesOverSpeed> by_speed(const std::vector<RunningState>& states) {
  std::vector<StatesOverSpeed> groups;
  for (const RunningState& state : states) {
    if (!state.found() || state.whirls.empty()) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&state](const StatesOverSpeed& one) {
      const RunningState& first = *one.front();
      return first.path == state.path && first.asked.control == state.asked.control &&
             first.asked.journal == state.asked.journal && first.asked.speed * state.asked.speed > 0.0;
    });
    if (group == groups.end()) {
      groups.push_back({&state});
    } else {
      group->push_back(&state);
    }
  }
  for (StatesOverSpeed& group : groups) {
    const auto slower = [](const RunningState* a, const RunningState* b) {
      return std::abs(a->asked.speed) < std::abs(b->asked.speed);
    };
    std::stable_sort(group.begin(), group.end(), slower);
    const auto same = [](const RunningState* a, const RunningState* b) { return a->asked.speed == b->asked.speed; };
    group.erase(std::unique(group.begin(), group.end(), same), group.end());
  }
  return groups;
}

/// Those whose coefficients of one kind are all known.
StatesOverSpeed known(StatesOverSpeed states, Impedance impedance) {
  std::erase_if(states, [impedance](const RunningState* state) {
    return std::any_of(state->whirls.begin(), state->whirls.end(),
                       [impedance](const FilmWhirl& whirl) { return !(whirl.*impedance); });
  });
  return states;
}

std::vector<FilmWhirl> by_frequency(std::vector<FilmWhirl> whirls) {
  std::stable_sort(whirls.begin(), whirls.end(),
                   [](const FilmWhirl& a, const FilmWhirl& b) { return a.frequency < b.frequency; });
  const auto same = [](const FilmWhirl& a, const FilmWhirl& b) { return a.frequency == b.frequency; };
  whirls.erase(std::unique(whirls.begin(), whirls.end(), same), whirls.end());
  return whirls;
}

/// @param states       one or more
/// @param synchronous  whether each state has the frequency of its speed alone
RossElement element_of(const StatesOverSpeed& states, Impedance impedance, bool synchronous) {
  RossElement element;
  for (const RunningState* state : states) {
    if (!synchronous && states.size() > 1) element.speeds.push_back(std::abs(state->asked.speed));
    for (const FilmWhirl& whirl : by_frequency(state->whirls)) {
      if (synchronous || state == states.front()) element.frequencies.push_back(whirl.frequency);
      element.stiffness.push_back((whirl.*impedance)->real());
      element.damping.push_back((whirl.*impedance)->imag() / whirl.frequency);
    }
  }
  return element;
}

}  // namespace

std::string film_ross_toml(const Case& input, const EquilibriumResult& result, std::string_view run_id) {
  const bool synchronous = input.equilibrium->frequencies.empty();
  std::string out(film_head);
  if (synchronous) out += "# The motion is synchronous whirl: each frequency is the speed of the rotor.\n";
  out += fmt::format("\nsource = \"bumpfoil {} ({})\"\nrun_id = \"{}\"\n", version(), commit(), run_id);
  for (const StatesOverSpeed& all : by_speed(result.states)) {
    for (const auto& [contacts, impedance] :
         {std::pair{"stuck", &FilmWhirl::stuck_impedance}, std::pair{"slipping", &FilmWhirl::impedance}}) {
      const StatesOverSpeed states = known(all, impedance);
      if (states.empty()) continue;
      const OperatingPoint& asked = states.front()->asked;
      out += fmt::format("\n[[bearing]]\npath = \"{}\"\n{} = {}\n", name_of(states.front()->path),
                         asked.control == OperatingPoint::Control::load ? "load_N" : "position_m",
                         toml_list({asked.journal.x(), asked.journal.y()}));
      out += fmt::format("turns = \"{}\"\ncontacts = \"{}\"\n", asked.speed > 0.0 ? "from X to Y" : "from Y to X",
                         contacts);
      if (states.size() == 1) out += fmt::format("speed_rad_per_s = {}\n", toml_number(std::abs(asked.speed)));
      out += toml_of(element_of(states, impedance, synchronous));
    }
  }
  return out;
}

}  // namespace bumpfoil
