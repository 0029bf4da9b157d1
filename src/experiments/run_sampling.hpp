#pragma once

#include <string_view>
#include <vector>

#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

/// The quantities that ensembles keep, their status first.
template <typename Quantities>
auto sampled_of(const Quantities& quantities) {
  std::vector<typename Quantities::value_type> sampled;
  for (const bool status : {true, false}) {
    for (const auto& quantity : quantities) {
      if (quantity.is(tag::sampled) && (quantity.name == "status") == status) sampled.push_back(quantity);
    }
  }
  return sampled;
}

/// The one place of a sample whose run is kept as a whole.
struct WholeRun {
  VariableMeaning place;    ///< the dimension of ensemble.nc; the place has its name
  std::string_view plural;  ///< of what runs
  std::string_view target;  ///< EnsembleLayout::target
};

/// Of an experiment that can be swept: keeps the numbers of its result that have no dimension and are tagged as
/// sampled.
Sampling sampling_of_runs(const WholeRun& whole, const Sweeping& sweeping);

/// The same of a rotor.
Sampling rotor_sampling(std::string_view target, const Sweeping& sweeping);

}  // namespace bumpfoil
