#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/version.hpp"
#include "manual/manual.hpp"

namespace bumpfoil {
namespace {

/// Escapes a text for roff.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// A line of text that roff does not mistake for a request.
std::string line(std::string_view text) {
  const std::string out = roff(text);
  return (out.starts_with('.') ? "\\&" : "") + out + '\n';
}

/// A description with a full stop, which helps omit.
std::string sentence(const std::string& text) {
  return line(text.ends_with('.') ? text : text + '.');
}

/// Indented lines are examples, the others paragraphs.
std::string footer(std::string_view text) {
  std::string out;
  bool in_example = false;
  for (const std::string& one : CLI::detail::split(std::string(text), '\n')) {
    const bool is_example = one.starts_with("  ");
    if (is_example != in_example) out += is_example ? ".PP\n.RS 4\n.EX\n" : ".EE\n.RE\n";
    in_example = is_example;
    out += (is_example ? "" : ".PP\n") + line(CLI::detail::trim_copy(std::string(one)));
  }
  return out + (in_example ? ".EE\n.RE\n" : "");
}

std::string option_entry(CLI::Option& option) {
  std::vector<std::string> heads = spellings_of(option);
  for (std::string& head : heads) head = fmt::format("\\fB{}\\fR", roff(head));
  const OptionValue value = value_of(option);
  std::string head = fmt::format("{}", fmt::join(heads, ", "));
  if (!value.name.empty()) head += fmt::format("{}\\fI{}\\fR", heads.empty() ? "" : " ", roff(value.name));
  std::string out = fmt::format(".TP\n{}\n{}", head, sentence(option.get_description()));
  if (option.get_required() && !heads.empty()) out += "Required.\n";
  if (!value.words.empty()) out += line(fmt::format("One of {}.", fmt::join(value.words, ", ")));
  if (!value.rule.empty()) out += line(fmt::format("Must be {}.", value.rule));
  if (!option.get_default_str().empty()) out += line(fmt::format("Default: {}.", option.get_default_str()));
  for (const CLI::Option* excluded : option.get_excludes()) {
    out += line(fmt::format("Not together with {}.", excluded->get_name()));
  }
  return out;
}

std::string options_of(CLI::App& app) {
  std::string out;
  for (CLI::Option* option : app.get_options()) out += option_entry(*option);
  return out;
}

std::string section_of(CLI::App& command) {
  std::string usage = fmt::format("\\fBbumpfoil {}\\fR [\\fIOPTIONS\\fR]", command.get_name());
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    usage += fmt::format(" \\fI{}\\fR{}", option->get_name(true), option->get_items_expected_max() > 1 ? "..." : "");
  }
  return fmt::format(".SS {}\n{}\n.PP\n{}{}{}", command.get_name(), usage, sentence(command.get_description()),
                     options_of(command), footer(command.get_footer()));
}

}  // namespace

std::string man_page(CLI::App& program) {
  std::string out = fmt::format(
      ".\\\" Made from the description by which the program reads its command line.\n"
      ".TH BUMPFOIL 1 \"\" \"Bumpfoil {}\" \"User Commands\"\n.nr HY 0\n.ad l\n"
      ".SH NAME\nbumpfoil \\- mechanics of bump-type gas foil bearings\n"
      ".SH SYNOPSIS\n\\fBbumpfoil\\fR [\\fIOPTIONS\\fR] \\fICOMMAND\\fR ...\n"
      ".SH DESCRIPTION\n{}",
      version(), line(program.get_description()));
  out += footer(program.get_footer()) + ".SH OPTIONS\n" + options_of(program) + ".SH COMMANDS\n";
  for (CLI::App* command : program.get_subcommands({})) out += section_of(*command);
  return out;
}

}  // namespace bumpfoil
