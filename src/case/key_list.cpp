#include "case/key_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

#include "bumpfoil/core/nearest_name.hpp"
#include "case/case_json.hpp"
#include "case/key_suggestion.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Without its article.
std::string_view noun(const Key& key) {
  return key.dimension ? name_of(*key.dimension).substr(name_of(*key.dimension).find(' ') + 1) : "number";
}

std::string plural(std::string_view noun) {
  if (noun.ends_with('s')) return fmt::format("{}es", noun);
  return noun.ends_with('y') ? fmt::format("{}ies", noun.substr(0, noun.size() - 1)) : fmt::format("{}s", noun);
}

struct KindOf {
  const Key& key;
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const int*) const { return "whole number"; }
  std::string operator()(const double*) const { return std::string(noun(key)); }
  std::string operator()(const std::optional<double>*) const { return std::string(noun(key)); }
  std::string operator()(const std::vector<double>*) const { return "list of " + plural(noun(key)); }
  std::string operator()(const std::vector<std::string>*) const { return "text, or list of texts"; }
  std::string operator()(const PerBump*) const { return fmt::format("{}, list or law", noun(key)); }
  std::string operator()(const FormedRadius*) const {
    return fmt::format("{} or \"{}\"", noun(key), name_of(FormedTo::seated));
  }
};

Json json_of(const std::optional<double>* number) {
  return *number ? Json(**number) : Json();
}
Json json_of(const std::vector<double>* list) {
  return list->empty() ? Json() : Json(*list);
}
Json json_of(const std::vector<std::string>* list) {
  return list->empty() ? Json() : Json(*list);
}
Json json_of(const PerBump* dimension) {
  if (dimension->is_list()) return dimension->values;
  if (!dimension->law) return dimension->values.front();
  return {{"start", dimension->values.front()}, {"end", dimension->values.back()}, {"law", name_of(*dimension->law)}};
}
Json json_of(const FormedRadius* formed) {
  if (formed->to == FormedTo::bearing) return {};
  return formed->to == FormedTo::radius ? Json(formed->radius) : Json(name_of(formed->to));
}
template <typename T>
Json json_of(const T* value) {
  return *value;
}

/// A target whose kind differs from that of a plain number carries its unit.
Json json_of(double target, Control control, Control plain) {
  if (control == plain) return target;
  return fmt::format("{:.17g} {}", target, control == Control::load ? "N" : "m");
}

/// SI numbers as texts with a unit, which is `one` in SI.
std::string in_unit(const Json& value, std::string_view unit, double one) {
  if (value.is_number()) return fmt::format("\"{:.12g} {}\"", value.get<double>() / one, unit);
  if (!value.is_array()) return toml_of(value);
  std::vector<std::string> entries;
  entries.reserve(value.size());
  for (const Json& entry : value) entries.push_back(in_unit(entry, unit, one));
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

class KeyLister final : public CaseVisitor {
 public:
  explicit KeyLister(std::vector<ListedKey>& list) : list_(list) {}

  void value(const Key& key, Value value) override {
    add(key, std::visit(KindOf{key}, value), std::visit([](const auto* held) { return json_of(held); }, value));
  }

  void directions(const Key& key, std::vector<double>& angles) override {
    add(key, "list of directions", json_of(&angles));
  }

  void vectors(const Key& key, std::vector<Eigen::Vector2d>& vectors) override {
    Json value;
    for (const Eigen::Vector2d& vector : vectors) value.push_back({vector.x(), vector.y()});
    add(key, "list of pairs of " + plural(noun(key)), std::move(value));
  }

  void word(const Key& key, std::span<const std::string_view> words, std::optional<std::size_t>& index) override {
    add(key, fmt::format("\"{}\"", fmt::join(words, "\", \"")), index ? Json(words[*index]) : Json());
  }

  void once_or_each(const Key& once, std::initializer_list<std::pair<Key, double*>> each) override {
    const double first = *each.begin()->second;
    const bool same = std::all_of(each.begin(), each.end(), [&](const auto& one) { return *one.second == first; });
    add(once, "number", first, !same).held = false;
    for (const auto& [key, number] : each) add(key, "number", *number, same);
  }

  void once_or_twice(const Key& once, const Key& twice, std::optional<double>& number) override {
    add(once, std::string(noun(once)), json_of(&number));
    add(twice, std::string(noun(twice)), number ? Json(2.0 * *number) : Json(), true).held = false;
  }

  void one_of(const Key& displacement, const Key& load, Target& target) override {
    const bool by_load = target.control == Control::load;
    add(displacement, std::string(noun(displacement)), by_load ? Json() : Json(target.value), by_load);
    add(load, std::string(noun(load)), by_load ? Json(target.value) : Json(), !by_load);
  }

  void either(const Key& key, Control plain, std::optional<Target>& target) override {
    add(key, "length or force", target ? json_of(target->value, target->control, plain) : Json());
  }

  void either(const Key& key, Control plain, std::optional<PlaneTarget>& target) override {
    Json value;
    if (target) {
      for (const double along : target->value) value.push_back(json_of(along, target->control, plain));
    }
    add(key, "two lengths or forces", std::move(value));
  }

  bool places(const Key& key, PathPoints& points) override {
    Json list;
    for (const Eigen::Vector2d& point : points.values) {
      Json pair;
      for (const double along : point) pair.push_back(json_of(along, points.control, Control::displacement));
      list.push_back(std::move(pair));
    }
    const bool none = list.is_null();
    add(key, "list of pairs of lengths or forces", std::move(list), none);
    return !none;
  }

  bool file(const Key& key, std::string_view /*other*/,
            const std::function<void(const std::string&)>& /*read*/) override {
    add(key, "name of a file", {}, true);
    return false;  // its content is listed instead
  }

  void tables(const Key& key, std::size_t count,
              const std::function<void(CaseVisitor&, std::size_t)>& describe) override {
    if (inherits_ && count == 0) add(key, "list of tables", Json::array());
    // An empty list lists one table, to show its keys.
    for (std::size_t i = 0; i < std::max(count, std::size_t{1}); ++i) {
      std::vector<ListedKey>& list = path_.empty() ? list_ : tables_;
      KeyLister inner(list);
      const std::string path = fmt::format("{}[{}]", path_of(key), i + 1);
      inner.path_ = path + '.';
      inner.held_ = held_ && i < count;
      inner.live_ = live_ && i < count;
      list.push_back({path, key, {}, {}, inner.held_, inner.live_, false});
      describe(inner, i);
      list.insert(list.end(), inner.tables_.begin(), inner.tables_.end());
    }
  }

  [[nodiscard]] bool replaces(const Key& /*key*/) const override { return false; }

  void table(const Key& key, bool given, const std::function<void(CaseVisitor&)>& describe) override {
    KeyLister inner(list_);
    inner.path_ = path_of(key) + '.';
    const bool inherits = key.presence == Presence::inherited;
    inner.held_ = held_ && (given || (key.presence != Presence::optional && !inherits));
    inner.live_ = live_ && (given || key.presence == Presence::required);
    list_.push_back({path_of(key), key, {}, {}, inner.held_, inner.live_, false});
    if (inherits && !given) return;  // its keys are those of the other table
    inner.inherits_ = inherits;
    describe(inner);
    list_.insert(list_.end(), inner.tables_.begin(), inner.tables_.end());
  }

 private:
  [[nodiscard]] std::string path_of(const Key& key) const { return path_ + std::string(key.name); }

  ListedKey& add(const Key& key, std::string kind, Json value, bool instead = false) {
    // Missing values are inherited, so an empty list must be written explicitly.
    if (inherits_ && value.is_null() && kind.starts_with("list of")) value = Json::array();
    const bool there = !value.is_null();
    instead = instead || key.instead;
    return list_.emplace_back(ListedKey{path_of(key), key, std::move(kind), std::move(value), held_ && there,
                                        live_ && there && !instead && !key.left_open, instead});
  }

  std::vector<ListedKey>& list_;
  std::vector<ListedKey> tables_{};  ///< tables of lists: in a case file they follow all other keys of their table
  std::string path_{};
  bool held_{true};
  bool live_{true};
  bool inherits_{};  ///< missing values are inherited from another table
};

}  // namespace

bool ListedKey::holds_number() const {
  const std::string one = kind.substr(0, kind.find(','));
  if (key.dimension) return name_of(*key.dimension).ends_with(" " + one);
  return kind == "number" || kind == "whole number" || is_either();
}

std::vector<ListedKey> list_keys(const Case& input) {
  std::vector<ListedKey> list;
  KeyLister lister(list);
  Case copy = input;
  describe(lister, copy);
  return list;
}

std::vector<ListedKey> list_keys() {
  Case none;  // not Case{}: g++ 12 warns that members of an aggregate may be destroyed before they are initialised
  return list_keys(none);
}

const ListedKey* find_key(const std::vector<ListedKey>& keys, std::string_view path) {
  const auto exact = std::find_if(keys.begin(), keys.end(), [&](const ListedKey& one) { return one.path == path; });
  if (exact != keys.end()) return &*exact;
  const auto like = std::find_if(keys.begin(), keys.end(), [name = without_counts(path)](const ListedKey& one) {
    return without_counts(one.path) == name;
  });
  if (like != keys.end()) return &*like;
  // A table of differences has the keys of its original: "pad[2].bump_foil.height" is like "bump_foil.height".
  for (const ListedKey& one : keys) {
    const std::string begin = without_counts(one.path) + '.';
    if (one.key.presence != Presence::inherited || !without_counts(path).starts_with(begin)) continue;
    const std::string_view table = one.key.name;
    return find_key(keys, fmt::format("{}.{}", table, without_counts(path).substr(begin.size())));
  }
  return nullptr;
}

std::string advice_on_number(const std::vector<ListedKey>& keys, const std::string& path) {
  std::vector<std::string> paths;
  for (const ListedKey& one : keys) {
    if (one.holds_number()) paths.push_back(one.path);
  }
  std::vector<std::string> likely = keys_with_words(path, paths);
  if (const auto nearest = nearest_name(path, paths); likely.empty() && nearest) likely = {*nearest};
  return likely.empty() ? "`bumpfoil init --keys` lists them" : did_you_mean(likely);
}

std::string without_counts(std::string_view path) {
  std::string name;
  bool counted = false;
  for (const char c : path) {
    if (c == '[') counted = true;
    if (!counted) name += c;
    if (c == ']') counted = false;
  }
  return name;
}

std::string table_header(std::string_view table) {
  const std::string name = without_counts(table);
  return table.ends_with(']') ? fmt::format("[[{}]]", name) : fmt::format("[{}]", name);
}

std::string toml_of(const Json& value) {
  // JSON texts are also TOML texts, as the delete character is escaped.
  if (!value.is_object()) return dump_json(value, -1);
  std::string members;
  for (const auto& [key, member] : value.items()) {
    members += fmt::format("{} {} = {}", members.empty() ? "" : ",", key, dump_json(member, -1));
  }
  return fmt::format("{{{} }}", members);
}

std::string example_of(const ListedKey& listed) {
  const std::string_view example = listed.key.example;
  if (example.empty()) return toml_of(listed.value);
  return listed.key.dimension && !example.starts_with('[') ? fmt::format("\"{}\"", example) : std::string(example);
}

std::string default_of(const ListedKey& reference, const ListedKey& unset) {
  return reference.value == unset.value ? example_of(reference) : toml_of(unset.value);
}

std::string authored_value(const ListedKey& listed) {
  const std::string_view example = listed.key.example;
  if (!listed.key.dimension || example.empty()) return toml_of(listed.value);
  // "mm" of "4.572 mm", "N" of ["5 N", "10 N"]. Names of directions have no unit.
  const std::size_t space = std::min(example.find(' '), example.size() - 1);
  const std::string_view unit = example.substr(space + 1, example.find('"', space + 1) - space - 1);
  if (unit.empty()) return example_of(listed);
  const double one = std::get<double>(parse_quantity(fmt::format("1 {}", unit), *listed.key.dimension));
  return in_unit(listed.value, unit, one);
}

}  // namespace bumpfoil
