#pragma once

#include <span>
#include <string_view>

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
  /// Visits its keys; those outside the case file's tables keep their defaults.
  void (*describe)(CaseVisitor& keys, Case& input);
  /// Checks its settings, if any. @param foil  known properties of the bump foil, possibly none
  void (*check)(Checks& checks, const Case& input, const CheckedBumpFoil& foil);
  /// Whether the case gives the settings of this experiment; null if it has none of its own.
  bool (*given)(const Case& input){};
  /// Another part that the case requests, or another command that it runs, with checks of its own; empty: none.
  std::string_view (*requested_part)(const Case& input){};
};

/// Tables of all experiments, in the order of the case file. Code that reads, writes and checks cases accesses
/// experiments only through these. They are defined in a higher layer: in experiments/, or in a program with fewer
/// experiments.
std::span<const CaseTable> case_tables();

}  // namespace bumpfoil
