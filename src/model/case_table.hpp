#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "model/check_bump_foil.hpp"
#include "model/checks.hpp"

namespace bumpfoil {

class CaseVisitor;

/// An experiment in the case file: its table, of the same name, or those that it shares with others.
struct CaseTable {
  std::string_view experiment;
  std::string_view needs;  ///< table required to run: its own, or that of another experiment
  bool flat{};             ///< applies to a strip of foil between plates: needs no bearing and ignores pads
  bool foils{};            ///< runs a bearing with its foils
  bool film{};             ///< runs a bearing with its film
  bool rotor{};            ///< runs [rotor] on its bearings
  /// Visits its keys; those outside the case file's tables keep their defaults.
  void (*describe)(CaseVisitor& keys, Case& input);
  /// Checks its settings, if any. @param foil  known properties of the bump foil, possibly none
  void (*check)(Checks& checks, const Case& input, const CheckedBumpFoil& foil);
  /// Whether the case gives the settings of this experiment; null if it has none of its own.
  bool (*given)(const Case& input){};
  /// Another part that the case requests, or another command that it runs, with checks of its own; empty: none.
  std::string_view (*requested_part)(const Case& input){};
  bool swept{};  ///< sweeps and optimisations can run it: it has a Sweeping
  /// Ensembles can run it, as it has a Sampling: by this solver where the case names none and displacements are small.
  std::optional<SolverName> sampled_by{};

  [[nodiscard]] bool is_dry() const { return foils && !film; }
  [[nodiscard]] bool has_foils_on_film() const { return foils && film; }
};

/// Tables of all experiments, in the order of the case file. Code that reads, writes and checks cases accesses
/// experiments only through these. They are defined in a higher layer: in experiments/, or in a program with fewer
/// experiments.
std::span<const CaseTable> case_tables();

/// Whether a case gives settings of this type: a CaseTable::given.
template <typename Settings>
bool gives(const Case& input) {
  return input.settings.find<Settings>() != nullptr;
}

/// Null if there is no such experiment.
const CaseTable* case_table_of(std::string_view experiment);

/// Names of the experiments that meet a condition, in the order of the case file.
/// @param condition  &CaseTable::film, or a function of a CaseTable
template <typename Condition>
std::vector<std::string_view> experiments_where(const Condition& condition) {
  std::vector<std::string_view> names;
  for (const CaseTable& table : case_tables()) {
    if (std::invoke(condition, table)) names.push_back(table.experiment);
  }
  return names;
}

/// Names of the experiments that ensembles can run, and of those that can be swept, in the order of the case file.
const std::vector<std::string_view>& sampled_experiments();
const std::vector<std::string_view>& swept_experiments();

/// The solver of an ensemble whose case names none: `events` for cycles of small displacements, which is several times
/// faster, else `newton`.
SolverName ensemble_solver(const Case& input);

}  // namespace bumpfoil
