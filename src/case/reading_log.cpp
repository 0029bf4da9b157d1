#include "case/reading_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <tuple>

#include "case/toml_document.hpp"

namespace bumpfoil {
namespace {

/// Further errors are counted, not listed.
constexpr std::size_t most_faults = 50;

/// The parent of a key: "bump_foil.truss" for "bump_foil.truss.k1", "x" for "x[3]"; empty for a key of the root.
std::string holder_of(const std::string& key) {
  const std::size_t end = key.back() == ']' ? key.rfind('[') : key.rfind('.');
  return end == std::string::npos ? std::string() : key.substr(0, end);
}

/// The value as written, truncated for messages; empty for lists and tables.
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

}  // namespace

void ReadingLog::met(const std::string& key, const toml::node& node) {
  const toml::source_region& source = node.source();
  const bool implied = source.begin.line == 0;  // a table created by an override
  const bool overridden = implied || is_override(node);
  Origin origin{overridden ? std::string(command_line) : file_, overridden ? 0 : source.begin.line, written(node)};
  origin.implied = implied;
  origins_.insert_or_assign(key, std::move(origin));
}

const Origin* ReadingLog::place_of(const std::string& key) const {
  for (std::string holder = key; !holder.empty(); holder = holder_of(holder)) {
    if (const auto origin = origins_.find(holder); origin != origins_.end()) return &origin->second;
  }
  return nullptr;
}

void ReadingLog::fault(const std::string& key, std::string what, std::string advice) {
  if (!faulty_.insert(key).second) return;  // already reported when read for another key
  const Origin* place = place_of(key);
  const auto exact = origins_.find(key);
  add({place != nullptr ? place->file : file_, place != nullptr ? place->line : 0, key,
       exact != origins_.end() ? exact->second.written : std::string(), std::move(what), std::move(advice)});
}

void ReadingLog::later_fault(const Fault& fault) {
  Fault placed = fault;
  if (const auto other = taken_from_.find(fault.key); other != taken_from_.end()) {
    placed.key = other->second;
    if (checked_.contains(placed.key)) return;
  }
  for (std::string holder = placed.key; !holder.empty(); holder = holder_of(holder)) {
    if (faulty_.contains(holder)) return;
  }
  checked_.insert(placed.key);
  const Origin* place = place_of(placed.key);
  if (place != nullptr && place->implied) place = nullptr;  // missing in the file, regardless of overrides
  placed.file = place != nullptr ? place->file : file_;
  placed.line = place != nullptr ? place->line : 0;
  const auto exact = origins_.find(placed.key);
  if (exact != origins_.end() && !exact->second.written.empty()) placed.value = exact->second.written;
  if (exact != origins_.end() && !exact->second.unit_hint.empty()) {
    placed.advice += "; " + fmt::format(fmt::runtime(exact->second.unit_hint), placed.value);
  }
  add(std::move(placed));
}

bool ReadingLog::is_sound_but_for(const std::string& table) const {
  return std::all_of(faults_.begin(), faults_.end(),
                     [&](const Fault& fault) { return fault.key.starts_with(table + '.'); });
}

bool ReadingLog::blames(const std::string& key) const {
  return std::any_of(faults_.begin(), faults_.end(), [&](const Fault& fault) { return fault.key.starts_with(key); });
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
    faults_.push_back({file_, 0, "", "", fmt::format("and {} more errors", unlisted_), "fix the first ones"});
  }
  throw Error(input_fault_ ? ErrorKind::input : ErrorKind::file, std::move(faults_));
}

}  // namespace bumpfoil
