#include "case/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bumpfoil/core/nearest_name.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/key_suggestion.hpp"
#include "case/toml_document.hpp"
#include "case/value_reader.hpp"

namespace bumpfoil {
namespace {

/// ".height" for a table created by an override of "foil.height"; else empty.
std::string key_set_in(const toml::node& node) {
  const toml::table* table = node.as_table();
  if (table == nullptr || node.source().begin.line > 0 || table->size() != 1) return {};
  return fmt::format(".{}{}", table->begin()->first.str(), key_set_in(table->begin()->second));
}

/// Fraction of a step by which a range may miss its end: round-off of thirds and of units.
constexpr double step_round_off = 1e-6;

Key optional_key(Key key) {
  key.presence = Presence::optional;
  return key;
}

/// A key of a table that replaces a value of `key`.
Key key_called(std::string_view name, Presence presence, Key key) {
  key.name = name;
  key.presence = presence;
  return key;
}

/// The first of two alternative keys, required unless the second is given.
Key first_key(Key first, const Key& second, bool second_counts) {
  first.stand_in = second.name;
  return second_counts ? optional_key(first) : first;
}

/// @param contradicted  a list or table that is also given, if any
/// @param other         key that the file replaces
void read_file(ReadingLog& log, const std::string& path, const toml::node& node, std::string_view contradicted,
               const std::string& other, const std::function<void(const std::string&)>& read) {
  std::string name;
  ValueReader{log, path, node}(&name);
  if (!node.is_string()) return;
  if (name.empty()) return log.error(path, "is empty", "give the name of a file, or leave it out");
  if (!contradicted.empty()) {
    return log.error(path, fmt::format("conflicts with {}, which is also given", contradicted), "give one of the two");
  }
  try {
    read((std::filesystem::path(log.file()).parent_path() / name).string());
  } catch (const Error& error) {
    for (const InputError& one : error.errors()) log.add(one, error.kind());
    log.mark_reported(other);
  }
}

}  // namespace

std::string TableReader::path_of(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

/// The value of the key and its path: its own, or that of the key it defaults to. Null if absent.
std::pair<const toml::node*, std::string> TableReader::find(const Key& key) {
  known_.emplace_back(key.name);
  const std::string path = path_of(key.name);
  if (const toml::node* node = table_.get(key.name)) {
    log_.met(path, *node);
    return {node, path};
  }
  if (inherits_) return {nullptr, path};
  if (!key.otherwise.empty()) {
    log_.taken_from(path, std::string(key.otherwise));
    return {root_.at_path(key.otherwise).node(), std::string(key.otherwise)};
  }
  if (key.presence == Presence::required && (key.spared_by.empty() || !root_.contains(key.spared_by))) {
    log_.error(path, "is missing",
               fmt::format("give it in the table [{}]{}", path_,
                           key.stand_in.empty() ? "" : fmt::format(", or {} in its place", path_of(key.stand_in))));
  }
  return {nullptr, path};
}

/// Equally spaced values including both ends; none if the range is invalid.
void TableReader::range(const Key& key, const toml::table& ends, const std::string& path, std::vector<double>& values) {
  std::optional<double> from;
  std::optional<double> to;
  std::optional<double> step;
  int points = 0;
  TableReader reader(*this, ends, path);
  reader.value(key_called("from", Presence::required, key), &from);
  reader.value(key_called("to", Presence::required, key), &to);
  reader.value({.name = "points", .presence = Presence::optional, .title = "Number of values"}, &points);
  reader.value(key_called("step", Presence::optional, key), &step);
  reader.finish();
  const auto refuse = [&](const std::string& where, std::string what, std::string advice) {
    log_.error(where, std::move(what), std::move(advice));
    log_.mark_reported(path);
  };
  const bool counted = ends.contains("points");
  if (counted == ends.contains("step")) {
    return refuse(path, counted ? "has both points and step" : "has neither points nor step",
                  "give one of the two: how many values there are, or how far apart they lie");
  }
  if (!from || !to || (!counted && !step)) return log_.mark_reported(path);
  const double span = *to - *from;
  double spaces = counted ? points - 1.0 : span == 0.0 ? 0.0 : *step == 0.0 ? -1.0 : span / *step;
  const std::string last = path + (counted ? ".points" : ".step");
  if (!counted && std::abs(spaces - std::round(spaces)) <= step_round_off) spaces = std::round(spaces);
  if (!(spaces >= 0.0)) {  // also rejects NaN
    return refuse(last, counted ? "is not a valid number of values" : "does not lead to the last value",
                  counted ? "give a whole number from 2 on" : "give a step from the first value to the last");
  }
  if (spaces >= most_bumps) {
    return refuse(last, fmt::format("makes {:.6g} values", spaces + 1.0), fmt::format("give at most {}", most_bumps));
  }
  if (spaces != std::floor(spaces)) {
    return refuse(last, "does not lead to the last value", "give a step that fits, or points in its place");
  }
  if ((spaces == 0.0) != (span == 0.0)) {
    return refuse(last, span == 0.0 ? "repeats the same value" : "is 1, but the ends differ",
                  span == 0.0 ? "give one point, or ends that differ" : "give 2 or more");
  }
  values.assign(static_cast<std::size_t>(spaces) + 1, *to);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) values[i] = *from + static_cast<double>(i) * span / spaces;
}

/// Values that follow a law along the foil.
void TableReader::graded(const Key& key, const toml::table& ends, const std::string& path, PerBump& dimension) {
  PerBump read(0.0, 0.0, Grading::linear);
  TableReader reader(*this, ends, path);
  reader.value(key_called("start", Presence::required, key), &read.values.front());
  reader.value(key_called("end", Presence::required, key), &read.values.back());
  reader.choice(key_called("law", Presence::defaulted, key), *read.law);
  reader.finish();
  dimension = std::move(read);
}

void TableReader::value(const Key& key, Value value) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  if (key.any_dimension && node->is_string()) return;  // the error belongs to the key that names it
  const auto* dimension = std::get_if<PerBump*>(&value);
  if (dimension != nullptr && node->is_table()) return graded(key, *node->as_table(), path, **dimension);
  const auto* list = std::get_if<std::vector<double>*>(&value);
  if (list != nullptr && node->is_table()) return range(key, *node->as_table(), path, **list);
  std::visit(ValueReader{log_, path, *node, key.dimension}, value);
}

void TableReader::directions(const Key& key, std::vector<double>& angles) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  if (node->is_table()) return range(key, *node->as_table(), path, angles);
  ValueReader{log_, path, *node, key.dimension}.directions(angles);
}

void TableReader::vectors(const Key& key, std::vector<Eigen::Vector2d>& vectors) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const auto* list = node->as_array();
  if (list == nullptr) {
    return log_.error(path, is_where(*node, "a list"), fmt::format("write a list of vectors: {}", key.example));
  }
  if (list->size() > static_cast<std::size_t>(most_bumps)) {
    return log_.error(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
  }
  vectors.assign(list->size(), Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string vector_path = fmt::format("{}[{}]", path, i + 1);
    const toml::node& vector = *list->get(i);
    log_.met(vector_path, vector);
    const toml::array* entries = plane_vector(log_, vector_path, vector, key.example);
    if (entries == nullptr) continue;
    for (const int axis : {0, 1}) {
      const std::string entry_path = fmt::format("{}[{}]", vector_path, axis + 1);
      const toml::node& entry = *entries->get(static_cast<std::size_t>(axis));
      log_.met(entry_path, entry);
      ValueReader{log_, entry_path, entry, key.dimension}(&vectors[i][axis]);
    }
  }
}

void TableReader::word(const Key& key, std::span<const std::string_view> words, std::optional<std::size_t>& index) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const std::string choices = fmt::format("write one of \"{}\"", fmt::join(words, "\", \""));
  const auto* text = node->as_string();
  if (text == nullptr) return log_.error(path, is_where(*node, "a word in quotes"), choices);
  const auto word = std::find(words.begin(), words.end(), text->get());
  if (word != words.end()) {
    index = static_cast<std::size_t>(word - words.begin());
    return;
  }
  const auto nearest = nearest_name(text->get(), {words.begin(), words.end()});
  log_.error(path, "unknown value", nearest ? fmt::format("did you mean \"{}\"?", *nearest) : choices);
}

void TableReader::once_or_each(const Key& once, std::initializer_list<std::pair<Key, double*>> each) {
  std::vector<std::string_view> names;
  for (const auto& [key, number] : each) names.push_back(key.name);
  const bool any = std::any_of(each.begin(), each.end(), [this](const auto& one) { return has(one.first); });
  std::optional<double> common;
  value(optional_key(once), &common);
  if (has(once) && any) {
    log_.error(path_of(once.name), fmt::format("conflicts with {}, which are also given", fmt::join(names, " or ")),
               "give either it or all of the others");
  } else if (!has(once) && !any) {
    log_.error(path_of(once.name), "is missing",
               fmt::format("give it ({}), or {}", once.text, fmt::join(names, " and ")));
  }
  for (const auto& [key, number] : each) {
    if (has(once)) log_.taken_from(path_of(key.name), path_of(once.name));
    if (common) *number = *common;
    value(any && !has(once) ? key : optional_key(key), number);
  }
}

/// Whether the second of two alternative keys is given; if neither is, the first is reported missing.
bool TableReader::second_counts(const Key& first, const Key& second) {
  if (!has(first) || !has(second)) return has(second);
  const toml::node& node = *table_.get(first.name);
  const bool overridden = is_override(*table_.get(second.name));
  // On the command line, one replaces the other.
  if (is_override(node) != overridden) return overridden;
  log_.met(path_of(first.name), node);
  log_.error(path_of(first.name), fmt::format("conflicts with {}, which is also given", second.name),
             "give one of the two");
  return true;
}

void TableReader::once_or_twice(const Key& once, const Key& twice, std::optional<double>& number) {
  const bool doubled = second_counts(once, twice);
  std::optional<double> unused;
  std::optional<double> two;
  value(first_key(once, twice, doubled), doubled ? &unused : &number);
  value(optional_key(twice), doubled ? &two : &unused);
  if (!doubled) return;
  if (two) number = 0.5 * *two;
  log_.taken_from(path_of(once.name), path_of(twice.name));
}

void TableReader::one_of(const Key& displacement, const Key& load, Target& target) {
  const bool by_load = second_counts(displacement, load);
  double unused = 0.0;
  value(first_key(displacement, load, by_load), by_load ? &unused : &target.value);
  value(optional_key(load), by_load ? &target.value : &unused);
  target.control = by_load ? Control::load : Control::displacement;
}

void TableReader::either(const Key& key, Control plain, std::optional<Target>& target) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  Target read{control_of(*node).value_or(plain), 0.0};
  read_target(log_, path, *node, read.control, read.value);
  target = read;
}

void TableReader::either(const Key& key, Control plain, std::optional<PlaneTarget>& target) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const std::optional<PlaneTarget> read = read_place(log_, path, *node, plain, key.example);
  if (read) target = read;
}

bool TableReader::places(const Key& key, PathPoints& points) {
  const auto [node, path] = find(key);
  if (node != nullptr) read_places(log_, path, *node, key.example, points);
  return node != nullptr;
}

bool TableReader::file(const Key& key, std::string_view other, const std::function<void(const std::string&)>& read) {
  const auto [node, path] = find(key);
  if (node == nullptr) return false;
  const toml::node* held = table_.get(other);
  const auto* list = held == nullptr ? nullptr : held->as_array();
  const bool contradicts = held != nullptr && (list == nullptr ? held->is_table() : !list->empty());
  read_file(log_, path, *node, contradicts ? other : "", path_of(other), read);
  return true;
}

void TableReader::tables(const Key& key, std::size_t /*count*/,
                         const std::function<void(CaseVisitor&, std::size_t)>& describe) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const auto read = [&, &where = path](const toml::table& entry, std::size_t i) {
    const std::string entry_path = fmt::format("{}[{}]", where, i + 1);
    log_.met(entry_path, entry);
    TableReader reader(*this, entry, entry_path);
    describe(reader, i);
    reader.finish();
  };
  if (node->is_table()) return read(*node->as_table(), 0);  // a single table may also be written as a plain table
  const auto* list = node->as_array();
  if (list == nullptr || (!list->empty() && !list->is_homogeneous<toml::table>())) {
    return log_.error(path, is_where(*node, "a list of tables"),
                      fmt::format("write [[{}]] on a line of its own before the keys of each", path));
  }
  if (list->size() > static_cast<std::size_t>(most_bumps)) {
    return log_.error(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
  }
  for (std::size_t i = 0; i < list->size(); ++i) read(*list->get(i)->as_table(), i);
}

void TableReader::table(const Key& key, bool /*given*/, const std::function<void(CaseVisitor&)>& describe) {
  known_.emplace_back(key.name);
  const std::string path = path_of(key.name);
  const toml::node* node = table_.get(key.name);
  if (node == nullptr) {
    if (key.presence == Presence::required) {
      log_.error(path, "this table is missing",
                 fmt::format("add [{}] with its keys{}{}", path, key.text.empty() ? "" : ", ", key.text));
    }
    return;
  }
  log_.met(path, *node);
  const toml::table* inner = node->as_table();
  if (inner == nullptr) {
    return log_.error(path, is_where(*node, "a table"),
                      is_override(*node) ? fmt::format("set one of its keys, such as {}", first_key_of(path))
                                         : fmt::format("write [{}] on a line of its own", path));
  }
  TableReader reader(*this, *inner, path, key.presence == Presence::inherited);
  describe(reader);
  reader.finish();
}

/// Suggests for an unknown key a similar one here, or one of another table.
std::string TableReader::advice_on_unknown(const std::string& name, const toml::node& node) const {
  const std::vector<std::string> paths = key_paths();
  std::vector<std::string> keys = keys_with_words(name + key_set_in(node), paths);
  const auto nearest = nearest_name(name, known_);
  // Outside all tables, a missing table header is more likely.
  if (nearest && (keys.empty() || !path_.empty())) return did_you_mean({*nearest});
  if (keys.empty()) keys = keys_near(name, paths);
  return keys.empty() ? fmt::format("known here: {}", fmt::join(known_, ", ")) : did_you_mean(keys);
}

void TableReader::finish() {
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string path = path_of(name);
    if (log_.full()) {  // still counted, but a million unknown keys need no suggestions
      log_.add({});
      continue;
    }
    log_.met(path, node);
    const std::string_view what = node.is_table() || node.is_array_of_tables() ? "unknown table" : "unknown key";
    log_.error(path, std::string(what), advice_on_unknown(name, node));
  }
}

}  // namespace bumpfoil
