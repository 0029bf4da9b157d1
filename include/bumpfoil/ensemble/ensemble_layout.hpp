#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bumpfoil/ensemble/statistics.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// What was run of a bearing of an ensemble, as its case says by montecarlo.command: of a rotor the values of
/// sampled_variables(); nothing if the sample is invalid.
using SampleResult = std::variant<std::monostate, CycleResult, EquilibriumResult, std::vector<double>>;

/// Where numbers of a bearing are kept: the direction of a cycle, rad, or a state in which it runs; of a rotor there is
/// one place, over all its speeds.
struct EnsemblePlace {
  std::string name;  ///< "+X", or "45000 rpm, load (50, 0) N", or "rotor"
  std::variant<std::monostate, double, OperatingPoint> at{};
};

/// A quantity that is kept at every place.
struct EnsembleColumn {
  VariableMeaning meaning;  ///< with a label where it is on the terminal
  Undefined undefined{Undefined::unknown};
  /// Whether there can be limits on it: not where one that is not there is good in some samples and bad in others.
  bool limitable{true};
  /// (what was run, place, sampled case) -> value; not a number where it is not known
  std::function<double(const SampleResult&, std::size_t, const Case&)> value{};
};

/// What is kept of a sample: a row of numbers, at each place one for each column and then the loads of the bumps, at
/// full displacement or in the state; none of a rotor.
struct EnsembleLayout {
  EnsembleCommand command{};
  std::vector<EnsemblePlace> places;
  std::vector<EnsembleColumn> columns;  ///< the first is the status, zero where the place was reached
  std::size_t bumps{};
  std::size_t loads{};  ///< of bumps at each place: of all, or none

  [[nodiscard]] std::size_t per_place() const { return columns.size() + loads; }
  [[nodiscard]] std::size_t width() const { return places.size() * per_place(); }
  /// Where in the row a column is, or a bump's load where those are counted on behind the columns.
  [[nodiscard]] std::size_t entry(std::size_t place, std::size_t column) const { return place * per_place() + column; }

  /// What a place is, the dimension of ensemble.nc: "direction", "state" or "rotor".
  [[nodiscard]] std::string_view dimension() const;
  /// The quantity whose mean EnsembleRun is asked to know: the maximum force, the minimum film thickness, the speed up
  /// to which the rotor is stable, its largest amplitude, or the largest half of the way of a journal.
  [[nodiscard]] std::string_view leading() const;
  /// The status of samples that make no bearing: "not_physical".
  [[nodiscard]] int no_bearing() const { return static_cast<int>(columns.front().meaning.form.words.size()) - 1; }
  /// What the number of a status means: a word, and a reason.
  [[nodiscard]] std::string_view status_name(int status) const;
  [[nodiscard]] std::string_view status_reason(int status) const;
};

/// The layout of the ensemble of a case.
/// @throws Error (input) if it is one of running bearings or rotors, and the case makes none
EnsembleLayout make_ensemble_layout(const Case& input);

/// The row of a sample, not a number where something is not known: all but the status of one that makes no bearing.
std::vector<double> make_ensemble_row(const EnsembleLayout& layout, const Case& sampled, const SampleResult& result);

}  // namespace bumpfoil
