#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Maximum number of bumps of a foil.
inline constexpr int most_bumps = 100'000;

/// Maximum number of points of a path.
inline constexpr int most_points = 1'000'000;

/// An error of a case, and the command that it prevents; empty: all of them.
struct CommandError {
  /// Name of an experiment, "limits" of equilibrium, or "montecarlo".
  std::string_view command;
  InputError error;
};

/// Every physical error of a case (signs, sizes, overlap, lengths of lists, models that do not fit together), each with
/// its key, the value in SI and what to change. Errors of a single value, or of the foils, concern all commands; errors
/// that only one command would meet concern that command. Entries of lists are counted from 1, as bumps are:
/// "bump_foil.height_errors[3]". An invalid value is not checked together with others. File and line are left empty:
/// only the reader of a case file has them.
///
/// A case without directions and amplitude has no cycle to run, and one with a strip may have no bearing, neither of
/// which is an error.
std::vector<CommandError> check_case(const Case& input);

/// Those that concern all commands, and those of some; empty when the case can be built, and run by these.
std::vector<InputError> find_errors(const Case& input, const std::vector<std::string>& commands = {});

/// @throws Error (input) listing all of find_errors(input, commands) if there are any.
void require_valid(const Case& input, const std::vector<std::string>& commands = {});

/// @throws Error (input) as require_valid() does, and if the case has a strip but no bearing.
void require_bearing(const Case& input, const std::vector<std::string>& commands = {});

}  // namespace bumpfoil
