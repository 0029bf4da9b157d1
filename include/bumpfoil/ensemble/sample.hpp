#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// How one bearing of an ensemble differs from its case. A plain value.
struct Sample {
  std::vector<double> height_deviations;  ///< m, one per bump, of strips_drawn_apart() strip after strip; empty
                                          ///< where heights do not scatter
  std::vector<double> deviations;         ///< SI, one for each of scattered_numbers(); zero where it does not scatter
  double waviness_phase{};                ///< of the waves of the sleeve, rad

  bool operator==(const Sample&) const = default;
};

/// Draws the sample of this number: a function of the case, its seed and the number alone.
///
/// Heights that are correlated along the foil are a Gaussian copula: their normal scores z are a stationary
/// Gauss-Markov sequence, with the pitch p and the correlation length l
///
///     z_1 = e_1,   z_i = rho z_(i-1) + sqrt(1 - rho^2) e_i,   rho = exp(-p / l)
///
/// of independent standard normal e, and each height is the quantile of its distribution at the probability of its z.
/// @pre  the case is valid and has an ensemble
Sample draw_sample(const Case& input, std::uint64_t number);

/// Factors whose sensitivities are requested: the heights of the bumps where they scatter, and each of
/// scattered_numbers() that does. The phase of waves is none, as it has no largest value.
std::size_t factor_count(const Case& input);
std::vector<double> factors_of(const Case& input, const Sample& sample);

/// The case of a bearing of the ensemble: deviations are added to what the case says, and waves take the place of those
/// of its sleeve. It has no ensemble itself, and need not be valid.
Case sampled_case(const Case& input, const Sample& sample);

}  // namespace bumpfoil
