#include "bumpfoil/case/case_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bumpfoil/core/printable.hpp"
#include "case/case_json.hpp"
#include "case/key_list.hpp"

namespace bumpfoil {

using Json = nlohmann::ordered_json;

namespace {

/// "/bump_foil/shim/0/from" for "bump_foil.shim[1].from".
Json::json_pointer pointer_to(const std::string& path) {
  Json::json_pointer pointer;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    const std::string name = path.substr(start, end - start);
    const std::size_t bracket = name.find('[');
    pointer /= name.substr(0, bracket);
    if (bracket != std::string::npos) pointer /= std::stoul(name.substr(bracket + 1)) - 1;
    start = end + 1;
  }
  return pointer;
}

}  // namespace

Json case_json(const Case& input) {
  Json json;
  for (const ListedKey& listed : list_keys(input)) {
    if (!listed.held) continue;
    if (!listed.is_table()) {
      json[pointer_to(listed.path)] = listed.value;
    } else if (listed.is_of_list()) {
      json[pointer_to(listed.path)] = Json::object();  // given, even if empty
    }
  }
  return json;
}

std::string dump_json(const Json& json, int indent) {
  return printable_json(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

std::string case_to_toml(const Case& input) {
  std::string out;
  std::string table;
  for (const ListedKey& listed : list_keys(input)) {
    if (!listed.held || (listed.is_table() && !listed.is_of_list())) continue;
    const std::string holder = listed.is_table() ? listed.path : listed.table();
    if (holder != table) {
      table = holder;
      out += fmt::format("\n{}\n", table_header(table));
    }
    if (listed.is_table()) continue;
    const auto& dimension = listed.key.dimension;
    out += fmt::format("{} = {}{}\n", listed.key.name, toml_of(listed.value),
                       dimension ? fmt::format("  # {}", si_unit(*dimension)) : std::string());
  }
  return out;
}

std::string case_to_json(const Case& input) {
  return dump_json(case_json(input), 2) + '\n';
}

}  // namespace bumpfoil
