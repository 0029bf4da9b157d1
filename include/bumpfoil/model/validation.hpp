#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Most bumps that a foil may have.
inline constexpr int most_bumps = 100'000;

/// Most points that a path may be given by.
inline constexpr int most_points = 1'000'000;

/// A fault of a case, and the command that it keeps from running; empty: all of them.
struct JudgedFault {
  /// "cycle", "strip", "path", "vibration", "equilibrium", "limits" of it, "film" or "montecarlo"
  std::string_view command;
  Fault fault;
};

/// Everything that is physically wrong with a case (signs, sizes, overlap, lengths of lists, models that do not fit
/// together), one fault each with its key, the value in SI and what to change. What is wrong with a value by itself, or
/// with the foils, concerns all commands; what one of them could not do with the rest of the case, that command alone.
/// Entries of lists are counted from 1, as bumps are: "bump_foil.height_errors[3]". A value that is wrong by itself is
/// not judged together with others. File and line are left empty: only the reader of a case file knows them.
///
/// A case without directions and amplitude has no cycle to run, and one with a strip may have no bearing, neither of
/// which is a fault.
std::vector<JudgedFault> judge_case(const Case& input);

/// Those that concern all commands, and those of some; empty when the case can be built, and run by these.
std::vector<Fault> find_faults(const Case& input, const std::vector<std::string>& commands = {});

/// @throws Error (input) listing all of find_faults(input, commands) if there are any.
void require_valid(const Case& input, const std::vector<std::string>& commands = {});

/// @throws Error (input) as require_valid() does, and if there is no bearing in the case, but a strip alone.
void require_bearing(const Case& input, const std::vector<std::string>& commands = {});

}  // namespace bumpfoil
