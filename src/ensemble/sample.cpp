#include "bumpfoil/ensemble/sample.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "bumpfoil/ensemble/draws.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

/// Variables of DrawPlace, followed by those of scattered_numbers(). Changing the order would change the samples.
enum Drawn : std::uint32_t { height, waviness, first_number };

/// Correlation between the heights of a bump (from 0) and the previous one.
double correlation(const std::vector<BumpShape>& bumps, std::size_t bump, double correlation_length) {
  return std::exp(-0.5 * (bumps[bump - 1].pitch + bumps[bump].pitch) / correlation_length);
}

/// Appends the heights of a foil to those of previous pads and strips, with which they do not correlate.
void draw_heights(const HeightScatter& heights, const BumpFoil& foil, DrawPlace place,
                  std::vector<double>& deviations) {
  const bool correlated = heights.correlation_length > 0.0;
  const std::vector<BumpShape> shapes = correlated ? nominal_bumps(foil) : std::vector<BumpShape>{};
  const auto bumps = static_cast<std::size_t>(foil.bumps);
  deviations.reserve(deviations.size() + bumps);
  double score = 0.0;
  for (std::size_t bump = 0; bump < bumps; ++bump) {
    place.element = static_cast<std::uint32_t>(deviations.size());
    double probability = uniform_draw(place);
    if (correlated) {
      const double fresh = normal_quantile(probability);
      const double rho = bump == 0 ? 0.0 : correlation(shapes, bump, heights.correlation_length);
      score = rho * score + std::sqrt(1.0 - rho * rho) * fresh;
      probability = normal_probability(score);
    }
    deviations.push_back(quantile(heights.distribution, probability));
  }
}

/// Height errors of the bumps of one strip, or of all.
std::vector<double>& height_errors_of(BumpFoil& foil, std::size_t strip, std::size_t strips) {
  const auto bumps = static_cast<std::size_t>(foil.bumps);
  if (strips == 1) {
    foil.height_errors.resize(bumps);
    return foil.height_errors;
  }
  foil.strip.resize(strips);
  PerBump& own = foil.strip[strip].height_errors;
  own = listed(own, bumps);
  return own.values;
}

/// Adds the random errors to all bump heights: each pad then has its own bump foil.
void raise_bumps(BearingDesign& sampled, std::size_t strips, const std::vector<double>& deviations) {
  auto next = deviations.begin();
  for (std::size_t strip = 0; strip < strips; ++strip) {
    const auto raise = [&](BumpFoil& foil) {
      for (double& error : height_errors_of(foil, strip, strips)) error += *next++;
    };
    if (sampled.pads.empty()) raise(sampled.bump_foil);
    for (Pad& pad : sampled.pads) {
      if (!pad.bump_foil) pad.bump_foil = sampled.bump_foil;
      raise(*pad.bump_foil);
    }
  }
}

}  // namespace

Sample draw_sample(const Case& input, std::uint64_t number) {
  const MonteCarloSettings& ensemble = *input.montecarlo;
  DrawPlace place{
      .seed = static_cast<std::uint64_t>(ensemble.seed), .sample = number, .variable = height, .element = 0};
  Sample sample;
  if (ensemble.bump_height) {
    const std::vector<PlacedPad> pads = place_pads(input);
    for (std::size_t strip = 0; strip < strips_drawn_apart(input); ++strip) {
      for (const PlacedPad& pad : pads) {
        draw_heights(*ensemble.bump_height, pad.alone.bump_foil, place, sample.height_deviations);
      }
    }
  }
  place.variable = waviness;
  if (ensemble.sleeve_waviness) sample.waviness_phase = 2.0 * std::numbers::pi * uniform_draw(place);
  place.variable = first_number;
  for (const ScatteredNumber& number_of_case : scattered_numbers()) {
    const std::optional<Distribution>& distribution = ensemble.*number_of_case.distribution;
    sample.deviations.push_back(distribution ? quantile(*distribution, uniform_draw(place)) : 0.0);
    ++place.variable;
  }
  return sample;
}

std::size_t factor_count(const Case& input) {
  return factors_of(input, draw_sample(input, 0)).size();
}

std::vector<double> factors_of(const Case& input, const Sample& sample) {
  std::vector<double> factors = sample.height_deviations;
  for (std::size_t i = 0; i < sample.deviations.size(); ++i) {
    if ((*input.montecarlo).*scattered_numbers()[i].distribution) factors.push_back(sample.deviations[i]);
  }
  return factors;
}

Case sampled_case(const Case& input, const Sample& sample) {
  const auto deviate = [&](BearingDesign& design) {
    if (!sample.height_deviations.empty()) raise_bumps(design, strips_drawn_apart(input), sample.height_deviations);
    for (std::size_t i = 0; i < sample.deviations.size(); ++i) {
      scattered_numbers()[i].add(design, sample.deviations[i]);
    }
    if (const auto& waves = input.montecarlo->sleeve_waviness) {
      design.bearing.sleeve.waves = {{waves->harmonic, waves->amplitude, sample.waviness_phase}};
    }
  };
  Case sampled = input;
  sampled.montecarlo.reset();
  deviate(sampled);
  for (std::size_t i = 0; i < input.rotor_bearings.size(); ++i) {
    Case alone = bearing_at(input, i);
    deviate(alone);
    RotorBearing& own = sampled.rotor_bearings[i];
    own.bearing = alone.bearing;
    own.bump_foil = alone.bump_foil;
    own.top_foil = alone.top_foil;
    own.pads = alone.pads;
    own.friction = alone.friction;
  }
  return sampled;
}

}  // namespace bumpfoil
