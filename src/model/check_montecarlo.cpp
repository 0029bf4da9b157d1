#include "model/check_montecarlo.hpp"

#include <array>
#include <optional>
#include <tuple>
#include <utility>

#include "bumpfoil/model/scatter.hpp"

namespace bumpfoil {
namespace {

constexpr int most_samples = 1'000'000'000;
/// Waves shorter than this fraction of the circumference count as roughness.
constexpr int most_waves = 1000;
/// Bounds that retain less of a normal distribution are an input error.
constexpr double least_share = 1e-12;

/// Whether exactly the numbers that each kind needs are given.
bool check_parts(Checks& checks, const std::string& table, const Distribution& distribution) {
  const DistributionKind kind = distribution.kind;
  const bool normal = kind == DistributionKind::normal || kind == DistributionKind::truncated_normal;
  const bool bounded = kind == DistributionKind::uniform || kind == DistributionKind::truncated_normal;
  const bool tabled = kind == DistributionKind::table;
  const std::array parts{std::tuple{"std", distribution.sigma.has_value(), normal},
                         std::tuple{"lower", distribution.lower.has_value(), bounded},
                         std::tuple{"upper", distribution.upper.has_value(), bounded},
                         std::tuple{"values", !distribution.values.empty(), tabled}};
  bool right = true;
  for (const auto& [name, given, needed] : parts) {
    const std::string what =
        fmt::format("{} a distribution that is {}", given ? "is not used by" : "is missing in", name_of(kind));
    right = checks.require(given == needed, table + "." + name, "", what,
                           given ? "remove it, or give another distribution" : "give it") &&
            right;
  }
  return right;
}

void check_distribution(Checks& checks, const std::string& table, const Distribution& distribution,
                        std::string_view unit) {
  bool right = check_parts(checks, table, distribution);
  for (const auto& [name, value] : {std::pair{".std", distribution.sigma}, std::pair{".lower", distribution.lower},
                                    std::pair{".upper", distribution.upper}}) {
    right = (!value || checks.finite(table + name, *value, unit)) && right;
  }
  for (std::size_t i = 0; i < distribution.values.size(); ++i) {
    checks.finite(fmt::format("{}.values[{}]", table, i + 1), distribution.values[i], unit);
  }
  if (!right) return;
  if (distribution.sigma &&
      !checks.require(*distribution.sigma > 0.0, table + ".std", quantity(*distribution.sigma, unit),
                      "must be positive", "leave the table out where nothing scatters")) {
    return;
  }
  if (!distribution.lower) return;
  const double lower = *distribution.lower;
  const double upper = *distribution.upper;
  if (!checks.require(lower < upper, table + ".upper", quantity(upper, unit),
                      fmt::format("is not above the lower bound, {}", quantity(lower, unit)), "exchange them")) {
    return;
  }
  if (!distribution.sigma) return;
  const double from = lower / *distribution.sigma;
  const double to = upper / *distribution.sigma;
  const double share = from > 0.0 ? normal_probability(-from) - normal_probability(-to)
                                  : normal_probability(to) - normal_probability(from);
  checks.require(share >= least_share, table + ".lower", quantity(lower, unit),
                 "leaves almost nothing of the normal distribution between the bounds", "give bounds nearer to zero");
}

}  // namespace

void check_waves(Checks& checks, const std::string& table, int harmonic, double amplitude, double radius) {
  checks.require(harmonic >= 1 && harmonic <= most_waves, table + ".harmonic", std::to_string(harmonic),
                 "is not a valid number of waves around the circumference",
                 fmt::format("give a whole number from 1 to {}", most_waves));
  if (!checks.within(table + ".amplitude", amplitude, length_range) || radius <= 0.0) return;
  checks.require(amplitude <= thin * radius, table + ".amplitude", quantity(amplitude, "m"),
                 "is too large for this radius",
                 fmt::format("give at most {:.6g} m; is the unit right?", thin * radius));
}

void check_montecarlo(Checks& checks, const MonteCarloSettings& ensemble, double radius) {
  checks.require(ensemble.samples >= 1 && ensemble.samples <= most_samples, "montecarlo.samples",
                 std::to_string(ensemble.samples), "is not a valid number of samples",
                 fmt::format("give a whole number from 1 to {}", most_samples));
  checks.require(ensemble.seed >= 0, "montecarlo.seed", std::to_string(ensemble.seed), "must not be negative",
                 "give any whole number from 0 on");
  bool any = ensemble.bump_height || ensemble.sleeve_waviness;
  if (ensemble.bump_height) {
    check_distribution(checks, "montecarlo.bump_height", ensemble.bump_height->distribution, "m");
    const double length = ensemble.bump_height->correlation_length;
    if (length != 0.0) checks.within("montecarlo.bump_height.correlation_length", length, length_range);
  }
  for (const ScatteredNumber& number : scattered_numbers()) {
    const std::optional<Distribution>& distribution = ensemble.*number.distribution;
    if (!distribution) continue;
    any = true;
    check_distribution(checks, fmt::format("montecarlo.{}", number.name), *distribution,
                       number.unit == "1" ? std::string_view() : number.unit);
  }
  if (const auto& waves = ensemble.sleeve_waviness) {
    check_waves(checks, "montecarlo.sleeve_waviness", waves->harmonic, waves->amplitude, radius);
  }
  checks.require_for("montecarlo", any, "montecarlo", "", "nothing scatters: all bearings would be identical",
                     "give one at least, such as bump_height = { distribution = \"normal\", std = \"10 um\" }");
}

}  // namespace bumpfoil
