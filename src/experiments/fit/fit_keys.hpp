#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"
#include "case/case_keys.hpp"
#include "case/units.hpp"

namespace bumpfoil {

/// Whether a key holds a real number that can be fitted.
bool is_fitted_key(const std::string& key);

/// Advice on a key that cannot be fitted.
std::string advice_on_fitted(const std::string& key);

/// Absent for plain numbers, and for unknown keys.
std::optional<Dimension> dimension_of(const std::string& key);

/// A key that holds a number in the unit of another, such as a bound of its values; in any unit if that key is unknown.
Key key_in_unit_of(const std::string& other, std::string_view name, Presence presence, std::string_view title,
                   std::string_view text, std::string_view example);

/// Number from 1 of the data whose rig has this key; absent for other keys.
std::optional<std::size_t> data_of_key(std::string_view key);

/// Whether the key belongs to the rig, not to the case.
inline bool is_of_rig(std::string_view key) {
  return key.starts_with("fit.");
}

/// The keys that case_to_toml() writes for a fitted one: it separates friction by interface.
std::vector<std::string> keys_set_by(const std::string& key);

/// Numbers of a rig by their keys, except the stiffness of the machine, which may be absent.
std::span<const std::pair<std::string_view, double Rig::*>> rig_numbers();

/// Sets a key of the rig. @pre  is_of_rig(key)
void set_rig(FitSettings& fit, std::string_view key, double value);

}  // namespace bumpfoil
