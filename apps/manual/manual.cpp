#include "manual/manual.hpp"

#include <string_view>

namespace bumpfoil {

OptionValue value_of(CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return {};
  // The rule of an option, if any, precedes the unnamed check against an empty value.
  OptionValue value{.name = option.get_type_name(), .rule = option.get_validator(0)->get_description()};
  if (!value.rule.empty()) value.name.resize(value.name.rfind(':' + value.rule));
  if (option.get_positional()) value.name = option.get_name(true);
  if (value.rule.starts_with('{')) {
    value.words = CLI::detail::split(value.rule.substr(1, value.rule.size() - 2), ',');
    value.rule.clear();
  }
  return value;
}

std::vector<std::string> spellings_of(const CLI::Option& option) {
  std::vector<std::string> spellings;
  for (const std::string& name : option.get_snames()) spellings.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) spellings.push_back("--" + name);
  return spellings;
}

}  // namespace bumpfoil
