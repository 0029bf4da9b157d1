#include "bumpfoil/case/case_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "case/case_keys.hpp"
#include "case/table_reader.hpp"
#include "case/text_file.hpp"
#include "case/toml_document.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

/// Name of the input in messages.
std::string name_in_messages(const std::string& path) {
  return path == standard_input ? "standard input" : path;
}

/// Another table that a command runs or requests, see CaseTable.
std::string_view requested_part(const std::string& command, const Case& input) {
  const CaseTable* const own = case_table_of(command);
  return own != nullptr && own->requested_part ? own->requested_part(input) : "";
}

/// Commands whose tables the case contains.
std::vector<std::string> commands_of_tables(const Case& input) {
  std::vector<std::string> commands;
  for (const CaseTable& table : case_tables()) {
    if (table.given && table.given(input)) commands.emplace_back(table.experiment);
  }
  return commands;
}

/// Names of the experiments with a table that take bearings with pads, for messages: "cycle, path or vibration".
std::string experiments_with_pads() {
  std::vector<std::string_view> names;
  for (const CaseTable& table : case_tables()) {
    if (table.given && !table.flat) names.push_back(table.experiment);
  }
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

/// Errors that prevent the foils from being built as a truss.
std::vector<InputError> truss_errors(const Case& input) {
  if (input.bump_foil.model != BumpFoilModel::frame) {
    for (const PlacedPad& pad : place_pads(input)) {
      std::vector<InputError> errors = find_truss_errors(make_bearing_design(pad.alone));
      for (std::size_t k = 0; k < pad.alone.bump_foil.strip.size() && errors.empty(); ++k) {
        if (!pad.alone.bump_foil.strip[k].has_own_bumps()) continue;
        errors = find_truss_errors(make_bearing_design(strip_of(pad, static_cast<int>(k)).alone));
      }
      if (!errors.empty()) return errors;
    }
  }
  for (std::size_t i = 0; i < input.rotor_bearings.size(); ++i) {
    std::vector<InputError> errors = truss_errors(bearing_at(input, i));
    for (InputError& error : errors) error.key = fmt::format("rotor.bearing[{}].{}", i + 1, error.key);
    if (!errors.empty()) return errors;
  }
  return {};
}

/// Whether the case chooses a model, or gives constants of a truss.
bool chooses_truss(const toml::table& document) {
  using View = toml::node_view<const toml::node>;
  const auto chosen_in = [](const View& bearing) {
    return bearing["bump_foil"]["model"] || bearing["bump_foil"]["truss"];
  };
  const auto chosen_in_any = [&](const View& list) {
    const toml::array* tables = list.as_array();
    return tables != nullptr &&
           std::any_of(tables->begin(), tables->end(), [&](const toml::node& one) { return chosen_in(View(one)); });
  };
  if (chosen_in(View(&document)) || chosen_in_any(document["pad"])) return true;
  const View own = document["rotor"]["bearing"];
  const toml::array* bearings = own.as_array();
  return chosen_in_any(own) ||
         (bearings != nullptr && std::any_of(bearings->begin(), bearings->end(),
                                             [&](const toml::node& one) { return chosen_in_any(View(one)["pad"]); }));
}

/// Replaces a truss that was not requested by the frame. @param error of the truss
void take_frame(Case& input, const InputError& error) {
  const auto take_for = [](std::vector<Pad>& pads) {
    for (Pad& pad : pads) {
      if (pad.bump_foil) pad.bump_foil->model = BumpFoilModel::frame;
    }
  };
  input.bump_foil.model = BumpFoilModel::frame;
  take_for(input.pads);
  for (RotorBearing& own : input.rotor_bearings) {
    if (own.bump_foil) own.bump_foil->model = BumpFoilModel::frame;
    take_for(own.pads);
  }
  input.remarks.push_back(
      fmt::format("the bump foil is modelled as a frame, since it cannot be a truss ({} {}); set bump_foil.model = "
                  "\"frame\" to confirm, or give the constants of a truss in [bump_foil.truss]",
                  error.key, error.what));
}

/// Adds errors from the checks of the named command, or of all commands with a table if none is named.
void run_checks(const CaseRequest& request, const Case& input, ReadingLog& log) {
  if (!request.check) return;
  Case settings_alone;
  settings_alone.settings = input.settings;
  settings_alone.montecarlo = input.montecarlo;
  const bool named = !request.commands.empty();
  for (const std::string& command : named ? request.commands : commands_of_tables(input)) {
    const CaseTable* const own = case_table_of(command);
    const std::string table(own == nullptr ? command : own->needs);
    if (log.blames(table + ".command")) continue;  // unknown command to run
    // The command to run can be built despite errors in its own table, which are listed with those of its checks.
    const bool can_be_built = named && log.is_sound_but_for(table);
    for (const InputError& error : request.check(command, can_be_built ? input : settings_alone))
      log.later_error(error);
  }
}

}  // namespace

Case parse_case(std::string_view text, const std::string& file, const CaseRequest& request) {
  const std::string name = name_in_messages(file);
  toml::table document = parse_toml(text, name);
  ReadingLog log(name);
  for (InputError& error : apply_overrides(document, request.overrides)) log.add(std::move(error));
  TableReader reader(log, document);
  Case input;
  describe(reader, input);
  reader.finish();
  const auto& requested = request.commands;
  for (const CaseTable& table : case_tables()) {
    if (!table.given || !document.contains(table.needs)) continue;
    const auto needs_none = [&](const std::string& command) {
      return command == table.experiment || requested_part(command, input) == table.experiment;
    };
    if (!table.flat || !input.bearing.is_flat() || std::all_of(requested.begin(), requested.end(), needs_none)) {
      continue;
    }
    const auto missed = [&](const char* key, const char* advice) {
      log.later_error(
          {"", 0, key, "", "is missing", fmt::format("{}: only the command {} needs none", advice, table.experiment)});
    };
    missed("bearing.radius", "give it, or bearing.diameter");
    if (input.bearing.radial_clearance == 0.0) missed("bearing.radial_clearance", "give it");
  }
  std::vector<std::string> commands = requested;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const std::string_view part = requested_part(commands[i], input);
    if (!part.empty()) commands.emplace_back(part);
  }
  const bool runs_ensemble = std::find(commands.begin(), commands.end(), "montecarlo") != commands.end();
  if (runs_ensemble && input.montecarlo) {
    commands.emplace_back(input.montecarlo->command);
    if (input.montecarlo->limits) commands.emplace_back("limits");
    if (!input.solver.name) input.solver.name = ensemble_solver(input);
  }
  // Loops by equal increments would differ from exact ones by more than rig accuracy.
  const bool fits = std::find(commands.begin(), commands.end(), "fit") != commands.end();
  if (fits && !input.solver.name && input.bump_foil.geometry == Geometry::linear) {
    input.solver.name = SolverName::events;
  }
  for (const std::string& command : commands) {
    const CaseTable* const own = case_table_of(command);
    const std::string table(own == nullptr ? command : own->needs);
    // A table missing for an ensemble is reported for the command of the ensemble.
    const bool reported =
        command == "limits" || (runs_ensemble && input.montecarlo && command == input.montecarlo->command);
    if (reported || document.contains(table)) continue;
    // Adding a table that pads exclude would not help.
    if (input.pads.empty() || own == nullptr || !own->flat) {
      log.error(table, "this table is missing",
                fmt::format("add [{}], which this command needs; `bumpfoil init` shows its keys", table));
    } else {
      log.error(
          "pad", "is not supported by this command, which needs one foil all around",
          fmt::format("run {}, which support pads, or remove [[pad]] and add [{}]", experiments_with_pads(), table));
    }
  }
  std::vector<InputError> errors = find_errors(input, commands);
  if (errors.empty()) {
    const std::vector<InputError> of_truss = truss_errors(input);
    if (!of_truss.empty() && !chooses_truss(document)) {
      take_frame(input, of_truss.front());
    } else if (!commands.empty()) {
      errors = of_truss;
    }
  }
  for (const InputError& error : errors) log.later_error(error);
  if (!requested.empty() || !log.is_sound()) run_checks(request, input, log);
  log.throw_if_wrong();
  return input;
}

CheckedCase check_case(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                       const CaseCheck& check) {
  CheckedCase checked{.input = parse_case(text, name, {.overrides = overrides, .commands = {}, .check = check}),
                      .commands = {}};
  const Case& input = checked.input;
  std::vector<InputError> errors;
  std::vector<std::string> commands = commands_of_tables(input);
  if (input.montecarlo) commands.emplace_back("montecarlo");
  for (const std::string& command : commands) {
    CheckedCommand& one = checked.commands.emplace_back(CheckedCommand{command, {}});
    try {
      static_cast<void>(parse_case(text, name, {.overrides = overrides, .commands = {command}, .check = check}));
    } catch (const Error& error) {
      one.errors = error.errors();
      for (const InputError& found : one.errors) {
        const bool reported = std::any_of(errors.begin(), errors.end(), [&found](const InputError& before) {
          return format_error(before) == format_error(found);
        });
        if (!reported) errors.push_back(found);
      }
    }
  }
  const bool runs = std::any_of(checked.commands.begin(), checked.commands.end(),
                                [](const CheckedCommand& one) { return one.errors.empty(); });
  if (!runs && !errors.empty()) throw Error(ErrorKind::input, std::move(errors));
  return checked;
}

Case read_case(const std::string& path, const CaseRequest& request) {
  return parse_case(read_case_text(path), path, request);
}

std::string read_case_text(const std::string& path) {
  std::string text = read_text_file(path);
  if (is_blank(text)) {
    throw Error(ErrorKind::input,
                {{name_in_messages(path), 0, "", "", "is empty", "`bumpfoil init` writes a case file to start from"}});
  }
  return text;
}

}  // namespace bumpfoil
