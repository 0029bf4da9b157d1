#include "results/summary_json.hpp"

#include <cmath>

#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "case/case_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json files_json(const Manifest& manifest) {
  Json json = Json::object();
  for (const FileChecksum& file : manifest.files) {
    json[file.name] = {{"bytes", file.bytes}, {"xxh3_128", file.xxh3_128}};
  }
  return json;
}

}  // namespace

Json value_json(double value, const Form& form) {
  if (!std::isfinite(value)) return {};
  switch (form.kind) {
    case Form::real:
      return value;
    case Form::whole:
      return static_cast<int>(value);
    case Form::truth:
      return value != 0.0;
    case Form::flag:
      return form.words[static_cast<std::size_t>(value)];
  }
  return {};
}

std::vector<Json> rows_json(const Table& table) {
  std::vector<Json> rows(table.rows());
  for (const TableColumn& column : table.columns) {
    const std::string key = column.meaning.key();
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (column.texts.empty()) {
        rows[row][key] = value_json(column.values[row], column.meaning.form);
      } else {
        rows[row][key] = column.texts[row];
      }
    }
  }
  return rows;
}

Json summary_head(std::string_view command, const Case& input, RunStatus status, const Manifest& manifest) {
  Json json;
  json["schema"] = "bumpfoil-summary/2";
  // Placed before all user texts, which could contain the same string.
  json["xxh3_128"] = blank_checksum;
  json["command"] = command;
  json["case"] = case_json(input);
  json["version"] = version();
  json["commit"] = commit();
  json["solver"] = name_of(input.solver.chosen());
  json["status"] = name_of(status);
  json["run_id"] = manifest.run_id;
  json["files"] = files_json(manifest);
  return json;
}

std::string sealed_summary(const Json& json) {
  return sealed(dump_json(json, 2) + '\n');
}

}  // namespace bumpfoil
