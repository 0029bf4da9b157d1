#include "case/value_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/toml_document.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

constexpr std::array axis_names{NamedNumber{"+X", 0.0}, NamedNumber{"+Y", 0.5 * std::numbers::pi},
                                NamedNumber{"-X", std::numbers::pi}, NamedNumber{"-Y", 1.5 * std::numbers::pi}};

/// Plausible upper limit of lengths of bearings, m.
constexpr double likely_length = 0.3;

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

/// What to add to "write a number" where the value met is in quotes. On the command line a text needs none, and has
/// none.
std::string_view without_quotes(const toml::node& node) {
  return node.is_string() && !is_override(node) ? " without quotes" : "";
}

/// Advice for a value that is not a number, such as "0,2".
std::string number_advice(const toml::node& node) {
  std::string text = node.value_or(std::string());
  const std::size_t comma = text.find(',');
  double number = 0.0;
  if (comma != std::string::npos) {
    text[comma] = '.';
    const auto [end, status] = read_number(text, number);
    if (status == std::errc{} && end == text.data() + text.size()) return "write a decimal point: " + text;
  }
  return fmt::format("write a number{}, such as 0.1", without_quotes(node));
}

constexpr Dimension controlled_dimension(Control control) {
  return control == Control::displacement ? Dimension::length : Dimension::force;
}

}  // namespace

std::string is_where(const toml::node& node, std::string_view due) {
  // A value on the command line that is not TOML is an implicit string: messages do not call it one.
  if (node.is_string() && is_override(node)) return fmt::format("is not {}", due);
  return fmt::format("is {}, expected {}", kind_of(node), due);
}

void ValueReader::refuse(std::string_view due, std::string advice) const {
  log.error(path, is_where(node, due), std::move(advice));
}

void ValueReader::operator()(std::string* value) const {
  if (const auto* text = node.as_string()) {
    *value = text->get();
  } else {
    refuse("a text", "write it in quotes");
  }
}

void ValueReader::operator()(bool* value) const {
  if (const auto* flag = node.as_boolean()) {
    *value = flag->get();
  } else {
    refuse("true or false", fmt::format("write true or false{}", without_quotes(node)));
  }
}

void ValueReader::operator()(int* value) const {
  const auto* number = node.as_integer();
  if (number == nullptr) {
    refuse("a whole number", fmt::format("write a whole number{}, such as 26", without_quotes(node)));
  } else if (number->get() < std::numeric_limits<int>::min() || number->get() > std::numeric_limits<int>::max()) {
    log.error(path, "is out of range", number->get() > 0 ? "give a smaller number" : "give a larger number");
  } else {
    *value = static_cast<int>(number->get());
  }
}

void ValueReader::operator()(double* value) const {
  std::optional<double> number;
  (*this)(&number);
  if (number) *value = *number;
}

void ValueReader::operator()(std::optional<double>* value) const {
  if (node.is_number()) {
    *value = node.value<double>();
    const double size = std::abs(**value);
    if (dimension == Dimension::angle && size > 2.0 * std::numbers::pi) {
      log.met_unlikely(path, "numbers are radians: write \"{} deg\" if degrees are meant");
    } else if (dimension == Dimension::length && size > likely_length) {
      log.met_unlikely(path, "numbers are metres: write a unit if that is not meant, \"{} mm\"");
    }
  } else if (!dimension) {
    refuse("a number", number_advice(node));
  } else if (const auto* text = node.as_string()) {
    const auto quantity = parse_quantity(text->get(), *dimension);
    if (const auto* error = std::get_if<QuantityError>(&quantity)) {
      log.error(path, error->what, error->advice + alternatives);
    } else {
      *value = std::get<double>(quantity);
    }
  } else {
    refuse(name_of(*dimension), fmt::format("write a text with a unit, for example {}, or a number in {}{}",
                                            example_quantity(*dimension), si_unit(*dimension), alternatives));
  }
}

void ValueReader::operator()(PerBump* value) const {
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

void ValueReader::operator()(FormedRadius* value) const {
  constexpr std::string_view seated = name_of(FormedTo::seated);
  if (node.value_or(std::string()) == seated) {
    *value = {FormedTo::seated};
    return;
  }
  std::optional<double> radius;
  ValueReader{log, path, node, dimension, fmt::format(", or \"{}\"", seated)}(&radius);
  if (radius) *value = {FormedTo::radius, *radius};
}

void ValueReader::operator()(std::vector<double>* value) const {
  read_list(*value, {});
}

void ValueReader::operator()(std::vector<std::string>* value) const {
  const auto* list = node.as_array();
  if (list == nullptr && !node.is_string()) return refuse("a text or a list of texts", "write each in quotes");
  const std::size_t count = list == nullptr ? 1 : list->size();
  if (count > static_cast<std::size_t>(most_texts)) {
    return log.error(path, fmt::format("has {} entries", count), fmt::format("give at most {}", most_texts));
  }
  value->assign(count, {});
  for (std::size_t i = 0; i < count; ++i) {
    const toml::node& entry = list == nullptr ? node : *list->get(i);
    const std::string entry_path = fmt::format("{}[{}]", path, i + 1);
    log.met(entry_path, entry);
    ValueReader{log, entry_path, entry}(&(*value)[i]);
  }
}

void ValueReader::directions(std::vector<double>& angles) const {
  read_list(angles, axis_names);
}

void ValueReader::read_list(std::vector<double>& values, std::span<const NamedNumber> names) const {
  const auto* list = node.as_array();
  if (list == nullptr) {
    const std::string_view example = dimension ? example_quantity(*dimension) : "0.5";
    return refuse("a list", fmt::format("write a list in brackets: [{}]", names.empty() ? example : "\"+X\""));
  }
  if (list->size() > static_cast<std::size_t>(most_bumps)) {
    return log.error(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_bumps));
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

std::optional<Control> control_of(const toml::node& node) {
  const auto* text = node.as_string();
  if (text == nullptr) return std::nullopt;
  for (const Control control : {Control::displacement, Control::load}) {
    if (std::holds_alternative<double>(parse_quantity(text->get(), controlled_dimension(control)))) return control;
  }
  return std::nullopt;
}

void read_target(ReadingLog& log, const std::string& path, const toml::node& node, Control control, double& value) {
  const Control other = control == Control::displacement ? Control::load : Control::displacement;
  ValueReader{log, path, node, controlled_dimension(control),
              fmt::format(", or {}", example_quantity(controlled_dimension(other)))}(&value);
}

const toml::array* plane_vector(ReadingLog& log, const std::string& path, const toml::node& node,
                                std::string_view example) {
  const auto* list = node.as_array();
  if (list != nullptr && list->size() == 2) return list;
  log.error(path, list == nullptr ? is_where(node, "a list") : fmt::format("has {} entries", list->size()),
            fmt::format("give two, along X and Y: {}", example));
  return nullptr;
}

std::optional<PlaneTarget> read_place(ReadingLog& log, const std::string& path, const toml::node& node, Control plain,
                                      std::string_view example) {
  const toml::array* list = plane_vector(log, path, node, example);
  if (list == nullptr) return std::nullopt;
  std::optional<Control> control;
  for (const toml::node& entry : *list) {
    const std::optional<Control> met = control_of(entry);
    if (met && control.value_or(*met) != *met) {
      log.error(path, "mixes a displacement and a load", "give two lengths or two forces");
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

void read_places(ReadingLog& log, const std::string& path, const toml::node& node, std::string_view example,
                 PathPoints& points) {
  const auto* list = node.as_array();
  if (list == nullptr || list->empty()) {
    return log.error(path, list == nullptr ? is_where(node, "a list") : "is empty",
                     fmt::format("give pairs along X and Y: {}", example));
  }
  if (list->size() > static_cast<std::size_t>(most_points)) {
    return log.error(path, fmt::format("has {} entries", list->size()), fmt::format("give at most {}", most_points));
  }
  PathPoints read;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string entry_path = fmt::format("{}[{}]", path, i + 1);
    const toml::node& entry = *list->get(i);
    log.met(entry_path, entry);
    const auto place = read_place(log, entry_path, entry, read.control, "[\"0 um\", \"-40 um\"]");
    if (!place) return;
    if (i > 0 && place->control != read.control) {
      return log.error(entry_path, "mixes displacements and loads", "give lengths only, or forces only");
    }
    read.control = place->control;
    read.values.push_back(place->value);
  }
  points = std::move(read);
}

}  // namespace bumpfoil
