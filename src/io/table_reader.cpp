#include "io/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "bumpfoil/core/nearest_name.hpp"
#include "bumpfoil/model/validation.hpp"
#include "io/toml_document.hpp"

namespace bumpfoil {
namespace {

/// A word that stands for a number.
using NamedNumber = std::pair<std::string_view, double>;

constexpr std::array axes{NamedNumber{"+X", 0.0}, NamedNumber{"+Y", 0.5 * std::numbers::pi},
                          NamedNumber{"-X", std::numbers::pi}, NamedNumber{"-Y", 1.5 * std::numbers::pi}};

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

std::string is_where(const toml::node& node, std::string_view due) {
  // What is no TOML on the command line is a text, which its author need not know.
  if (node.is_string() && is_override(node)) return fmt::format("is not {}", due);
  return fmt::format("is {} where {} is due", kind_of(node), due);
}

/// Reads what a key holds into its value; faults go into the log.
struct ValueReader {
  ReadingLog& log;
  const std::string& path;
  const toml::node& node;
  std::optional<Dimension> dimension{};
  std::string alternatives{};  ///< what else may be written

  void refuse(std::string_view due, std::string advice) const {
    log.fault(path, is_where(node, due), std::move(advice));
  }

  void operator()(std::string* value) const {
    if (const auto* text = node.as_string()) {
      *value = text->get();
    } else {
      refuse("a text", "write it in quotes");
    }
  }

  void operator()(bool* value) const {
    if (const auto* flag = node.as_boolean()) {
      *value = flag->get();
    } else {
      refuse("true or false", "write true or false without quotes");
    }
  }

  void operator()(int* value) const {
    const auto* number = node.as_integer();
    if (number == nullptr) {
      refuse("a whole number", "write a whole number without quotes, such as 26");
    } else if (number->get() < std::numeric_limits<int>::min() || number->get() > std::numeric_limits<int>::max()) {
      log.fault(path, "is out of range", number->get() > 0 ? "give a smaller number" : "give a larger number");
    } else {
      *value = static_cast<int>(number->get());
    }
  }

  void operator()(double* value) const {
    std::optional<double> number;
    (*this)(&number);
    if (number) *value = *number;
  }

  void operator()(std::optional<double>* value) const {
    if (node.is_number()) {
      *value = node.value<double>();
      if (dimension == Dimension::angle && std::abs(**value) > 2.0 * std::numbers::pi) log.met_degrees(path);
    } else if (!dimension) {
      refuse("a number", "write a number without quotes, such as 0.1");
    } else if (const auto* text = node.as_string()) {
      const auto quantity = parse_quantity(text->get(), *dimension);
      if (const auto* fault = std::get_if<QuantityFault>(&quantity)) {
        log.fault(path, fault->what, fault->advice + alternatives);
      } else {
        *value = std::get<double>(quantity);
      }
    } else {
      refuse(name_of(*dimension), fmt::format("write a text with a unit, for example {}, or a number in {}{}",
                                              example_quantity(*dimension), si_unit(*dimension), alternatives));
    }
  }

  void operator()(PerBump* value) const {
    if (node.is_array()) {
      std::vector<double> each;
      (*this)(&each);
      *value = PerBump(std::move(each));
    } else {
      double common = 0.0;
      (*this)(&common);
      *value = common;
    }
  }

  /// Entries that are faulty become zero.
  void operator()(std::vector<double>* value) const { read_list(*value, {}); }

  void read_list(std::vector<double>& values, std::span<const NamedNumber> names) const {
    const auto* list = node.as_array();
    if (list == nullptr) {
      return refuse("a list", fmt::format("write a list in brackets: [{}]",
                                          names.empty() ? example_quantity(*dimension) : "\"+X\""));
    }
    if (list->size() > static_cast<std::size_t>(most_bumps)) {
      return log.fault(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
    }
    std::string words;
    for (const auto& [name, number] : names) words += fmt::format("{} \"{}\"", words.empty() ? ", or" : ",", name);
    values.assign(list->size(), 0.0);
    for (std::size_t i = 0; i < list->size(); ++i) {
      const toml::node& entry = *list->get(i);
      const std::string entry_path = fmt::format("{}[{}]", path, i + 1);
      log.met(entry_path, entry);
      const std::string word = entry.value_or(std::string());
      const auto named = std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.first == word; });
      if (named != names.end()) {
        values[i] = named->second;
      } else {
        ValueReader{log, entry_path, entry, dimension, words}(&values[i]);
      }
    }
  }
};

constexpr Dimension dimension_of(Control control) {
  return control == Control::displacement ? Dimension::length : Dimension::force;
}

/// What the unit of a text tells; absent of a plain number, or a text that is neither.
std::optional<Control> control_of(const toml::node& node) {
  const auto* text = node.as_string();
  if (text == nullptr) return std::nullopt;
  for (const Control control : {Control::displacement, Control::load}) {
    if (std::holds_alternative<double>(parse_quantity(text->get(), dimension_of(control)))) return control;
  }
  return std::nullopt;
}

void read_target(ReadingLog& log, const std::string& path, const toml::node& node, Control control, double& value) {
  const Control other = control == Control::displacement ? Control::load : Control::displacement;
  ValueReader{log, path, node, dimension_of(control),
              fmt::format(", or {}", example_quantity(dimension_of(other)))}(&value);
}

/// The two entries of a vector in the X-Y plane; null where it is none, which goes into the log.
const toml::array* plane_vector(ReadingLog& log, const std::string& path, const toml::node& node,
                                std::string_view example) {
  const auto* list = node.as_array();
  if (list != nullptr && list->size() == 2) return list;
  log.fault(path, list == nullptr ? is_where(node, "a list") : fmt::format("has {} entries", list->size()),
            fmt::format("give two, along X and Y: {}", example));
  return nullptr;
}

/// A list of two, along X and Y; absent where it is none.
std::optional<PlaneTarget> read_place(ReadingLog& log, const std::string& path, const toml::node& node, Control plain,
                                      std::string_view example) {
  const toml::array* list = plane_vector(log, path, node, example);
  if (list == nullptr) return std::nullopt;
  std::optional<Control> control;
  for (const toml::node& entry : *list) {
    const std::optional<Control> met = control_of(entry);
    if (met && control.value_or(*met) != *met) {
      log.fault(path, "mixes a displacement and a load", "give two lengths or two forces");
      return std::nullopt;
    }
    if (met) control = met;
  }
  PlaneTarget read{.control = control.value_or(plain)};
  for (const int axis : {0, 1}) {
    const std::string entry_path = fmt::format("{}[{}]", path, axis + 1);
    const toml::node& entry = *list->get(static_cast<std::size_t>(axis));
    log.met(entry_path, entry);
    read_target(log, entry_path, entry, read.control, read.value[axis]);
  }
  return read;
}

Key optional_key(Key key) {
  key.presence = Presence::optional;
  return key;
}

void read_places(ReadingLog& log, const std::string& path, const toml::node& node, std::string_view example,
                 PathPoints& points) {
  const auto* list = node.as_array();
  if (list == nullptr || list->empty()) {
    return log.fault(path, list == nullptr ? is_where(node, "a list") : "is empty",
                     fmt::format("give pairs along X and Y: {}", example));
  }
  if (list->size() > static_cast<std::size_t>(most_points)) {
    return log.fault(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_points));
  }
  PathPoints read;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string entry_path = fmt::format("{}[{}]", path, i + 1);
    const toml::node& entry = *list->get(i);
    log.met(entry_path, entry);
    const auto place = read_place(log, entry_path, entry, read.control, "[\"0 um\", \"-40 um\"]");
    if (!place) return;
    if (i > 0 && place->control != read.control) {
      return log.fault(entry_path, "mixes displacements and loads", "give lengths only, or forces only");
    }
    read.control = place->control;
    read.values.push_back(place->value);
  }
  points = std::move(read);
}

/// @param contradicted  a list that is given as well, if any
void read_file(ReadingLog& log, const std::string& path, const toml::node& node, std::string_view contradicted,
               const std::function<void(const std::string&)>& read) {
  std::string name;
  ValueReader{log, path, node}(&name);
  if (!node.is_string()) return;
  if (name.empty()) return log.fault(path, "is empty", "give the name of a file, or leave it out");
  if (!contradicted.empty()) {
    return log.fault(path, fmt::format("contradicts {}, which is given too", contradicted), "give one of the two");
  }
  try {
    read((std::filesystem::path(log.file()).parent_path() / name).string());
  } catch (const Error& error) {
    for (const Fault& fault : error.faults()) log.add(fault, error.kind());
  }
}

}  // namespace

std::string TableReader::path_of(std::string_view name) const {
  return path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name);
}

/// What the key holds and where that stands: under its own path, or under that whose value it takes. Null if there is
/// nothing.
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
    log_.fault(path, "is missing", fmt::format("give it in the table [{}]", path_));
  }
  return {nullptr, path};
}

/// What goes along the foil by a law.
void TableReader::graded(const Key& key, const toml::table& ends, const std::string& path, PerBump& dimension) {
  const auto named = [&key](std::string_view name, Presence presence) {
    Key own = key;
    own.name = name;
    own.presence = presence;
    return own;
  };
  PerBump read(0.0, 0.0, Grading::linear);
  TableReader reader(*this, ends, path);
  reader.value(named("start", Presence::required), &read.values.front());
  reader.value(named("end", Presence::required), &read.values.back());
  reader.choice(named("law", Presence::defaulted), *read.law);
  reader.finish();
  dimension = std::move(read);
}

void TableReader::value(const Key& key, Value value) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const auto* dimension = std::get_if<PerBump*>(&value);
  if (dimension != nullptr && node->is_table()) return graded(key, *node->as_table(), path, **dimension);
  std::visit(ValueReader{log_, path, *node, key.dimension}, value);
}

void TableReader::directions(const Key& key, std::vector<double>& angles) {
  const auto [node, path] = find(key);
  if (node != nullptr) ValueReader{log_, path, *node, key.dimension}.read_list(angles, axes);
}

void TableReader::vectors(const Key& key, std::vector<Eigen::Vector2d>& vectors) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const auto* list = node->as_array();
  if (list == nullptr) {
    return log_.fault(path, is_where(*node, "a list"), fmt::format("write a list of vectors: {}", key.example));
  }
  if (list->size() > static_cast<std::size_t>(most_bumps)) {
    return log_.fault(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
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

void TableReader::word(const Key& key, std::span<const std::string_view> words, std::size_t& index) {
  const auto [node, path] = find(key);
  if (node == nullptr) return;
  const std::string choices = fmt::format("write one of \"{}\"", fmt::join(words, "\", \""));
  const auto* text = node->as_string();
  if (text == nullptr) return log_.fault(path, is_where(*node, "a word in quotes"), choices);
  const auto word = std::find(words.begin(), words.end(), text->get());
  if (word != words.end()) {
    index = static_cast<std::size_t>(word - words.begin());
    return;
  }
  const auto nearest = nearest_name(text->get(), {words.begin(), words.end()});
  log_.fault(path, "is not known here", nearest ? fmt::format("did you mean \"{}\"?", *nearest) : choices);
}

void TableReader::once_or_each(const Key& once, std::initializer_list<std::pair<Key, double*>> each) {
  std::vector<std::string_view> names;
  for (const auto& [key, number] : each) names.push_back(key.name);
  const bool any = std::any_of(each.begin(), each.end(), [this](const auto& one) { return has(one.first); });
  std::optional<double> common;
  value(optional_key(once), &common);
  if (has(once) && any) {
    log_.fault(path_of(once.name), fmt::format("contradicts {}, which are given too", fmt::join(names, " or ")),
               "give either it or all of the others");
  } else if (!has(once) && !any) {
    log_.fault(path_of(once.name), "is missing",
               fmt::format("give it ({}), or {}", once.text, fmt::join(names, " and ")));
  }
  for (const auto& [key, number] : each) {
    if (has(once)) log_.taken_from(path_of(key.name), path_of(once.name));
    if (common) *number = *common;
    value(any && !has(once) ? key : optional_key(key), number);
  }
}

/// Of two keys of which one is to be given, and the first is missed where none is.
bool TableReader::second_counts(const Key& first, const Key& second) {
  if (!has(first) || !has(second)) return has(second);
  const toml::node& node = *table_.get(first.name);
  const bool overridden = is_override(*table_.get(second.name));
  // On the command line, one stands in for the other.
  if (is_override(node) != overridden) return overridden;
  log_.met(path_of(first.name), node);
  log_.fault(path_of(first.name), fmt::format("contradicts {}, which is given too", second.name),
             "give one of the two");
  return true;
}

void TableReader::once_or_twice(const Key& once, const Key& twice, std::optional<double>& number) {
  const bool doubled = second_counts(once, twice);
  std::optional<double> unused;
  std::optional<double> two;
  value(doubled ? optional_key(once) : once, doubled ? &unused : &number);
  value(optional_key(twice), doubled ? &two : &unused);
  if (!doubled) return;
  if (two) number = 0.5 * *two;
  log_.taken_from(path_of(once.name), path_of(twice.name));
}

void TableReader::one_of(const Key& displacement, const Key& load, Target& target) {
  const bool by_load = second_counts(displacement, load);
  double unused = 0.0;
  value(by_load ? optional_key(displacement) : displacement, by_load ? &unused : &target.value);
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
  const auto* list = table_.get_as<toml::array>(other);
  read_file(log_, path, *node, list != nullptr && !list->empty() ? other : "", read);
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
  if (node->is_table()) return read(*node->as_table(), 0);  // one alone is written as other tables are
  const auto* list = node->as_array();
  if (list == nullptr || (!list->empty() && !list->is_homogeneous<toml::table>())) {
    return log_.fault(path, is_where(*node, "a list of tables"),
                      fmt::format("write [[{}]] on a line of its own before the keys of each", path));
  }
  if (list->size() > static_cast<std::size_t>(most_bumps)) {
    return log_.fault(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
  }
  for (std::size_t i = 0; i < list->size(); ++i) read(*list->get(i)->as_table(), i);
}

void TableReader::table(const Key& key, bool /*given*/, const std::function<void(CaseVisitor&)>& describe) {
  known_.emplace_back(key.name);
  const std::string path = path_of(key.name);
  const toml::node* node = table_.get(key.name);
  if (node == nullptr) {
    if (key.presence == Presence::required) {
      log_.fault(path, "this table is missing",
                 fmt::format("add [{}] with its keys{}{}", path, key.text.empty() ? "" : ", ", key.text));
    }
    return;
  }
  log_.met(path, *node);
  const toml::table* inner = node->as_table();
  if (inner == nullptr) {
    return log_.fault(path, is_where(*node, "a table"), fmt::format("write [{}] on a line of its own", path));
  }
  TableReader reader(*this, *inner, path, key.presence == Presence::inherited);
  describe(reader);
  reader.finish();
}

void TableReader::finish() {
  for (const auto& [key, node] : table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string path = path_of(name);
    if (log_.full()) {  // counted all the same, but a million unknown keys need no million suggestions
      log_.add({});
      continue;
    }
    log_.met(path, node);
    const auto nearest = nearest_name(name, known_);
    const std::string_view what =
        node.is_table() || node.is_array_of_tables() ? "is no known table" : "is no known key";
    log_.fault(path, std::string(what),
               nearest ? fmt::format("did you mean \"{}\"?", *nearest)
                       : fmt::format("known here: {}", fmt::join(known_, ", ")));
  }
}

}  // namespace bumpfoil
