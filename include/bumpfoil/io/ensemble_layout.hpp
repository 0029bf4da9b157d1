#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/ensemble/statistics.hpp"
#include "bumpfoil/io/result_quantities.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A quantity that is kept of every cycle of an ensemble.
struct EnsembleColumn {
  std::string name, unit, long_name;  ///< as in result.nc
  Form form{};
  std::string label{};  ///< on the terminal; empty where it is in the files only
  ShownUnit shown{};
  Undefined undefined{Undefined::unknown};
  std::function<double(const Cycle&, const Case&)> value{};
};

/// What is kept of a sample: a row of numbers, for each direction one for each column and then the loads of the bumps
/// at full displacement.
struct EnsembleLayout {
  std::vector<double> directions;       ///< of the case, rad
  std::vector<EnsembleColumn> columns;  ///< the first is the status
  std::size_t bumps{};

  [[nodiscard]] std::size_t per_cycle() const { return columns.size() + bumps; }
  [[nodiscard]] std::size_t width() const { return directions.size() * per_cycle(); }
  /// Place in the row of a column, or of a bump's load where those are counted on behind the columns.
  [[nodiscard]] std::size_t place(std::size_t direction, std::size_t column) const {
    return direction * per_cycle() + column;
  }
};

/// The layout of the ensemble of a case.
EnsembleLayout make_ensemble_layout(const Case& input);

/// The row of a sample, not a number where something is not known.
std::vector<double> make_ensemble_row(const EnsembleLayout& layout, const Case& sampled, const CycleResult& result);

}  // namespace bumpfoil
