#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <variant>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/case_json.hpp"
#include "case/key_list.hpp"
#include "case/presets.hpp"
#include "case/reading_log.hpp"
#include "case/table_reader.hpp"
#include "case/toml_document.hpp"
#include "case/unit_table.hpp"
#include "case/value_reader.hpp"
#include "model/checks.hpp"

namespace bumpfoil {
namespace {

using Schema = nlohmann::ordered_json;

/// Numbers that case files may contain.
constexpr std::string_view number_pattern = R"([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)";

/// A product, quotient or power of units of any dimension: patterns cannot check the dimension.
constexpr std::string_view composed_unit =
    "(?:1/|\\()*[A-Za-z\u00b0\u00b5\u03bc]+ *(?:[-/*.^()0-9\u00b7\u207b\u00b9\u00b2\u00b3]| [A-Za-z(]).*";

/// Words of a list separated by blanks.
std::vector<std::string> spellings_in(std::string_view list) {
  std::vector<std::string> words;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    words.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return words;
}

/// Whether the unit has one of these dimensions.
bool measures_one_of(std::string_view unit, const std::vector<Dimension>& dimensions) {
  return std::any_of(dimensions.begin(), dimensions.end(), [unit](Dimension dimension) {
    return std::holds_alternative<double>(parse_quantity(fmt::format("1 {}", unit), dimension));
  });
}

/// Pattern of a number with a unit of one of these dimensions, or one of some words. Names of units are in lower case.
std::string quantity_pattern(const std::vector<Dimension>& dimensions, std::string_view words) {
  std::vector<std::string> units;
  std::string inverse;  // "1/min"
  for (const KnownUnit& unit : known_units()) {
    std::vector<std::string> spellings = spellings_in(unit.symbols);
    for (const std::string& name : spellings_in(unit.names)) spellings.push_back(name + "s?");
    const std::string_view any = unit.symbols.empty() ? unit.names : unit.symbols;
    const std::string_view one = any.substr(0, any.find(' '));
    if (measures_one_of(one, dimensions)) units.insert(units.end(), spellings.begin(), spellings.end());
    if (measures_one_of(fmt::format("1/{}", one), dimensions)) {
      inverse += fmt::format("1/(?:{})|", fmt::join(spellings, "|"));
    }
  }
  std::vector<std::string_view> prefixes;
  for (const UnitPrefix& prefix : unit_prefixes()) prefixes.insert(prefixes.end(), {prefix.symbol, prefix.name});
  const std::string named =
      units.empty() ? "" : fmt::format("(?:{}|\u00b5|\u03bc)?(?:{})|", fmt::join(prefixes, "|"), fmt::join(units, "|"));
  return fmt::format("^[ \\t]*(?:{}{}[ \\t]*(?:{}{}{}))[ \\t]*$", words, number_pattern, named, inverse, composed_unit);
}

/// Schema properties of keys beyond their description: ranges, defaults and examples. Paths have no list indices.
class KeyFacts {
 public:
  KeyFacts() : listed_(list_keys(presets().front().input)), unset_(list_keys({})) {
    for (const CheckedKey& one : checked_keys(case_of_all_keys())) {
      const auto [range, first] = ranges_.try_emplace(without_counts(one.key), one.range);
      range->second.least = std::min(range->second.least, one.range.least);
      range->second.most = std::max(range->second.most, one.range.most);
    }
  }

  /// Bounds of a number, `times` those of the key.
  void bound(Schema& number, const std::string& path, double times = 1.0) const {
    const auto range = ranges_.find(path);
    if (range == ranges_.end()) return;
    number["minimum"] = times * range->second.least;
    number["maximum"] = times * range->second.most;
  }

  void exemplify(Schema& value, const std::string& path) const {
    const ListedKey* const listed = find_key(listed_, path);
    const ListedKey* const unset = find_key(unset_, path);
    if (listed == nullptr || unset == nullptr) return;
    const bool falls_back = listed->key.presence == Presence::defaulted && !listed->instead;
    if (falls_back && listed->key.otherwise.empty()) {
      const Schema fallback = read(default_of(*listed, *unset));
      if (!fallback.is_null()) value["default"] = fallback;
    } else if (const Schema example = read(example_of(*listed)); !example.is_null()) {
      value["examples"] = Schema::array({example});
    }
  }

 private:
  /// Null if invalid JSON: such an example only shows the form of a list.
  static Schema read(const std::string& text) {
    Schema value = Schema::parse(text, nullptr, false);
    return value.is_discarded() ? Schema() : value;
  }

  /// A case with every key at its example, without contradictions.
  [[nodiscard]] Case case_of_all_keys() const {
    std::string text;
    for (const ListedKey& listed : listed_) {
      if (listed.is_table()) {
        text += table_header(listed.path) + '\n';
      } else if (const Schema example = read(example_of(listed)); !example.is_null() && !listed.key.instead) {
        text += fmt::format("{} = {}\n", listed.key.name, example_of(listed));
      }
    }
    const toml::table document = parse_toml(text, "");
    ReadingLog errors("");
    TableReader reader(errors, document);
    Case input;
    describe(reader, input);
    return input;
  }

  std::vector<ListedKey> listed_;
  std::vector<ListedKey> unset_;
  std::map<std::string, Range> ranges_;
};

/// Describes a table and those inside it.
class SchemaWriter final : public CaseVisitor {
 public:
  /// @param path  of the table, with a trailing dot; empty: the root
  explicit SchemaWriter(const KeyFacts& facts, std::string path = {}, bool inherits = false)
      : facts_(facts), path_(std::move(path)), inherits_(inherits) {}

  /// The table.
  [[nodiscard]] Schema take() {
    Schema table{{"type", "object"}, {"properties", std::move(properties_)}, {"additionalProperties", false}};
    if (!required_.empty()) table["required"] = std::move(required_);
    return table;
  }

  void value(const Key& key, Value value) override {
    add(key, std::visit([&](const auto* held) { return schema_of(key, held); }, value));
  }

  void directions(const Key& key, std::vector<double>& /*angles*/) override {
    add(key, list_or_range(number(key, "[+-][XY]|")));
  }

  void vectors(const Key& key, std::vector<Eigen::Vector2d>& /*vectors*/) override {
    add(key, list_of(pair_of(number(key))));
  }

  void word(const Key& key, std::span<const std::string_view> words, std::optional<std::size_t>& /*index*/) override {
    add(key, {{"enum", words}});
  }

  void once_or_each(const Key& once, std::initializer_list<std::pair<Key, double*>> each) override {
    Schema common = number(once);
    facts_.bound(common, path_of(each.begin()->first));
    add(once, common, false);
    for (const auto& [key, held] : each) add(key, number(key), false);
  }

  void once_or_twice(const Key& once, const Key& twice, std::optional<double>& /*number*/) override {
    Schema doubled = number(twice);
    facts_.bound(doubled, path_of(once), 2.0);
    add(once, number(once), false);
    add(twice, doubled, false);
  }

  void one_of(const Key& displacement, const Key& load, Target& /*target*/) override {
    add(displacement, number(displacement), false);
    add(load, number(load), false);
  }

  void either(const Key& key, Control /*plain*/, std::optional<Target>& /*target*/) override { add(key, target()); }

  void either(const Key& key, Control /*plain*/, std::optional<PlaneTarget>& /*target*/) override {
    add(key, pair_of(target()));
  }

  bool places(const Key& key, PathPoints& /*points*/) override {
    add(key, {{"type", "array"}, {"items", pair_of(target())}, {"minItems", 1}, {"maxItems", most_points}});
    return false;
  }

  bool file(const Key& key, std::string_view /*other*/,
            const std::function<void(const std::string&)>& /*read*/) override {
    add(key, {{"type", "string"}, {"minLength", 1}});
    return false;
  }

  /// A single table may also be written as a plain table.
  void tables(const Key& key, std::size_t /*count*/,
              const std::function<void(CaseVisitor&, std::size_t)>& describe) override {
    SchemaWriter inner(facts_, path_of(key) + '.');
    describe(inner, 0);
    Schema table = inner.take();
    add(key, {{"type", {"array", "object"}},
              {"items", table},
              {"maxItems", most_bumps},
              {"anyOf", {{{"type", "array"}}, std::move(table)}}});
  }

  [[nodiscard]] bool replaces(const Key& /*key*/) const override { return true; }

  /// An inherited table has the keys of another.
  void table(const Key& key, bool /*given*/, const std::function<void(CaseVisitor&)>& describe) override {
    const bool inherits = key.presence == Presence::inherited;
    SchemaWriter inner(facts_, inherits ? std::string(key.name) + '.' : path_of(key) + '.', inherits);
    describe(inner);
    add(key, inner.take());
  }

 private:
  [[nodiscard]] std::string path_of(const Key& key) const { return path_ + std::string(key.name); }

  static Schema text_or_number(const std::vector<Dimension>& dimensions, std::string_view words = {}) {
    return {{"type", {"number", "string"}}, {"pattern", quantity_pattern(dimensions, words)}};
  }

  static Schema target() { return text_or_number({Dimension::length, Dimension::force}); }

  /// Schema of a number. @param words  pattern of alternative texts, each followed by a bar
  [[nodiscard]] Schema number(const Key& key, std::string_view words = {}) const {
    Schema one{{"type", "number"}};
    if (key.dimension) {
      one = text_or_number({*key.dimension}, words);
    } else if (key.any_dimension) {
      one["type"] = {"number", "string"};
    }
    facts_.bound(one, path_of(key));
    return one;
  }

  static Schema list_of(Schema entry) {
    return {{"type", "array"}, {"items", std::move(entry)}, {"maxItems", most_bumps}};
  }

  static Schema pair_of(Schema entry) {
    return {{"type", "array"}, {"items", std::move(entry)}, {"minItems", 2}, {"maxItems", 2}};
  }

  /// A list of values or a range table with `from`, `to` and others.
  static Schema list_or_range(const Schema& entry) {
    Schema out = list_of(entry);
    Schema end = entry;
    end.erase("minimum");  // the reader checks the generated values
    end.erase("maximum");
    out["type"] = {"array", "object"};
    out["properties"] = {{"from", end}, {"to", end}, {"points", {{"type", "integer"}}}, {"step", end}};
    out["required"] = {"from", "to"};
    out["additionalProperties"] = false;
    return out;
  }

  Schema schema_of(const Key& /*key*/, const std::string* /*held*/) const { return {{"type", "string"}}; }
  Schema schema_of(const Key& /*key*/, const bool* /*held*/) const { return {{"type", "boolean"}}; }
  Schema schema_of(const Key& key, const int* /*held*/) const {
    Schema whole{{"type", "integer"}};
    facts_.bound(whole, path_of(key));
    return whole;
  }
  Schema schema_of(const Key& key, const double* /*held*/) const { return number(key); }
  Schema schema_of(const Key& key, const std::optional<double>* /*held*/) const { return number(key); }
  Schema schema_of(const Key& key, const std::vector<double>* /*held*/) const { return list_or_range(number(key)); }
  Schema schema_of(const Key& /*key*/, const std::vector<std::string>* /*held*/) const {
    return {{"type", {"string", "array"}}, {"items", {{"type", "string"}}}, {"maxItems", most_texts}};
  }
  Schema schema_of(const Key& key, const PerBump* /*held*/) const {
    Schema one = number(key);
    Schema out = one;
    out["type"] = {"number", "string", "array", "object"};
    out["items"] = one;
    out["maxItems"] = most_bumps;
    out["properties"] = {{"start", one}, {"end", one}, {"law", {{"enum", enum_names<Grading>}}}};
    out["required"] = {"start", "end"};
    out["additionalProperties"] = false;
    return out;
  }
  Schema schema_of(const Key& key, const FormedRadius* /*held*/) const {
    return number(key, fmt::format("{}|", name_of(FormedTo::seated)));
  }

  /// @param alone  required if its description says so; the reader checks pairs of alternative keys
  void add(const Key& key, const Schema& value, bool alone = true) {
    Schema described{{"title", key.title}};
    if (!key.text.empty()) described["description"] = key.text;
    described.update(value);
    facts_.exemplify(described, path_of(key));
    properties_[std::string(key.name)] = std::move(described);
    if (alone && !inherits_ && key.presence == Presence::required && key.spared_by.empty()) {
      required_.push_back(key.name);
    }
  }

  const KeyFacts& facts_;
  std::string path_;
  bool inherits_;
  Schema properties_ = Schema::object();
  Schema required_ = Schema::array();
};

}  // namespace

std::string case_schema() {
  const KeyFacts facts;
  SchemaWriter root(facts);
  Case input = presets().front().input;
  // These choices require the fewest tables and keys.
  input.bump_foil.model = BumpFoilModel::former;
  input.bearing = {};
  describe(root, input);
  Schema schema{
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"title", "Case file of Bumpfoil"},
      {"description",
       "Quantities are numbers in SI or texts with a unit. Names of units are in small letters here. `bumpfoil "
       "check` also checks what depends on several keys."}};
  schema.update(root.take());
  return dump_json(schema, 1) + '\n';
}

}  // namespace bumpfoil
