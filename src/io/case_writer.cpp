#include "bumpfoil/io/case_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bumpfoil/core/printable.hpp"
#include "io/case_json.hpp"
#include "io/key_list.hpp"

namespace bumpfoil {

using Json = nlohmann::ordered_json;

Json case_json(const Case& input) {
  Json json;
  for (const ListedKey& listed : list_keys(input)) {
    if (listed.is_table() || !listed.held) continue;
    std::string pointer = "/" + listed.path;
    std::replace(pointer.begin(), pointer.end(), '.', '/');
    json[Json::json_pointer(pointer)] = listed.value;
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
    if (listed.is_table() || !listed.held) continue;
    if (listed.table() != table) {
      table = listed.table();
      out += fmt::format("\n[{}]\n", table);
    }
    // JSON texts are TOML texts, too, as the delete character is escaped.
    const auto& dimension = listed.key.dimension;
    out += fmt::format("{} = {}{}\n", listed.key.name, dump_json(listed.value, -1),
                       dimension ? fmt::format("  # {}", si_unit(*dimension)) : std::string());
  }
  return out;
}

std::string case_to_json(const Case& input) {
  return dump_json(case_json(input), 2) + '\n';
}

}  // namespace bumpfoil
