#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "case/key_list.hpp"
#include "core/number_text.hpp"
#include "experiments/fit/fit_keys.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view begin_of_data = "fit.data[";
constexpr std::string_view common_friction = "friction.coefficient";
constexpr std::string_view common_machine = "fit.machine_stiffness";

constexpr std::array numbers_of_rigs{std::pair{std::string_view("displacement_origin"), &Rig::displacement_origin},
                                     std::pair{std::string_view("force_origin"), &Rig::force_origin},
                                     std::pair{std::string_view("displacement_drift"), &Rig::displacement_drift},
                                     std::pair{std::string_view("force_drift"), &Rig::force_drift},
                                     std::pair{std::string_view("x_origin"), &Rig::x_origin},
                                     std::pair{std::string_view("y_origin"), &Rig::y_origin},
                                     std::pair{std::string_view("torque_origin"), &Rig::torque_origin}};

/// "force_origin" for "fit.data[1].force_origin".
std::string_view name_in_data(std::string_view key) {
  return key.substr(std::min(key.size(), key.find("].") + 2));
}

bool is_rig_key(std::string_view key) {
  if (key == common_machine) return true;
  const std::string_view name = name_in_data(key);
  return data_of_key(key) &&
         (name == "machine_stiffness" || std::any_of(numbers_of_rigs.begin(), numbers_of_rigs.end(),
                                                     [name](const auto& one) { return one.first == name; }));
}

/// Keys of a case without a fit: fit descriptions may look them up.
const std::vector<ListedKey>& keys_of_cases() {
  static const std::vector<ListedKey> keys = list_keys();
  return keys;
}

}  // namespace

bool is_fitted_key(const std::string& key) {
  if (is_of_rig(key)) return is_rig_key(key);
  const ListedKey* const listed = find_key(keys_of_cases(), key);
  if (key.ends_with(".diameter")) return false;  // cases are written with radii
  return listed != nullptr && listed->holds_number() && listed->kind != "whole number" && !listed->is_either();
}

std::string advice_on_fitted(const std::string& key) {
  return find_key(keys_of_cases(), key) == nullptr ? advice_on_number(keys_of_cases(), key)
                                                   : "give a key of the bearing, its foils, their friction or the rig";
}

std::optional<Dimension> dimension_of(const std::string& key) {
  const ListedKey* const listed = find_key(keys_of_cases(), key);
  return listed == nullptr ? std::nullopt : listed->key.dimension;
}

Key key_in_unit_of(const std::string& other, std::string_view name, Presence presence, std::string_view title,
                   std::string_view text, std::string_view example) {
  const bool known = !other.empty() && is_fitted_key(other);  // key names stay empty while keys_of_cases() is listed
  return {.name = name,
          .presence = presence,
          .title = title,
          .text = text,
          .example = example,
          .dimension = known ? dimension_of(other) : std::nullopt,
          .any_dimension = !known};
}

std::optional<std::size_t> data_of_key(std::string_view key) {
  if (!key.starts_with(begin_of_data)) return std::nullopt;
  std::size_t number = 0;
  read_number(key.substr(begin_of_data.size()), number);
  return number;
}

std::vector<std::string> keys_set_by(const std::string& key) {
  if (is_of_rig(key)) return {};
  if (!key.ends_with(common_friction)) return {key};
  const std::string table = key.substr(0, key.size() - common_friction.size());
  return {table + "friction.top_bump", table + "friction.bump_sleeve"};
}

std::span<const std::pair<std::string_view, double Rig::*>> rig_numbers() {
  return numbers_of_rigs;
}

void set_rig(FitSettings& fit, std::string_view key, double value) {
  if (key == common_machine) {
    fit.machine_stiffness = value;
    return;
  }
  Rig& rig = fit.data[*data_of_key(key) - 1].rig;
  const std::string_view name = name_in_data(key);
  for (const auto& [known, member] : numbers_of_rigs) {
    if (known == name) rig.*member = value;
  }
  if (name == "machine_stiffness") rig.machine_stiffness = value;
}

}  // namespace bumpfoil
