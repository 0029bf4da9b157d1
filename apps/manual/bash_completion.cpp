#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/case/case_writer.hpp"
#include "manual/manual.hpp"

namespace bumpfoil {
namespace {

/// The kind of a value, as named in the script below.
std::string kind_of(const OptionValue& value) {
  if (!value.words.empty()) return fmt::format("words {}", fmt::join(value.words, " "));
  if (value.name == "DIR") return "folders";
  if (value.name.starts_with("KEY=")) return "keys";
  if (value.name == "CASE") return "cases";
  if (value.name == "FILE" || value.name.starts_with("ENSEMBLE.NC")) return "files";
  return "none";
}

/// The branches of "case COMMAND in" with its options, the kinds of their values, and its arguments.
struct Branches {
  std::string options;
  std::string values;
};

void describe(CLI::App& app, const std::string& inherited, Branches& branches) {
  std::vector<std::string> all;
  for (CLI::Option* option : app.get_options()) {
    const std::vector<std::string> spellings = spellings_of(*option);
    all.insert(all.end(), spellings.begin(), spellings.end());
    const OptionValue value = value_of(*option);
    if (value.name.empty()) continue;
    std::vector<std::string> patterns;
    patterns.reserve(spellings.size());
    for (const std::string& spelling : spellings) patterns.push_back(fmt::format("'{} {}'", app.get_name(), spelling));
    if (spellings.empty()) patterns.push_back(fmt::format("'{} '", app.get_name()));
    branches.values += fmt::format("    {}) echo '{}' ;;\n", fmt::join(patterns, " | "), kind_of(value));
  }
  branches.options += fmt::format("    {}) echo '{}{}' ;;\n", app.get_name(), fmt::join(all, " "), inherited);
}

constexpr std::string_view functions = R"script(
_bumpfoil() {
  local command='' word kind before=$((COMP_CWORD - 1)) current=${COMP_WORDS[COMP_CWORD]} previous=''
  # Bash takes "=" for a word of its own: "--output=DIR" is three.
  if [[ $current == = ]]; then current=''; elif [[ ${COMP_WORDS[before]} == = ]]; then before=$((before - 1)); fi
  previous=${COMP_WORDS[before]}
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in
      help | -*) ;;
      *) command=$word; break ;;
    esac
  done
  [[ $previous == -* ]] || previous=''
  kind=$(_bumpfoil_value "${command:-bumpfoil} $previous")
  # After an option without a value stands what would stand there without it.
  if [[ -z $kind && -n $previous ]]; then kind=$(_bumpfoil_value "${command:-bumpfoil} "); previous=''; fi
  COMPREPLY=()
  if [[ -z $command ]]; then
    mapfile -t COMPREPLY < <(compgen -W "help $_bumpfoil_commands $(_bumpfoil_options bumpfoil)" -- "$current")
    return
  fi
  if [[ -z $previous && $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_bumpfoil_options "$command")" -- "$current")
    return
  fi
  case $kind in
    words*) mapfile -t COMPREPLY < <(compgen -W "${kind#words}" -- "$current") ;;
    keys)
      mapfile -t COMPREPLY < <(compgen -S = -W "$_bumpfoil_keys" -- "$current")
      compopt -o nospace ;;
    folders) mapfile -t COMPREPLY < <(compgen -d -- "$current"); compopt -o filenames ;;
    cases) mapfile -t COMPREPLY < <(compgen -d -- "$current"; compgen -f -X '!*.toml' -- "$current"); compopt -o filenames ;;
    files) mapfile -t COMPREPLY < <(compgen -f -- "$current"); compopt -o filenames ;;
  esac
}
complete -F _bumpfoil bumpfoil
)script";

}  // namespace

std::string bash_completion(CLI::App& program) {
  const std::vector<CLI::App*> commands = program.get_subcommands({});
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  // Options allowed before any command are also allowed after it.
  const std::string of_all = " --quiet";
  Branches branches;
  describe(program, "", branches);
  for (CLI::App* command : commands) describe(*command, of_all, branches);
  return fmt::format(
      "# Completes command lines of bumpfoil in bash. Made from the description by which it reads them.\n"
      "_bumpfoil_commands='{}'\n_bumpfoil_keys='{}'\n"
      "\n_bumpfoil_options() {{\n  case $1 in\n{}  esac\n}}\n"
      "\n_bumpfoil_value() {{\n  case $1 in\n{}  esac\n}}\n{}",
      fmt::join(names, " "), fmt::join(case_key_names(), " "), branches.options, branches.values, functions);
}

}  // namespace bumpfoil
