#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// A limit that a quantity of every bearing must meet, in every direction.
struct EnsembleLimit {
  std::string text;      ///< as it was written
  std::size_t column{};  ///< of the layout
  bool above{};          ///< the quantity must be above the bound, else below
  double bound{};        ///< SI
};

/// Reads limits such as "clearance_5N > 20 um" or "max_force < 900": quantity, > or <, and a number with a unit or in
/// SI.
/// @throws Error (input) with every error
std::vector<EnsembleLimit> parse_limits(const std::vector<std::string>& texts, const EnsembleLayout& layout);

/// How many of the bearings keep their limits.
struct Yield {
  std::size_t passed{};
  std::size_t samples{};
  double low{}, high{};  ///< Wilson's 95 % interval of the part that passes [Wilson1927]
};

/// The limits of an ensemble, and how many bearings meet them.
struct EnsembleYields {
  std::vector<EnsembleLimit> limits;
  std::vector<Yield> each;  ///< of each limit by itself
  Yield all;                ///< of all together
};

/// Counts them. A bearing passes if it meets the limit in every direction; one that did not converge does not pass. A
/// clearance that was never taken up is larger than any bound.
EnsembleYields make_yields(std::vector<EnsembleLimit> limits, const EnsembleLayout& layout, const RowLog& log);

/// The same of rows that are elsewhere. @param values_of_entry  values of all samples in this place of their rows
EnsembleYields make_yields(std::vector<EnsembleLimit> limits, const EnsembleLayout& layout, std::size_t samples,
                           const std::function<std::vector<double>(std::size_t entry)>& values_of_entry);

/// A line for people: "yield: 93 of 100 bearings, 93.0 % (86.3 to 96.6 %)"; nothing where there are no limits.
std::string yield_text(const EnsembleYields& yields);

}  // namespace bumpfoil
