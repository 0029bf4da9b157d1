#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// What the caller adds to a case file.
struct CaseRequest {
  /// "table.key=value" each, applied in order: the value is TOML, or a bare string where it is not.
  std::vector<std::string> overrides;
  /// That are to run the case: their tables must be there, and what keeps one from running is a fault. With
  /// "montecarlo" a case that names no solver gets ensemble_solver().
  std::vector<std::string> commands;
};

/// Reads a case file in TOML and checks everything about it: unknown keys, types, units, and find_faults. Every fault
/// is listed at once with file, line, key, the value met and what to change; only where the text is no TOML at all the
/// first place is.
/// @throws Error (input) if the case is wrong; Error (file) if the file, or a file that it names, cannot be read.
Case read_case(const std::string& path, const CaseRequest& request = {});

/// The text of a case file, for those who keep it beside what parse_case() makes of it.
/// @throws Error (input) if it is no text; Error (file) if it cannot be read.
std::string read_case_text(const std::string& path);

/// The same for the text of a case file. `name` stands for the file in messages; files that the case names are looked
/// for beside it.
Case parse_case(std::string_view text, const std::string& name, const CaseRequest& request = {});

/// What a command says of a case that has its table.
struct CheckedCommand {
  std::string name;
  std::vector<Fault> faults;  ///< none: it runs
};

struct CheckedCase {
  Case input;
  std::vector<CheckedCommand> commands;
};

/// Reads a case as parse_case() does, and for each command whose table it has, what keeps that one from running.
/// @throws Error as parse_case() does, and with the faults of all commands if none of them runs
CheckedCase check_case(std::string_view text, const std::string& name, const std::vector<std::string>& overrides = {});

}  // namespace bumpfoil
