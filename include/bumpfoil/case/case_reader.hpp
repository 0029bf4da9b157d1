#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Further errors of a case that a command is to run: those that only the command itself can find.
using CaseCheck = std::function<std::vector<InputError>(const std::string& command, const Case& input)>;

/// Additions of the caller to a case file.
struct CaseRequest {
  /// "table.key=value" each, applied in order: the value is TOML, or else a bare string.
  std::vector<std::string> overrides;
  /// Commands that will run the case: their tables must be present, and whatever prevents one from running is an error.
  /// With "montecarlo" a case that names no solver gets `events` for cycles of small displacements, which is several
  /// times faster, else `newton`; with "fit" `events` where it can.
  std::vector<std::string> commands;
  /// Of each of these commands. Of a case with errors outside of its table it gets the settings of experiments and
  /// ensembles alone, for a bearing that may not be; with no command named, of all that have a table.
  CaseCheck check{};
};

/// Reads a case file in TOML and checks everything about it: unknown keys, types, units, and find_errors. Every error
/// is listed at once with file, line, key, the value found and what to change; if the text is not TOML, only the first
/// place is.
/// @throws Error (input) if the case is invalid; Error (file) if the file, or a file that it names, cannot be read.
Case read_case(const std::string& path, const CaseRequest& request = {});

/// The text of a case file, to be kept with the result of parse_case().
/// @throws Error (input) if it is not a text file; Error (file) if it cannot be read.
std::string read_case_text(const std::string& path);

/// The same for the text of a case file. `name` is the name of the file in messages; files that the case names are
/// looked up in the same folder.
Case parse_case(std::string_view text, const std::string& name, const CaseRequest& request = {});

/// Verdict of a command on a case that has its table.
struct CheckedCommand {
  std::string name;
  std::vector<InputError> errors;  ///< none: it runs
};

struct CheckedCase {
  Case input;
  std::vector<CheckedCommand> commands;
};

/// Reads a case as parse_case() does, and checks for each command whose table it has whether it can run.
/// @throws Error as parse_case() does, and with the errors of all commands if none of them can run
CheckedCase check_case(std::string_view text, const std::string& name, const std::vector<std::string>& overrides = {},
                       const CaseCheck& check = {});

}  // namespace bumpfoil
