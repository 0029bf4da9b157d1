#include "bumpfoil/model/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// Quantile of p <= 1/2, without cancellation.
double lower_quantile(double p) {
  // Abramowitz & Stegun, 26.2.23: within 4.5e-4 of the root; each step of Halley's method triples the digits.
  const double t = std::sqrt(-2.0 * std::log(p));
  double z = (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308))) - t;
  for (int i = 0; i < 3; ++i) {
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    const double newton = (normal_probability(z) - p) / density;
    z -= newton / (1.0 + 0.5 * z * newton);
  }
  return z;
}

/// Truncated between bounds, in the tail that avoids cancellation in both.
double truncated_quantile(const Distribution& distribution, double p) {
  const double lower = *distribution.lower / *distribution.sigma;
  const double upper = *distribution.upper / *distribution.sigma;
  const bool above = lower > 0.0;
  const double from = normal_probability(above ? -upper : lower);
  const double to = normal_probability(above ? -lower : upper);
  const double share = above ? 1.0 - p : p;
  const double z = normal_quantile(from + share * (to - from));
  return std::clamp(*distribution.sigma * (above ? -z : z), *distribution.lower, *distribution.upper);
}

/// Shifts the sections that have the dimension.
void shift(std::vector<BumpSection>& sections, std::optional<double> BumpSection::*own, double deviation) {
  for (BumpSection& section : sections) {
    if (section.*own) *(section.*own) += deviation;
  }
}

/// Shifts all bumps equally.
void shift(BumpFoil& foil, PerBump BumpFoil::*dimension, std::optional<double> BumpSection::*own, double deviation) {
  foil.*dimension = shifted(foil.*dimension, static_cast<std::size_t>(foil.bumps), deviation);
  shift(foil.sections, own, deviation);
}

/// Shifts all pads equally.
void shift(BearingDesign& bearing, PerBump BumpFoil::*dimension, std::optional<double> BumpSection::*own,
           double deviation) {
  shift(bearing.bump_foil, dimension, own, deviation);
  for (Pad& pad : bearing.pads) {
    if (pad.bump_foil) shift(*pad.bump_foil, dimension, own, deviation);
  }
}

constexpr auto scattered_number_table = std::to_array<ScatteredNumber>({
    {"bump_foil_thickness", "m", "deviation of the thickness of the bump foil",
     &MonteCarloSettings::bump_foil_thickness,
     [](BearingDesign& bearing, double deviation) {
       shift(bearing, &BumpFoil::thickness, &BumpSection::thickness, deviation);
       const auto shift_strips = [deviation](BumpFoil& foil) {
         for (FoilStrip& strip : foil.strip) {
           if (strip.thickness) *strip.thickness += deviation;
           shift(strip.sections, &BumpSection::thickness, deviation);
         }
       };
       shift_strips(bearing.bump_foil);
       for (Pad& pad : bearing.pads) {
         if (pad.bump_foil) shift_strips(*pad.bump_foil);
       }
     }},
    {"top_foil_thickness", "m", "deviation of the thickness of the top foil", &MonteCarloSettings::top_foil_thickness,
     [](BearingDesign& bearing, double deviation) {
       bearing.top_foil.thickness += deviation;
       for (Pad& pad : bearing.pads) {
         if (pad.top_foil) pad.top_foil->thickness += deviation;
       }
     }},
    {"bump_length", "m", "deviation of the chord of all bumps", &MonteCarloSettings::bump_length,
     [](BearingDesign& bearing, double deviation) {
       shift(bearing, &BumpFoil::length, &BumpSection::length, deviation);
     }},
    {"friction_top_bump", "1", "deviation of the friction coefficient between top foil and bumps",
     &MonteCarloSettings::friction_top_bump,
     [](BearingDesign& bearing, double deviation) { bearing.friction.top_bump += deviation; }},
    {"friction_bump_sleeve", "1", "deviation of the friction coefficient between bumps and sleeve",
     &MonteCarloSettings::friction_bump_sleeve,
     [](BearingDesign& bearing, double deviation) { bearing.friction.bump_sleeve += deviation; }},
    {"radial_clearance", "m", "deviation of the radial clearance", &MonteCarloSettings::radial_clearance,
     [](BearingDesign& bearing, double deviation) { bearing.bearing.radial_clearance += deviation; }},
    {"formed_radius", "m", "deviation of the radius that the top foil is formed to", &MonteCarloSettings::formed_radius,
     [](BearingDesign& bearing, double deviation) {
       if (deviation == 0.0) return;  // an unformed foil stays unformed
       const auto shift_of = [&](TopFoil& foil) {
         foil.formed_radius = {FormedTo::radius, formed_radius(foil.formed_radius, bearing.bearing) + deviation};
       };
       shift_of(bearing.top_foil);
       for (Pad& pad : bearing.pads) {
         if (pad.top_foil) shift_of(*pad.top_foil);
       }
     }},
});

}  // namespace

std::span<const ScatteredNumber> scattered_numbers() {
  return scattered_number_table;
}

double normal_probability(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

double normal_quantile(double p) {
  BUMPFOIL_ASSERT(p > 0.0 && p < 1.0);
  return p <= 0.5 ? lower_quantile(p) : -lower_quantile(1.0 - p);
}

double quantile(const Distribution& distribution, double p) {
  switch (distribution.kind) {
    case DistributionKind::normal:
      return *distribution.sigma * normal_quantile(p);
    case DistributionKind::truncated_normal:
      return truncated_quantile(distribution, p);
    case DistributionKind::uniform:
      return *distribution.lower + p * (*distribution.upper - *distribution.lower);
    case DistributionKind::table:
      break;
  }
  const auto size = static_cast<double>(distribution.values.size());
  return distribution.values[static_cast<std::size_t>(std::min(p * size, size - 1.0))];
}

}  // namespace bumpfoil
