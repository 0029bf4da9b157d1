#pragma once

#include <span>
#include <string_view>

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"
#include "model/judge_bump_foil.hpp"

namespace bumpfoil {

class CaseVisitor;

/// An experiment in the case file: its table, of the same name, or those that it shares with others.
struct CaseTable {
  std::string_view experiment;
  std::string_view needs;  ///< the table without which it does not run: its own, or that of another experiment
  bool flat{};             ///< it has a strip of one foil between plates: no bearing is needed, and pads do not count
  /// Visits its keys; what is not in a table of the case file has its default.
  void (*describe)(CaseVisitor& keys, Case& input);
  /// Checks its settings, where there are any. @param foil  what is known of the bump foil, of which nothing may be
  void (*check)(Judge& judge, const Case& input, const JudgedBumpFoil& foil);
  /// Whether the case holds what it needs and none but it does; null if it has no settings alone.
  bool (*given)(const Case& input){};
  /// A further part of it that the case requests, or another command that it runs, which has checks of its own; empty:
  /// none.
  std::string_view (*requested_part)(const Case& input){};
};

/// Those of all experiments, in the order of the case file. What reads, writes and checks cases knows experiments by
/// these alone: they are defined above it, in experiments/, or in a program that has only some.
std::span<const CaseTable> case_tables();

}  // namespace bumpfoil
