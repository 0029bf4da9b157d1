#include "io/table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <tuple>

#include "bumpfoil/model/validation.hpp"
#include "io/nearest_name.hpp"
#include "io/toml_document.hpp"

namespace bumpfoil {
namespace {

/// More faults are counted, not listed.
constexpr std::size_t most_faults = 50;

/// What a key holds: "bump_foil.truss" for "bump_foil.truss.k1", "x" for "x[3]"; empty for a key of the root.
std::string holder_of(const std::string& key) {
  const std::size_t end = key.back() == ']' ? key.rfind('[') : key.rfind('.');
  return end == std::string::npos ? std::string() : key.substr(0, end);
}

/// The value as written, as far as it fits in a message; empty for lists and tables.
std::string written(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (node.is_array() || node.is_table()) return {};
  std::ostringstream out;
  node.visit([&out](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) out << value;
  });
  return out.str();
}

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

bool is_override(const toml::node& node) {
  return node.source().path && *node.source().path == command_line;
}

std::string is_where(const toml::node& node, std::string_view due) {
  // What is no TOML on the command line is a text, which its author need not know.
  if (node.is_string() && is_override(node)) return fmt::format("is not {}", due);
  return fmt::format("is {} where {} is due", kind_of(node), due);
}

}  // namespace

void ReadingLog::met(const std::string& key, const toml::node& node) {
  const toml::source_region& source = node.source();
  // A table that an override implied stands nowhere.
  const bool overridden = source.begin.line == 0 || is_override(node);
  Origin origin{overridden ? std::string(command_line) : file_, overridden ? 0 : source.begin.line, written(node)};
  origins_.insert_or_assign(key, std::move(origin));
}

const Origin* ReadingLog::place_of(const std::string& key) const {
  for (std::string holder = key; !holder.empty(); holder = holder_of(holder)) {
    if (const auto origin = origins_.find(holder); origin != origins_.end()) return &origin->second;
  }
  return nullptr;
}

void ReadingLog::fault(const std::string& key, std::string what, std::string advice) {
  faulty_.insert(key);
  const Origin* place = place_of(key);
  const auto exact = origins_.find(key);
  add({place != nullptr ? place->file : file_, place != nullptr ? place->line : 0, key,
       exact != origins_.end() ? exact->second.written : std::string(), std::move(what), std::move(advice)});
}

void ReadingLog::later_fault(const Fault& fault) {
  Fault placed = fault;
  if (const auto other = taken_from_.find(fault.key); other != taken_from_.end()) {
    placed.key = other->second;
    if (judged_.contains(placed.key)) return;
  }
  for (std::string holder = placed.key; !holder.empty(); holder = holder_of(holder)) {
    if (faulty_.contains(holder)) return;
  }
  judged_.insert(placed.key);
  const Origin* place = place_of(placed.key);
  placed.file = place != nullptr ? place->file : file_;
  placed.line = place != nullptr ? place->line : 0;
  const auto exact = origins_.find(placed.key);
  if (exact != origins_.end() && !exact->second.written.empty()) placed.value = exact->second.written;
  if (exact != origins_.end() && exact->second.degrees) {
    placed.advice += fmt::format("; numbers are radians: write \"{} deg\" if degrees are meant", placed.value);
  }
  add(std::move(placed));
}

bool ReadingLog::full() const {
  return faults_.size() >= most_faults;
}

void ReadingLog::add(Fault fault, ErrorKind kind) {
  input_fault_ = input_fault_ || kind == ErrorKind::input;
  if (full()) {
    ++unlisted_;
  } else {
    faults_.push_back(std::move(fault));
  }
}

void ReadingLog::throw_if_faulty() {
  if (faults_.empty()) return;
  const auto place = [this](const Fault& fault) { return std::tuple(fault.file != file_, fault.file, fault.line); };
  std::stable_sort(faults_.begin(), faults_.end(),
                   [&place](const Fault& a, const Fault& b) { return place(a) < place(b); });
  if (unlisted_ > 0) {
    faults_.push_back({file_, 0, "", "", fmt::format("and {} more faults", unlisted_), "mend the first ones"});
  }
  throw Error(input_fault_ ? ErrorKind::input : ErrorKind::file, std::move(faults_));
}

TableReader::TableReader(ReadingLog& log, const toml::node* node, std::string path)
    : log_(log), missing_(node == nullptr), path_(std::move(path)) {
  if (node == nullptr) return;
  if (!path_.empty()) log_.met(path_, *node);
  table_ = node->as_table();
  if (table_ == nullptr) {
    log_.fault(path_, is_where(*node, "a table"), fmt::format("write [{}] on a line of its own", path_));
  }
}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const toml::node* TableReader::find(std::string_view key, Presence presence) {
  known_.emplace_back(key);
  if (table_ == nullptr) return nullptr;
  const toml::node* node = table_->get(key);
  if (node != nullptr) {
    log_.met(path_of(key), *node);
  } else if (presence == Presence::required) {
    log_.fault(path_of(key), "is missing", fmt::format("give it in the table [{}]", path_));
  }
  return node;
}

bool TableReader::read_quantity(const std::string& path, const toml::node& node, double& value, Dimension dimension,
                                const std::string& alternatives) {
  if (node.is_number()) {
    value = *node.value<double>();
    if (dimension == Dimension::angle && std::abs(value) > 2.0 * std::numbers::pi) log_.met_degrees(path);
    return true;
  }
  const auto* text = node.as_string();
  if (text == nullptr) {
    log_.fault(path, is_where(node, name_of(dimension)),
               fmt::format("write a text with a unit, for example {}, or a number in {}", example_quantity(dimension),
                           si_unit(dimension)) +
                   alternatives);
    return false;
  }
  const auto quantity = parse_quantity(text->get(), dimension);
  if (const auto* fault = std::get_if<QuantityFault>(&quantity)) {
    log_.fault(path, fault->what, fault->advice + alternatives);
    return false;
  }
  value = std::get<double>(quantity);
  return true;
}

void TableReader::quantity(std::string_view key, double& value, Dimension dimension, Presence presence) {
  if (const toml::node* node = find(key, presence)) read_quantity(path_of(key), *node, value, dimension);
}

void TableReader::quantity(std::string_view key, std::optional<double>& value, Dimension dimension) {
  const toml::node* node = find(key, Presence::optional);
  if (node == nullptr) return;
  if (double number = 0.0; read_quantity(path_of(key), *node, number, dimension)) value = number;
}

void TableReader::quantity(std::string_view key, double& value, Dimension& dimension, Dimension one, Dimension other) {
  const toml::node* node = find(key, Presence::optional);
  if (node == nullptr) return;
  if (const auto* text = node->as_string()) {
    for (const Dimension tried : {one, other}) {
      if (std::holds_alternative<double>(parse_quantity(text->get(), tried))) dimension = tried;
    }
  }
  read_quantity(path_of(key), *node, value, dimension,
                fmt::format(", or {}", example_quantity(dimension == one ? other : one)));
}

void TableReader::number(std::string_view key, double& value, Presence presence) {
  const toml::node* node = find(key, presence);
  if (node == nullptr) return;
  if (node->is_number()) {
    value = *node->value<double>();
  } else {
    log_.fault(path_of(key), is_where(*node, "a number"), "write a number without quotes, such as 0.1");
  }
}

void TableReader::integer(std::string_view key, int& value, Presence presence) {
  const toml::node* node = find(key, presence);
  if (node == nullptr) return;
  const auto* number = node->as_integer();
  if (number == nullptr) {
    log_.fault(path_of(key), is_where(*node, "a whole number"), "write a whole number without quotes, such as 26");
  } else if (number->get() < std::numeric_limits<int>::min() || number->get() > std::numeric_limits<int>::max()) {
    log_.fault(path_of(key), "is out of range", number->get() > 0 ? "give a smaller number" : "give a larger number");
  } else {
    value = static_cast<int>(number->get());
  }
}

void TableReader::flag(std::string_view key, bool& value) {
  const toml::node* node = find(key, Presence::optional);
  if (node == nullptr) return;
  if (const auto* flag = node->as_boolean()) {
    value = flag->get();
  } else {
    log_.fault(path_of(key), is_where(*node, "true or false"), "write true or false without quotes");
  }
}

bool TableReader::text(std::string_view key, std::string& value) {
  const toml::node* node = find(key, Presence::optional);
  if (node == nullptr) return false;
  const auto* text = node->as_string();
  if (text != nullptr) {
    value = text->get();
  } else {
    log_.fault(path_of(key), is_where(*node, "a text"), "write it in quotes");
  }
  return text != nullptr;
}

int TableReader::index_of_word(std::string_view key, const std::vector<std::string>& words) {
  const toml::node* node = find(key, Presence::optional);
  if (node == nullptr) return -1;
  const std::string choices = fmt::format("write one of \"{}\"", fmt::join(words, "\", \""));
  const auto* text = node->as_string();
  if (text == nullptr) {
    log_.fault(path_of(key), is_where(*node, "a word in quotes"), choices);
    return -1;
  }
  const auto word = std::find(words.begin(), words.end(), text->get());
  if (word != words.end()) return static_cast<int>(word - words.begin());
  const auto nearest = nearest_name(text->get(), words);
  log_.fault(path_of(key), "is not known here", nearest ? fmt::format("did you mean \"{}\"?", *nearest) : choices);
  return -1;
}

void TableReader::quantities(std::string_view key, std::vector<double>& values, Dimension dimension, Presence presence,
                             const std::map<std::string, double, std::less<>>& names) {
  const toml::node* node = find(key, presence);
  if (node == nullptr) return;
  const auto* list = node->as_array();
  if (list == nullptr) {
    log_.fault(path_of(key), is_where(*node, "a list"),
               fmt::format("write a list in brackets: [{}]", names.empty() ? example_quantity(dimension) : "\"+X\""));
    return;
  }
  if (list->size() > static_cast<std::size_t>(most_bumps)) {
    log_.fault(path_of(key), fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
    return;
  }
  std::string alternatives;
  for (const auto& [name, value] : names)
    alternatives += fmt::format("{} \"{}\"", alternatives.empty() ? ", or" : ",", name);
  values.assign(list->size(), 0.0);
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::node& entry = *list->get(i);
    const std::string path = fmt::format("{}[{}]", path_of(key), i + 1);
    log_.met(path, entry);
    const auto* word = entry.as_string();
    const auto named = word != nullptr ? names.find(word->get()) : names.end();
    if (named != names.end()) {
      values[i] = named->second;
    } else {
      read_quantity(path, entry, values[i], dimension, alternatives);
    }
  }
}

TableReader TableReader::table(std::string_view key) {
  const toml::node* node = find(key, Presence::optional);
  return {log_, node, path_of(key)};
}

void TableReader::finish() {
  if (table_ == nullptr) return;
  for (const auto& [key, node] : *table_) {
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
