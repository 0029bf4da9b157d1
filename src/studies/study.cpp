#include "bumpfoil/studies/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <set>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/case/swept_key.hpp"
#include "bumpfoil/core/error.hpp"
#include "studies/study_library.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view base_case = "gen1";

/// Reads the values of a table of a description; missing or unknown keys are errors.
class DescriptionReader {
 public:
  DescriptionReader(std::string_view study, const toml::table& table) : study_(study), table_(table) {}

  std::string text(std::string_view key) { return value<std::string>(find(key), key); }
  std::string text_or_empty(std::string_view key) { return table_.contains(key) ? text(key) : std::string(); }

  template <typename Value>
  std::vector<Value> list(std::string_view key) {
    std::vector<Value> values;
    if (const toml::array* array = array_of(key)) {
      for (const toml::node& node : *array) values.push_back(value<Value>(&node, key));
    }
    return values;
  }

  std::vector<DescriptionReader> tables(std::string_view key) {
    std::vector<DescriptionReader> readers;
    if (const toml::array* array = array_of(key)) {
      for (const toml::node& node : *array) {
        if (!node.is_table()) fail(key, "is not a table");
        readers.emplace_back(study_, *node.as_table());
      }
    }
    return readers;
  }

  /// Call last.
  void finish() const {
    for (const auto& [key, node] : table_) {
      if (!known_.contains(key.str())) fail(key.str(), "is not known");
    }
  }

  [[noreturn]] void fail(std::string_view key, std::string what) const {
    throw Error(ErrorKind::input, {{study_, 0, std::string(key), "", std::move(what), ""}});
  }

 private:
  const toml::node* find(std::string_view key) {
    known_.emplace(key);
    return table_.get(key);
  }

  const toml::array* array_of(std::string_view key) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_array()) fail(key, "is not a list");
    return node == nullptr ? nullptr : node->as_array();
  }

  template <typename Value>
  Value value(const toml::node* node, std::string_view key) const {
    const auto found = node == nullptr ? std::nullopt : node->value<Value>();
    if (!found) fail(key, "is missing or of the wrong type");
    return *found;
  }

  std::string study_;
  const toml::table& table_;
  std::set<std::string, std::less<>> known_;
};

/// @throws Error (input) at the first syntax error.
toml::table parse_description(std::string_view text, std::string_view study) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw Error(ErrorKind::input,
                {{std::string(study), error.source().begin.line, "", "", std::string(error.description()), ""}});
  }
}

/// Overrides with line breaks, which --set rejects, replaced by spaces.
std::vector<std::string> overrides_of(DescriptionReader& reader, const std::vector<std::string>& common) {
  std::vector<std::string> overrides = common;
  for (std::string& one : reader.list<std::string>("set")) {
    std::replace(one.begin(), one.end(), '\n', ' ');
    overrides.push_back(std::move(one));
  }
  return overrides;
}

void add_sweep(DescriptionReader& sweep, const std::vector<std::string>& common, Study& study) {
  const SweptKey swept = parse_swept_key(sweep.text("over"));
  const std::string name = sweep.text("name");
  const std::vector<std::string> overrides = overrides_of(sweep, common);
  study.parameter = swept.key.substr(swept.key.rfind('.') + 1);
  for (const std::string& value : swept.values) {
    std::size_t end = 0;
    const double number = std::stod(value, &end);
    const std::string unit = value.substr(std::min(value.find_first_not_of(' ', end), value.size()));
    study.parameter_unit = unit;
    StudyRun run{.name = fmt::format("{}_{}{}", name, number, unit),
                 .label = fmt::format("{} {}", name, value),
                 .overrides = overrides,
                 .parameter = number};
    run.overrides.push_back(swept.key + '=' + value);
    study.runs.push_back(std::move(run));
  }
  sweep.finish();
}

StudyTableKind table_kind(const DescriptionReader& reader, std::string_view name) {
  const auto& names = enum_names<StudyTableKind>;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) reader.fail("tables", fmt::format("there is not a table \"{}\"", name));
  return static_cast<StudyTableKind>(found - names.begin());
}

const StudyText& text_of(std::string_view study) {
  for (const StudyText& text : study_library()) {
    if (text.name == study) return text;
  }
  throw Error(ErrorKind::input, {{"", 0, "study", std::string(study), "is not known",
                                  fmt::format("use one of {}", fmt::join(study_names(), ", "))}});
}

StudyData data_called(const DescriptionReader& reader, std::string_view name) {
  for (const StudyData& data : study_data_library()) {
    if (data.name == name) return data;
  }
  reader.fail("data", fmt::format("there is not a table \"{}\"", name));
}

std::vector<StudyRun> runs_of_others(DescriptionReader& reader) {
  const std::vector<std::string> only = reader.list<std::string>("only");
  std::vector<StudyRun> runs;
  for (const std::string& other : reader.list<std::string>("runs_of")) {
    for (StudyRun& run : make_study(other).runs) {
      const auto same = [&run](const auto& name) { return name == run.name; };
      const bool wanted = only.empty() || std::any_of(only.begin(), only.end(), same);
      const bool there = std::any_of(runs.begin(), runs.end(), [&](const StudyRun& known) { return same(known.name); });
      if (wanted && !there) runs.push_back(std::move(run));
    }
  }
  return runs;
}

/// The runs once per variant, with its overrides; unchanged without variants.
std::vector<StudyRun> in_variants(DescriptionReader& reader, std::vector<StudyRun> runs) {
  std::vector<DescriptionReader> variants = reader.tables("variant");
  if (variants.empty()) return runs;
  std::vector<StudyRun> out;
  for (DescriptionReader& variant : variants) {
    const std::string name = variant.text("name");
    const std::vector<std::string> overrides = overrides_of(variant, {});
    variant.finish();
    for (const StudyRun& run : runs) {
      StudyRun& added = out.emplace_back(run);
      added.name += '-' + name;
      added.label += ", " + name;
      added.overrides.insert(added.overrides.end(), overrides.begin(), overrides.end());
    }
  }
  return out;
}

}  // namespace

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  for (const StudyText& study : study_library()) names.emplace_back(study.name);
  return names;
}

Study make_study(std::string_view name) {
  const StudyText& own = text_of(name);
  Study study = parse_study(own.description, name);
  const std::string_view script = study.script_of.empty() ? own.script : text_of(study.script_of).script;
  study.plot_script = std::string(study_style_script()) + std::string(script);
  return study;
}

Study parse_study(std::string_view text, std::string_view name) {
  const toml::table document = parse_description(text, name);
  DescriptionReader reader(name, document);
  Study study;
  study.name = name;
  study.title = reader.text("title");
  const std::vector<std::string> common = overrides_of(reader, {});
  study.runs = in_variants(reader, runs_of_others(reader));
  for (DescriptionReader& run : reader.tables("run")) {
    StudyRun& added = study.runs.emplace_back();
    added.name = run.text("name");
    added.label = run.text("label");
    added.overrides = overrides_of(run, common);
    run.finish();
  }
  for (DescriptionReader& sweep : reader.tables("sweep")) add_sweep(sweep, common, study);
  for (const std::string& table : reader.list<std::string>("tables")) study.tables.push_back(table_kind(reader, table));
  for (const std::string& data : reader.list<std::string>("data")) study.data.push_back(data_called(reader, data));
  study.script_of = reader.text_or_empty("script_of");
  study.increments = reader.list<int>("increments");
  if (study.runs.empty()) reader.fail("run", "there is no run");
  if (study.tables.empty()) reader.fail("tables", "there is not a table");
  reader.finish();
  return study;
}

Case study_case(const StudyRun& run) {
  return parse_case(case_template(base_case), run.name, {.overrides = run.overrides, .commands = {"cycle"}});
}

}  // namespace bumpfoil
