#include "experiments/vibration/ross_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/core/version.hpp"
#include "experiments/vibration/ross_element.hpp"
#include "experiments/vibration/vibration_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t fewest_frequencies = 5;
constexpr int sampled_frequencies = 9;
/// Frequencies with a smaller relative difference are equal.
constexpr double same_frequency = 1e-9;

constexpr std::string_view head =
    R"(# Linear coefficients of the foils for rotor dynamics. [bearing.element] holds arguments of the constructor of ROSS's
# BearingElement (https://github.com/petrobras/ross): in Python 3.11 or later
#
#     bearing = tomllib.load(open("coefficients.toml", "rb"))["bearing"][0]
#     ross.BearingElement(n=0, **bearing["element"])
#
# These are the foils at rest, about one static load and with one amplitude of vibration. In a running machine they are
# in series with the gas film, which is not included: they do not describe a complete bearing.
#
# kxy = dF_x/dy (N/m), cxy = dF_x/d(dy/dt) (N s/m), F the applied force on the journal, X and Y those of the case file;
# frequency is that of the vibration (rad/s), not the speed of the rotor. Friction is independent of the rate: k are the
# same at all frequencies, c are proportional to 1/frequency.
)";

RossElement element_of(const LinearFoils& foils, const std::vector<double>& frequencies) {
  RossElement element{.speeds = {}, .frequencies = frequencies, .stiffness = {}, .damping = {}};
  element.stiffness.assign(frequencies.size(), foils.stiffness);
  element.damping.reserve(frequencies.size());
  for (const double frequency : frequencies) element.damping.push_back(foils.damping(frequency));
  return element;
}

}  // namespace

std::vector<double> exported_frequencies(std::vector<double> frequencies) {
  if (frequencies.size() < fewest_frequencies) {
    const auto [lowest, highest] = std::minmax_element(frequencies.begin(), frequencies.end());
    const double first = 0.5 * *lowest;
    const double ratio = std::pow(2.0 * *highest / first, 1.0 / (sampled_frequencies - 1));
    for (int i = 0; i < sampled_frequencies; ++i) frequencies.push_back(first * std::pow(ratio, i));
  }
  // Of two equal ones, the first is that of the case.
  std::stable_sort(frequencies.begin(), frequencies.end(),
                   [](double a, double b) { return a < b * (1.0 - same_frequency); });
  const auto same = [](double a, double b) { return b - a <= same_frequency * b; };
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end(), same), frequencies.end());
  return frequencies;
}

std::string ross_toml(const VibrationSettings& settings, const std::vector<LinearFoils>& all, std::string_view run_id) {
  const std::vector<double> frequencies = exported_frequencies(settings.frequencies);
  std::string out(head);
  if (frequencies.size() > settings.frequencies.size()) {
    out += fmt::format(
        "# The case gives {}; the others are added for interpolation, which needs at least {}.\n",
        settings.frequencies.size() == 1 ? "one frequency" : fmt::format("{} frequencies", settings.frequencies.size()),
        fewest_frequencies);
  }
  out += fmt::format("\nsource = \"bumpfoil {} ({})\"\nrun_id = \"{}\"\n", version(), commit(), run_id);
  for (const LinearFoils& foils : all) {
    if (!foils.stiffness.allFinite()) {
      out += fmt::format("\n# Load ({:.6g}, {:.6g}) N, amplitude {:.6g} m: some coefficients are missing.\n",
                         foils.load.x(), foils.load.y(), foils.amplitude);
      continue;
    }
    out += fmt::format("\n[[bearing]]\nload_N = {}\namplitude_m = {}\n", toml_list({foils.load.x(), foils.load.y()}),
                       toml_number(foils.amplitude));
    for (const LinearQuantity& quantity : linear_quantities()) {
      const double value = quantity.value(foils);
      if (std::isfinite(value)) out += fmt::format("{} = {}\n", quantity.name, toml_number(value));
    }
    out += toml_of(element_of(foils, frequencies));
  }
  return out;
}

}  // namespace bumpfoil
