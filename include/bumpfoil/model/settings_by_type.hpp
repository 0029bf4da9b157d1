#pragma once

#include <any>
#include <map>
#include <string_view>
#include <typeindex>
#include <utility>

namespace bumpfoil {

/// Settings of some type, which can be copied and compared.
struct AnySettings {
  std::any value;
  bool (*equal)(const std::any&, const std::any&);

  bool operator==(const AnySettings& other) const { return equal(value, other.value); }
};

/// @throws Error (input): the table of the case file is missing.
[[noreturn]] void throw_missing_table(std::string_view table);

/// Settings of experiments, at most one of each type. A case holds them without knowing their types, which stay in the
/// folders of their experiments. A type names its table of the case file: Settings::table.
class SettingsByType {
 public:
  /// Those of a type; null where there are none.
  template <typename Settings>
  [[nodiscard]] const Settings* find() const {
    const auto found = held_.find(typeid(Settings));
    return found == held_.end() ? nullptr : std::any_cast<Settings>(&found->second.value);
  }

  template <typename Settings>
  [[nodiscard]] Settings* find() {
    return const_cast<Settings*>(std::as_const(*this).find<Settings>());
  }

  /// Those of a type: `input.settings.get<CycleSettings>().steps = 50`.
  /// @throws Error (input) where there are none: the table is missing
  template <typename Settings>
  [[nodiscard]] const Settings& get() const {
    const Settings* const held = find<Settings>();
    if (held == nullptr) throw_missing_table(Settings::table);
    return *held;
  }

  template <typename Settings>
  [[nodiscard]] Settings& get() {
    return const_cast<Settings&>(std::as_const(*this).get<Settings>());
  }

  /// Those of a type, default ones where there are none yet.
  template <typename Settings>
  Settings& get_or_create() {
    Settings* const held = find<Settings>();
    return held == nullptr ? set(Settings{}) : *held;
  }

  template <typename Settings>
  void remove() {
    held_.erase(typeid(Settings));
  }

  /// Removes those of all other types.
  template <typename Settings>
  void keep_only() {
    std::erase_if(held_, [](const auto& one) { return one.first != typeid(Settings); });
  }

  /// Keeps these in place of any others of their type.
  /// @return what is kept, to be changed there
  template <typename Settings>
  Settings& set(Settings settings) {
    const auto equal = [](const std::any& a, const std::any& b) {
      return *std::any_cast<Settings>(&a) == *std::any_cast<Settings>(&b);
    };
    const auto place = held_.insert_or_assign(typeid(Settings), AnySettings{std::move(settings), equal}).first;
    return *std::any_cast<Settings>(&place->second.value);
  }

  bool operator==(const SettingsByType&) const = default;

 private:
  std::map<std::type_index, AnySettings> held_;
};

}  // namespace bumpfoil
