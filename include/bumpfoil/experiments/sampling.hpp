#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

/// How experiments are run for the bearings of an ensemble.
namespace bumpfoil {

/// Where numbers of a sample are kept: the direction of a cycle, or a state in which it runs; of a rotor there is one
/// place, over all its speeds.
struct EnsemblePlace {
  std::string name;  ///< "+X", or "45000 rpm, load (50, 0) N", or "rotor"
  double at{};       ///< along the dimension of ensemble.nc
};

/// Further numbers of all places in ensemble.nc.
struct PlaceCoordinate {
  VariableMeaning meaning;
  std::vector<double> values;
};

/// A quantity that is kept at every place.
struct EnsembleColumn {
  VariableMeaning meaning;  ///< with a label where it is on the terminal
  Undefined undefined{Undefined::unknown};
};

/// What is kept of a sample: a row of numbers, at each place one for each column and then the loads of the bumps.
struct EnsembleLayout {
  VariableMeaning place;    ///< what the places are: the dimension of ensemble.nc
  std::string_view plural;  ///< "cycles": what fails at places
  std::vector<EnsemblePlace> places;
  std::vector<PlaceCoordinate> coordinates{};
  std::vector<EnsembleColumn> columns;  ///< the first is the status, zero where the place was reached
  std::string_view target;              ///< name of the column whose mean --target-error refers to
  std::string_view load{};              ///< long name of the loads of bumps; empty: none are kept
  std::size_t bumps{};                  ///< of the bearing; make_ensemble_layout() counts them
  /// Words of the status, the last for samples that make no bearing: make_ensemble_layout() adds that. The meaning of
  /// the status refers to them, in copies as well.
  std::shared_ptr<const std::vector<std::string_view>> statuses{};

  /// Number of the column of this name; that of all columns if there is none.
  [[nodiscard]] std::size_t column(std::string_view name) const;
  /// Loads at each place: of all bumps, or none.
  [[nodiscard]] std::size_t loads() const { return load.empty() ? 0 : bumps; }
  [[nodiscard]] std::size_t per_place() const { return columns.size() + loads(); }
  [[nodiscard]] std::size_t width() const { return places.size() * per_place(); }
  /// Where in the row a column is, or a bump's load where those are counted on behind the columns.
  [[nodiscard]] std::size_t entry(std::size_t at, std::size_t column) const { return at * per_place() + column; }

  /// The status of samples that make no bearing: "not_physical".
  [[nodiscard]] int no_bearing() const { return static_cast<int>(statuses->size()) - 1; }
  /// What the number of a status means: a word, and a reason.
  [[nodiscard]] std::string_view status_name(int status) const;
  [[nodiscard]] std::string_view status_reason(int status) const;
};

/// What was found at a place: a value for each column, and the loads of the bumps, none where they are not known.
struct SampledPlace {
  std::vector<double> values;
  std::vector<double> loads{};
};

/// Runs the experiment on the bearing of a sampled case, at all places of the layout; numerical failures are statuses.
/// Called with the fraction that is done, `progress` returns false to end the run. What one run builds may serve the
/// next, and copies share it: for one thread at a time.
/// @throws Error (input) if the case is invalid
using SampleRun = std::function<std::vector<SampledPlace>(const Case& sampled, const ProgressCallback& progress)>;

/// How an experiment is run for the bearings of an ensemble, given the case that they deviate from.
struct Sampling {
  /// @throws Error (input) if that case is invalid: its errors are not those of a sample
  std::function<EnsembleLayout(const Case& input)> layout;
  std::function<SampleRun(const Case& input)> begin;
};

}  // namespace bumpfoil
