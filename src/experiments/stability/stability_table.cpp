#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bumpfoil/results/quantity.hpp"
#include "core/number_text.hpp"
#include "experiments/stability/stability_quantities.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t most_speeds_shown = 40;
constexpr std::size_t whirl_column_width = 12;

std::string right_aligned(std::string_view text) {
  return fmt::format("{:>{}}", text, whirl_column_width);
}

std::string shown_number(double number, double size = 1.0) {
  return right_aligned(std::isfinite(number) ? number_text(number, size) : "-");
}

/// The fastest growing motion, and other quantities of the speed.
std::string speed_line(const StabilityResult& result, const SpeedPoint& point) {
  std::string out = shown_number(point.speed, shown::revolutions.size);
  const auto value = [&](std::string_view name) {
    const auto all = speed_quantities();
    const auto found =
        std::find_if(all.begin(), all.end(), [name](const SpeedQuantity& one) { return one.name == name; });
    return found->value(result, point);
  };
  if (point.status != Status::converged) return out + "  " + std::string(name_of(point.status)) + '\n';
  out += shown_number(value("h_min"), shown::micrometres.size);
  out += shown_number(value("growth")) + shown_number(value("whirl_ratio"));
  out += shown_number(value("least_log_decrement"));
  const bool known = point.sliding && !point.sliding->whirls.empty();
  const Whirl* const whirl = known ? &point.sliding->whirls.front() : nullptr;
  out += right_aligned(whirl == nullptr ? "-" : name_of(sense_of(*whirl)));
  out += right_aligned(whirl == nullptr ? "-" : whirl->is_of_foils() ? "foils" : "rotor");
  out += shown_number(value("growth_stuck")) + shown_number(value("growth_by_coefficients"));
  const std::optional<bool> stable = is_stable(point);
  return out + right_aligned(!stable ? "-" : *stable ? "yes" : "no") + '\n';
}

std::string onset_lines(const StabilityResult& result) {
  std::string out;
  for (const bool by_coefficients : {false, true}) {
    for (const bool stuck : {false, true}) {
      std::string line;
      for (const WhirlOnset& found : result.map.onsets) {
        if (found.stuck != stuck || found.by_coefficients != by_coefficients) continue;
        line += (line.empty() ? "" : "; ") + onset_text(found);
      }
      if (line.empty()) line = "none between these speeds";
      out += fmt::format("{}, contacts {}: {}\n", by_coefficients ? "by synchronous coefficients" : "onset of whirl",
                         stuck ? "stuck" : "sliding", line);
    }
  }
  return out;
}

}  // namespace

std::string stability_table(const StabilityResult& result) {
  std::string out;
  const auto row = [&out](std::initializer_list<std::string_view> cells) {
    for (const std::string_view cell : cells) out += right_aligned(cell);
    out += '\n';
  };
  row({"speed", "min. film", "growth", "whirl ratio", "log. decr.", "whirl", "motion of", "growth,", "growth by",
       "stable"});
  row({"rpm", "um", "per rad", "", "", "", "", "stuck", "sync. K, C", ""});
  const std::size_t shown = std::min(result.map.points.size(), most_speeds_shown);
  for (std::size_t i = 0; i < shown; ++i) out += speed_line(result, result.map.points[i]);
  if (shown < result.map.points.size()) {
    out += fmt::format("speeds {} to {} are in the files only\n", shown + 1, result.map.points.size());
  }
  return out + '\n' + onset_lines(result);
}

}  // namespace bumpfoil
